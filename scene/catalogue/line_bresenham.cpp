// Bresenham lines: the diamond-exit rule, one fragment a column or row. [vk:primsrast-lines-bresenham]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene lines(uint32_t extent, const std::vector<Px>& vertices, uint32_t samples = 1) {
  Scene scene = square(extent, samples);
  useLines(scene, LineRasterizationMode::BRESENHAM);
  draw(scene, vertices);
  return scene;
}

/// From the centre of a 64 × 64 target outward and back, in 32 directions.
std::vector<Px> star(double fx, double fy) {
  std::vector<Px> v;
  for (int i = 0; i < 32; ++i) {
    constexpr int kEdge[8] = {28, 21, 14, 7, 0, -7, -14, -21};
    const int side = i / 8, along = kEdge[i % 8];
    const int x = side == 0 ? 28 : side == 1 ? along : side == 2 ? -28 : -along;
    const int y = side == 0 ? -along : side == 1 ? 28 : side == 2 ? along : -28;
    Px a{32 + fx + x / 7, 32 + fy + y / 7}, b{32 + fx + x, 32 + fy + y};
    if (i % 2 == 1) std::swap(a, b);
    v.insert(v.end(), {a, b});
  }
  return v;
}

/// Short lines from `(fx, fy)` of a pixel in eight directions, one pixel cell of 8 each.
std::vector<Px> fromPlace(double fx, double fy, double y0) {
  std::vector<Px> v;
  constexpr double kTo[8][2] = {{3, 0}, {3, 3}, {0, 3}, {-3, 3}, {-3, 0}, {-3, -3}, {0, -3}, {3, -3}};
  for (int i = 0; i < 8; ++i) {
    const Px from{4 + 8.0 * i + fx, y0 + fy};
    v.insert(v.end(), {from, {from.x + kTo[i][0], from.y + kTo[i][1]}});
  }
  return v;
}

}  // namespace

void addLineBresenham(Entries& entries) {
  Family family(entries, "line-bresenham");
  const std::vector<std::string> rules{"R29"};
  family.add("star-centres", "all octants, slopes of 0, 1 and infinity among them, ends on centres", rules,
             [] { return lines(64, star(0.5, 0.5)); });
  family.add("star-corners", "all octants, ends on the corners of pixels", rules, [] { return lines(64, star(0, 0)); });
  family.add("star-fractions", "all octants, ends at fractions of a pixel", rules,
             [] { return lines(64, star(0.3125, 0.6875)); });
  family.add("star-4x", "a Bresenham line covers all samples of its pixels, or none", {"R29", "R31"},
             [] { return lines(64, star(0.3125, 0.6875), 4); });
  family.add("diamond-corners", "lines begin on each corner of the diamond and leave in eight directions", rules, [] {
    Scene scene = lines(64, fromPlace(0.5, 0, 4));
    draw(scene, fromPlace(1, 0.5, 20));
    draw(scene, fromPlace(0.5, 1, 36));
    draw(scene, fromPlace(0, 0.5, 52));
    return scene;
  });
  family.add("diamond-edges", "lines begin on the middle of each edge of the diamond", rules, [] {
    Scene scene = lines(64, fromPlace(0.75, 0.25, 4));
    draw(scene, fromPlace(0.75, 0.75, 20));
    draw(scene, fromPlace(0.25, 0.75, 36));
    draw(scene, fromPlace(0.25, 0.25, 52));
    return scene;
  });
  family.add("slope-one", "slopes of exactly 1 and -1 are x-major, on centres and between them", rules, [] {
    return lines(32, {{2.5, 2.5}, {14.5, 14.5}, {29.5, 2.5}, {17.5, 14.5}, {2, 29}, {14, 17}, {17.25, 17.75}, {29.25, 29.75}});
  });
  family.add("zero-length", "lines of no length on a centre, a corner and a diamond's corner", rules, [] {
    return lines(16, {{4.5, 4.5}, {4.5, 4.5}, {8, 8}, {8, 8}, {11.5, 4}, {11.5, 4}});
  });
  family.add("inside-a-diamond", "lines that stay inside of one diamond never exit it", rules, [] {
    return lines(16, {{4.4, 4.5}, {4.6, 4.5}, {8.5, 8.3}, {8.6, 8.6}, {11.5, 4.5}, {11.75, 4.6}});
  });
  family.add(
      "end-at-499", "from (0, 0.35) to (4.99, 0.35): the last pixel is the diamond's question", rules,
      [] {
        return lines(16, {{2, 2.35}, {6.99, 2.35}, {2, 5.35}, {7, 5.35}, {2, 8.5}, {6.99, 8.5}, {6.99, 11.35}, {2, 11.35}});
      },
      issue("KhronosGroup/MoltenVK", 2570));
  family.add(
      "end-at-099", "ends at (0.99, 0.5) and (0.99, 0.49)", rules,
      [] { return lines(16, {{2.5, 2.5}, {5.99, 2.5}, {2.5, 6.5}, {5.99, 6.49}, {5.5, 9.01}, {5.5, 12.99}}); },
      issue("KhronosGroup/MoltenVK", 2556));
  family.add("depth-slanted", "depth runs along slanted lines as their values do", {"R22", "R29"}, [] {
    Scene scene = square(32);
    useLines(scene, LineRasterizationMode::BRESENHAM);
    draw(scene, {{3.25, 4.5, 0.25}, {27.5, 17.75, 0.75}, {8.5, 28.25, 0.75}, {4.25, 8.5, 0.125}});
    useDepth(scene);
    return scene;
  });
  family.add("values", "values run along the line", {"R21", "R29"}, [] {
    Scene scene = lines(32, {{3.5, 3.5, 0.25, 1}, {28.5, 11.5, 0.75, 4}, {5.5, 28.5, 0.5, 2}, {9.5, 6.5, 0.5, 0.5}});
    addVarying(scene, "smooth", Interpolation::smooth, 2);
    addVarying(scene, "flat", Interpolation::flat, 1);
    return scene;
  });
  family.add("depth", "depth runs along the line", {"R22", "R29", "R38"}, [] {
    Scene scene = lines(32, {{3.5, 16.5, 0}, {28.5, 16.5, 1}, {16.5, 3.5, 1}, {16.5, 28.5, 0.125}});
    useDepth(scene);
    return scene;
  });
}

}  // namespace rasterdiff::families
