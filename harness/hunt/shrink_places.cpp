// A target of a few pixels at the origin, vertices on coarse grids, plain numbers.
#include <algorithm>
#include <array>
#include <cmath>

#include "harness/hunt/shrink.hpp"
#include "scene/camera/screen.hpp"

namespace rasterdiff::harness::hunt {
namespace {

const Viewport& viewportOf(const Scene& scene, const Draw& draw) {
  return draw.viewportIndex == 0 ? scene.viewport : scene.furtherViewports[draw.viewportIndex - 1].viewport;
}

/// The inverse of clipFromPixels; only for w other than 0.
PixelPosition pixelsOf(const Viewport& v, const ClipPosition& p) {
  return {v.x + v.width / 2.0 * (1 + double{p.x} / p.w), v.y + v.height / 2.0 * (1 + double{p.y} / p.w), double{p.z} / p.w, p.w};
}

template <class Move>
void moveVertex(const Scene& scene, const Draw& draw, ClipPosition& p, const Move& move) {
  if (p.w == 0 || !std::isfinite(p.x + p.y + p.z + p.w)) return;
  PixelPosition at = pixelsOf(viewportOf(scene, draw), p);
  const float z = p.z, w = p.w;
  move(at);
  p = clipFromPixels(viewportOf(scene, draw), at);
  if (at.w == w) p.z = z;
}

double rounded(double value, double steps) { return std::round(value * steps) / steps; }

void shift(Viewport& viewport, std::optional<Rect2D>& scissor, uint32_t x, uint32_t y) {
  viewport.x -= static_cast<float>(x);
  viewport.y -= static_cast<float>(y);
  if (!scissor) return;
  const auto axis = [](int32_t& offset, uint32_t& extent, uint32_t by) {
    const int64_t begin = int64_t{offset} - by, end = begin + extent;
    offset = static_cast<int32_t>(std::max<int64_t>(begin, 0));
    extent = static_cast<uint32_t>(std::max<int64_t>(end - offset, 0));
  };
  axis(scissor->x, scissor->width, x);
  axis(scissor->y, scissor->height, y);
}

/// Only width × height pixels from (x, y) on.
void crop(Scene& scene, uint32_t x, uint32_t y, uint32_t width, uint32_t height) {
  scene.target.width = width;
  scene.target.height = height;
  shift(scene.viewport, scene.scissor, x, y);
  for (ViewportAndScissor& further : scene.furtherViewports) shift(further.viewport, further.scissor, x, y);
}

bool cropToBlocks(Shrinking& s) {
  for (uint32_t n = 1; n < std::max(s.scene().target.width, s.scene().target.height); n *= 2) {
    const uint32_t x = s.at().x / n * n, y = s.at().y / n * n;
    const uint32_t width = std::min(n, s.scene().target.width - x), height = std::min(n, s.scene().target.height - y);
    if (s.edit([&](Scene& scene) { crop(scene, x, y, width, height); })) return true;
  }
  return false;
}

bool cropSides(Shrinking& s) {
  bool any = false;
  for (int turn = 0; turn < 4; ++turn) {
    const Target t = s.scene().target;
    const uint32_t x = s.at().x, y = s.at().y;
    if (turn == 0 && x > 0) any |= s.edit([&](Scene& scene) { crop(scene, x, 0, t.width - x, t.height); });
    if (turn == 1 && y > 0) any |= s.edit([&](Scene& scene) { crop(scene, 0, y, t.width, t.height - y); });
    if (turn == 2 && x + 1 < t.width) any |= s.edit([&](Scene& scene) { crop(scene, 0, 0, x + 1, t.height); });
    if (turn == 3 && y + 1 < t.height) any |= s.edit([&](Scene& scene) { crop(scene, 0, 0, t.width, y + 1); });
  }
  return any;
}

/// A scissor of one pixel at each of its ends.
bool narrowScissor(Shrinking& s) {
  bool any = false;
  for (const bool vertical : {false, true}) {
    for (const bool end : {true, false}) {
      if (!s.scene().scissor) return any;
      any |= s.edit([&](Scene& scene) {
        int32_t& offset = vertical ? scene.scissor->y : scene.scissor->x;
        uint32_t& extent = vertical ? scene.scissor->height : scene.scissor->width;
        if (end) offset += static_cast<int32_t>(extent) - 1;
        extent = 1;
      });
    }
  }
  return any;
}

/// The same pixels through a viewport that is the whole target.
bool rebase(Shrinking& s) {
  const Target& t = s.scene().target;
  const Viewport whole{0, 0, static_cast<float>(t.width), static_cast<float>(t.height), s.scene().viewport.minDepth, s.scene().viewport.maxDepth};
  if (!s.scene().furtherViewports.empty() || whole == s.scene().viewport) return false;
  return s.edit([&](Scene& scene) {
    for (Draw& draw : scene.draws) {
      for (ClipPosition& p : draw.positions) {
        if (p.w == 0) continue;
        const float z = p.z;
        p = clipFromPixels(whole, pixelsOf(scene.viewport, p));
        p.z = z;
      }
    }
    scene.viewport = whole;
  });
}

/// How coarse a number is: the fewest steps a unit that hold it, of those that are tried.
constexpr std::array<double, 5> kSteps{0.25, 1, 2, 16, 256};

template <class Edit>
bool eachVertex(Shrinking& s, const Edit& change) {
  bool any = false;
  for (size_t d = 0; d < s.scene().draws.size(); ++d) {
    for (size_t v = 0; v < s.scene().draws[d].positions.size() && !s.exhausted(); ++v) {
      any |= s.edit([&](Scene& scene) { change(scene, scene.draws[d], scene.draws[d].positions[v]); });
    }
  }
  return any;
}

bool coarser(Shrinking& s) {
  const auto round = [](PixelPosition& at, double steps, bool x, bool y) {
    if (x) at.x = rounded(at.x, steps);
    if (y) at.y = rounded(at.y, steps);
  };
  for (const double steps : kSteps) {
    const bool all = s.edit([&](Scene& scene) {
      for (Draw& draw : scene.draws) {
        for (ClipPosition& p : draw.positions) moveVertex(scene, draw, p, [&](PixelPosition& at) { round(at, steps, true, true); });
      }
    });
    if (all) break;
  }
  bool any = false;
  for (const bool vertical : {false, true}) {
    for (size_t d = 0; d < s.scene().draws.size(); ++d) {
      for (size_t v = 0; v < s.scene().draws[d].positions.size() && !s.exhausted(); ++v) {
        for (const double steps : kSteps) {
          const ClipPosition& p = s.scene().draws[d].positions[v];
          const PixelPosition at = pixelsOf(viewportOf(s.scene(), s.scene().draws[d]), p);
          const double now = vertical ? at.y : at.x;
          if (p.w == 0 || !std::isfinite(now) || rounded(now, steps) == now) break;
          if (s.edit([&](Scene& scene) {
                Draw& draw = scene.draws[d];
                moveVertex(scene, draw, draw.positions[v], [&](PixelPosition& q) { round(q, steps, !vertical, vertical); });
              })) {
            any = true;
            break;
          }
        }
      }
    }
  }
  return any;
}

/// Far vertices come nearer to the target.
bool nearer(Shrinking& s) {
  bool any = false;
  for (const double margin : {0.0, 1.0, 4.0, 16.0}) {
    const double right = s.scene().target.width + margin, bottom = s.scene().target.height + margin;
    any |= eachVertex(s, [&](Scene& scene, Draw& draw, ClipPosition& p) {
      moveVertex(scene, draw, p, [&](PixelPosition& at) {
        at.x = std::clamp(at.x, -margin, right);
        at.y = std::clamp(at.y, -margin, bottom);
      });
    });
  }
  return any;
}

bool plainDepth(Shrinking& s) {
  const auto affine = [](PixelPosition& at) { at.w = 1; };
  bool any = s.edit([&](Scene& scene) {
    for (Draw& draw : scene.draws) {
      for (ClipPosition& p : draw.positions) moveVertex(scene, draw, p, affine);
    }
  });
  for (const float w : {1.0F, 2.0F}) {
    any |= eachVertex(s, [&](Scene& scene, Draw& draw, ClipPosition& p) {
      if (p.w != 1 && p.w != w) moveVertex(scene, draw, p, [&](PixelPosition& at) { at.w = at.w < 0 ? -w : w; });
    });
  }
  for (const float z : {0.5F, 0.0F}) {
    const bool all = s.edit([&](Scene& scene) {
      for (Draw& draw : scene.draws) {
        for (ClipPosition& p : draw.positions) p.z = z * p.w;
      }
    });
    if (all) return true;
  }
  return eachVertex(s, [](Scene&, Draw&, ClipPosition& p) { p.z = std::round(p.z * 4) / 4; }) || any;
}

/// Distances and values: whole numbers, all at once, then 0 or 1 one by one.
bool plainNumbers(Shrinking& s, const std::function<std::vector<float>*(Scene&, size_t)>& listOf, size_t lists) {
  bool any = false;
  for (size_t list = 0; list < lists; ++list) {
    any |= s.edit([&](Scene& scene) {
      for (float& value : *listOf(scene, list)) value = std::round(std::clamp(value, -1024.0F, 1024.0F));
    });
    Scene copy = s.scene();
    constexpr size_t kFew = 24;
    const size_t count = std::min(listOf(copy, list)->size(), kFew);
    for (size_t i = 0; i < count && !s.exhausted(); ++i) {
      for (const float plain : {0.0F, 1.0F}) {
        Scene now = s.scene();
        const float value = (*listOf(now, list))[i];
        if (value == 0 || (plain == 1 && (value == 1 || value == -1))) break;
        if (s.edit([&](Scene& scene) { (*listOf(scene, list))[i] = plain == 1 ? std::copysign(1.0F, value) : 0; })) {
          any = true;
          break;
        }
      }
    }
  }
  return any;
}

bool plainValues(Shrinking& s) {
  bool any = false;
  for (size_t d = 0; d < s.scene().draws.size(); ++d) {
    any |= plainNumbers(s, [d](Scene& scene, size_t v) { return &scene.draws[d].varyings[v].values; }, s.scene().draws[d].varyings.size());
    any |= plainNumbers(s, [d](Scene& scene, size_t) { return &scene.draws[d].clipDistances; }, 1);
    any |= plainNumbers(s, [d](Scene& scene, size_t) { return &scene.draws[d].cullDistances; }, 1);
  }
  return any;
}

}  // namespace

bool cropTarget(Shrinking& s) {
  bool any = narrowScissor(s);
  any |= cropToBlocks(s);
  any |= cropSides(s);
  return rebase(s) || any;
}

bool simplifyCoordinates(Shrinking& s) {
  bool any = plainDepth(s);
  any |= nearer(s);
  any |= coarser(s);
  return plainValues(s) || any;
}

}  // namespace rasterdiff::harness::hunt
