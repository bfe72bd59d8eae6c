#version 450
// Writes what reached the fragment, once a fragment, so that the values land in all samples it covers.
// PRIMITIVE_BUILTIN or PRIMITIVE_FROM_VERTEX: attachment 0 takes 1 + the primitive's number, attachment 1 takes 1
// (blended by addition into a count), varyings follow; with neither, varyings alone.
// MASK_CONSTANT or MASK_SHIFTED: the sample mask is an output too.
// Inputs are undecorated here: interpolations are put on them when a pipeline is made. Outputs have four components even
// where an attachment has one: smooth lines multiply alpha into them, and a driver may not look whether there is any.

#if defined(PRIMITIVE_BUILTIN) || defined(PRIMITIVE_FROM_VERTEX)
#define FIRST_VALUE 2
layout(location = 0) out uvec4 primitive;
layout(location = 1) out vec4 written;
#else
#define FIRST_VALUE 0
#endif

#if defined(PRIMITIVE_BUILTIN) || defined(MASK_CONSTANT) || defined(MASK_SHIFTED)
layout(push_constant) uniform DrawConstants {
  layout(offset = 0) uint firstPrimitive;
  layout(offset = 16) uint shaderSampleMaskBits;
} draw;
#endif
#ifdef PRIMITIVE_FROM_VERTEX
layout(location = 6) flat in uint primitiveNumber;
#endif

#if VARYINGS > 0
layout(location = 0) in vec4 in0;
layout(location = FIRST_VALUE) out vec4 out0;
#endif
#if VARYINGS > 1
layout(location = 1) in vec4 in1;
layout(location = FIRST_VALUE + 1) out vec4 out1;
#endif
#if VARYINGS > 2
layout(location = 2) in vec4 in2;
layout(location = FIRST_VALUE + 2) out vec4 out2;
#endif
#if VARYINGS > 3
layout(location = 3) in vec4 in3;
layout(location = FIRST_VALUE + 3) out vec4 out3;
#endif
#if VARYINGS > 4
layout(location = 4) in vec4 in4;
layout(location = FIRST_VALUE + 4) out vec4 out4;
#endif
#if VARYINGS > 5
layout(location = 5) in vec4 in5;
layout(location = FIRST_VALUE + 5) out vec4 out5;
#endif

void main() {
#ifdef MASK_CONSTANT
  gl_SampleMask[0] = int(draw.shaderSampleMaskBits);
#endif
#ifdef MASK_SHIFTED
  gl_SampleMask[0] = (gl_SampleMaskIn[0] << 1) & int(draw.shaderSampleMaskBits);
#endif
#ifdef PRIMITIVE_BUILTIN
  primitive = uvec4(draw.firstPrimitive + uint(gl_PrimitiveID) + 1u);
  written = vec4(1.0);
#endif
#ifdef PRIMITIVE_FROM_VERTEX
  primitive = uvec4(primitiveNumber + 1u);
  written = vec4(1.0);
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
}
