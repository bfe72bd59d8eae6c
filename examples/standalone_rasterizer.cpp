// The reference rasterizer on its own, without Vulkan: a triangle with an edge through pixel centres, as text.
#include <cstdio>

#include "rasterizer/render.hpp"

int main() {
  using namespace rasterdiff;

  Scene scene;
  scene.name = "example";
  scene.target.width = scene.target.height = 8;
  scene.viewport = {0, 0, 8, 8, 0, 1};
  Draw draw;
  draw.positions = {{-0.875F, -0.875F, 0, 1}, {0.875F, -0.875F, 0, 1}, {-0.875F, 0.875F, 0, 1}};  // clip space
  scene.draws.push_back(draw);

  const Result<rasterizer::Rules> rules = rasterizer::Rules::profile("reference", Limits{});
  rasterizer::RuleCounts counts;
  const Result<Frame> frame = rasterizer::render(scene, *rules, &counts);
  if (!frame) {
    std::fprintf(stderr, "%s: %s\n", frame.error().where.c_str(), frame.error().what.c_str());
    return 1;
  }
  for (uint32_t y = 0; y < frame->height; ++y) {
    for (uint32_t x = 0; x < frame->width; ++x) std::putchar(frame->primitive.at(x, y, 0) != 0 ? '#' : '.');
    std::putchar('\n');
  }
  std::printf("%llu samples lay exactly on an edge\n",
              static_cast<unsigned long long>(counts[rasterizer::Rule::TieBreak]));
}
