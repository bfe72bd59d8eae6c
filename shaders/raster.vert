#version 450
// Passes clip positions and VARYINGS inputs through untouched, so that everything measured happens in fixed function.
// With PRIMITIVE_FROM_VERTEX (a device without gl_PrimitiveID in fragment shaders) each vertex also carries the number
// of the primitive it provokes; vertices are not indexed then.

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

#ifdef PRIMITIVE_FROM_VERTEX
layout(push_constant) uniform DrawConstants {
  uint firstPrimitive;
  uint verticesPerPrimitive;  // 3: list, 1: strip and fan
  uint firstProvoking;        // the vertex that provokes primitive 0 (list: 0)
} draw;
layout(location = 6) flat out uint primitiveNumber;
#endif

// The same draws run once a pass when a scene has more planes than a device has attachments.
invariant gl_Position;

void main() {
  gl_Position = position;
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
