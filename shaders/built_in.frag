#version 450
// Writes VALUE, four components made of one built-in: a module a built-in, because the mere presence of SampleId or SamplePosition
// changes how often a fragment shader runs.
// MASK_CONSTANT or MASK_SHIFTED: the sample mask is an output too, as in raster.frag.
// ALPHA: output 0 takes the first varying, whose alpha makes coverage, and the built-in comes after it.

#ifdef ALPHA
layout(location = 0) in vec4 in0;
layout(location = 0) out vec4 alpha;
layout(location = 1) out vec4 value;
#else
layout(location = 0) out vec4 value;
#endif

#if defined(MASK_CONSTANT) || defined(MASK_SHIFTED)
layout(push_constant) uniform DrawConstants {
  layout(offset = 16) uint shaderSampleMaskBits;
} draw;
#endif

void main() {
#ifdef MASK_CONSTANT
  gl_SampleMask[0] = int(draw.shaderSampleMaskBits);
#endif
#ifdef MASK_SHIFTED
  gl_SampleMask[0] = (gl_SampleMaskIn[0] << 1) & int(draw.shaderSampleMaskBits);
#endif
#ifdef ALPHA
  alpha = in0;
#endif
  value = VALUE;
}
