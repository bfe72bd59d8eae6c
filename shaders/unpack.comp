#version 450
#extension GL_EXT_samplerless_texture_functions : require
// Unpacks a multisampled image into a buffer: one invocation a pixel, row-major, samples then components, in stores of
// four words (samples × components is a multiple of four).
// UNSIGNED: the image is of unsigned integers; else of floats, whose bits are stored.

layout(local_size_x = 16, local_size_y = 4) in;
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
  uvec4 words[];
};
layout(push_constant) uniform Band {
  int firstRow, rows, width;  // of the image; the buffer begins with firstRow
} band;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (pixel.x >= band.width || pixel.y >= band.rows) return;
  int word = (pixel.y * band.width + pixel.x) * (kSamples * kComponents / 4);
  pixel.y += band.firstRow;
#define SAMPLE(s) BITS(texelFetch(image, pixel, (s)))
  if (kComponents == 1) {
    for (int s = 0; s < kSamples; s += 4) {
      words[word++] = uvec4(SAMPLE(s).x, SAMPLE(s + 1).x, SAMPLE(s + 2).x, SAMPLE(s + 3).x);
    }
  } else if (kComponents == 2) {
    for (int s = 0; s < kSamples; s += 2) words[word++] = uvec4(SAMPLE(s).xy, SAMPLE(s + 1).xy);
  } else if (kComponents == 3) {
    for (int s = 0; s < kSamples; s += 4) {
      uvec4 b = SAMPLE(s + 1), c = SAMPLE(s + 2);
      words[word++] = uvec4(SAMPLE(s).xyz, b.x);
      words[word++] = uvec4(b.yz, c.xy);
      words[word++] = uvec4(c.z, SAMPLE(s + 3).xyz);
    }
  } else {
    for (int s = 0; s < kSamples; ++s) words[word++] = SAMPLE(s);
  }
}
