// Indexed draws: order, reuse, repetition and incomplete tails. [vk:drawing-primitive-topologies]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene corners(std::vector<uint32_t> indices) {
  Scene scene = square(32);
  draw(scene, {{4.5, 4.5}, {28.5, 6.5}, {26.5, 28.5}, {6.5, 26.5}, {16.5, 12.5}}).indices = std::move(indices);
  return scene;
}

}  // namespace

void addIndexed(Entries& entries) {
  Family family(entries, "indexed");
  family.add("reuse", "two triangles share two of four vertices", {"R14", "R15"}, [] {
    return corners({0, 1, 2, 0, 2, 3});
  });
  family.add("reversed", "indices run backwards", {"R12", "R14"}, [] { return corners({4, 3, 2, 2, 1, 0}); });
  family.add("repeated", "repeated indices make zero-area triangles between real ones", {"R12", "R14"}, [] {
    return corners({0, 1, 4, 1, 1, 2, 2, 3, 2, 3, 0, 4});
  });
  family.add("incomplete-tail", "two indices after the last whole triangle are ignored", {"R14"}, [] {
    return corners({0, 1, 2, 2, 3});
  });
  family.add("last-index", "the last triangle ends with an index that no other has", {"R14"}, [] {
    return corners({0, 1, 2, 0, 2, 3, 3, 0, 4});
  });
  family.add("empty", "an empty index list draws nothing", {"R14"}, [] { return corners({}); });
  family.add("two-draws", "each draw's indices count from its own first vertex", {"R14", "R50"}, [] {
    Scene scene = corners({0, 1, 2});
    draw(scene, {{10.5, 20.5}, {20.5, 20.5}, {10.5, 30.5}, {30.5, 30.5}}).indices = {2, 1, 3};
    return scene;
  });
}

}  // namespace rasterdiff::families
