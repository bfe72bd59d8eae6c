#version 450
#extension GL_EXT_samplerless_texture_functions : require
// Unpacks a multisampled image into a buffer: one invocation a pixel, row-major, samples then components.
// UNSIGNED: the image is of unsigned integers; else of floats, whose bits are stored.

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const int kSamples = 4;
layout(constant_id = 1) const int kComponents = 1;

#ifdef UNSIGNED
layout(set = 0, binding = 0) uniform utexture2DMS image;
#define BITS(value) (value)
#else
layout(set = 0, binding = 0) uniform texture2DMS image;
#define BITS(value) floatBitsToUint(value)
#endif
layout(set = 0, binding = 1, std430) writeonly buffer Words {
  uint words[];
};
layout(push_constant) uniform Band {
  int firstRow, rows, width;  // of the image; the buffer begins with firstRow
} band;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (pixel.x >= band.width || pixel.y >= band.rows) return;
  int word = (pixel.y * band.width + pixel.x) * (kSamples * kComponents);
  for (int s = 0; s < kSamples; ++s) {
    uvec4 value = BITS(texelFetch(image, pixel + ivec2(0, band.firstRow), s));
    for (int c = 0; c < kComponents; ++c) words[word + s * kComponents + c] = value[c];
  }
}
