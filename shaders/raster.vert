#version 450
#ifdef VIEWPORT_INDEX
#extension GL_ARB_shader_viewport_layer_array : require
#endif
// Passes clip positions and VARYINGS inputs through untouched, so that everything measured happens in fixed function.
// With PRIMITIVE_FROM_VERTEX (a device without gl_PrimitiveID in fragment shaders) each vertex also carries the number
// of the primitive it provokes; vertices are not indexed then.
// POINT_SIZE, CLIP_DISTANCES, CULL_DISTANCES and VIEWPORT_INDEX each pass one more value through. The numbers of distances
// are specialization constants; an input that a pipeline has no array for is bound to any other array and not used.

layout(location = 0) in vec4 position;
#if VARYINGS > 0
layout(location = 1) in vec4 in0;
layout(location = 0) out vec4 out0;
#endif
#if VARYINGS > 1
layout(location = 2) in vec4 in1;
layout(location = 1) out vec4 out1;
#endif
#if VARYINGS > 2
layout(location = 3) in vec4 in2;
layout(location = 2) out vec4 out2;
#endif
#if VARYINGS > 3
layout(location = 4) in vec4 in3;
layout(location = 3) out vec4 out3;
#endif
#if VARYINGS > 4
layout(location = 5) in vec4 in4;
layout(location = 4) out vec4 out4;
#endif
#if VARYINGS > 5
layout(location = 6) in vec4 in5;
layout(location = 5) out vec4 out5;
#endif

#ifdef POINT_SIZE
layout(location = 7) in float pointSize;
#endif
#ifdef CLIP_DISTANCES
layout(constant_id = 0) const int kClipDistances = 1;
layout(location = 8) in vec4 firstClipDistances;
layout(location = 9) in vec4 furtherClipDistances;
out float gl_ClipDistance[kClipDistances];
#endif
#ifdef CULL_DISTANCES
layout(constant_id = 1) const int kCullDistances = 1;
layout(location = 10) in vec4 firstCullDistances;
layout(location = 11) in vec4 furtherCullDistances;
out float gl_CullDistance[kCullDistances];
#endif

#if defined(PRIMITIVE_FROM_VERTEX) || defined(VIEWPORT_INDEX)
layout(push_constant) uniform DrawConstants {
  uint firstPrimitive;
  uint verticesPerPrimitive;  // of a list; 1: strip and fan
  uint firstProvoking;        // the vertex that provokes the draw's first primitive (list: its first vertex)
  uint viewportIndex;
} draw;
#endif
#ifdef PRIMITIVE_FROM_VERTEX
layout(location = 6) flat out uint primitiveNumber;
#endif

// The same draws run once a pass when a scene has more planes than a device has attachments.
invariant gl_Position;

void main() {
  gl_Position = position;
#ifdef POINT_SIZE
  gl_PointSize = pointSize;
#endif
#ifdef CLIP_DISTANCES
  for (int i = 0; i < kClipDistances; ++i) {
    gl_ClipDistance[i] = i < 4 ? firstClipDistances[i] : furtherClipDistances[i - 4];
  }
#endif
#ifdef CULL_DISTANCES
  for (int i = 0; i < kCullDistances; ++i) {
    gl_CullDistance[i] = i < 4 ? firstCullDistances[i] : furtherCullDistances[i - 4];
  }
#endif
#ifdef VIEWPORT_INDEX
  gl_ViewportIndex = int(draw.viewportIndex);
#endif
#if VARYINGS > 0
  out0 = in0;
#endif
#if VARYINGS > 1
  out1 = in1;
#endif
#if VARYINGS > 2
  out2 = in2;
#endif
#if VARYINGS > 3
  out3 = in3;
#endif
#if VARYINGS > 4
  out4 = in4;
#endif
#if VARYINGS > 5
  out5 = in5;
#endif
#ifdef PRIMITIVE_FROM_VERTEX
  primitiveNumber = draw.firstPrimitive + (uint(gl_VertexIndex) - draw.firstProvoking) / draw.verticesPerPrimitive;
#endif
}
