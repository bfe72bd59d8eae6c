// Fewer draws, fewer primitives, no indices, lists instead of strips and fans.
#include <algorithm>
#include <set>

#include "harness/hunt/shrink.hpp"

namespace rasterdiff::harness::hunt {
namespace {

using enum PrimitiveTopology;

size_t unitOf(PrimitiveTopology topology) {
  switch (topology) {
    case TRIANGLE_LIST: return 3;
    case LINE_LIST: return 2;
    default: return 1;
  }
}

/// `list[order[i] * each ...]` in that order.
template <class T>
std::vector<T> picked(const std::vector<T>& list, const std::vector<uint32_t>& order, size_t each) {
  std::vector<T> result;
  if (list.empty()) return result;
  for (const uint32_t i : order) {
    for (size_t c = 0; c < each; ++c) result.push_back(list[i * each + c]);
  }
  return result;
}

/// The draw with vertex `order[i]` as its i-th, without indices.
Draw withVertices(const Draw& draw, const std::vector<uint32_t>& order) {
  Draw result = draw;
  result.indices.reset();
  result.positions = picked(draw.positions, order, 1);
  result.pointSizes = picked(draw.pointSizes, order, 1);
  result.clipDistances = picked(draw.clipDistances, order, draw.clipDistanceCount);
  result.cullDistances = picked(draw.cullDistances, order, draw.cullDistanceCount);
  for (size_t v = 0; v < draw.varyings.size(); ++v) {
    result.varyings[v].values = picked(draw.varyings[v].values, order, draw.varyings[v].components);
  }
  return result;
}

/// The vertex numbers that the draw consumes.
std::vector<uint32_t> consumed(const Draw& draw) {
  if (draw.indices) return *draw.indices;
  std::vector<uint32_t> all(draw.positions.size());
  for (uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

/// The primitives of a strip or fan as a list of vertex numbers. [vk:drawing-primitive-topologies]
std::vector<uint32_t> asList(PrimitiveTopology topology, const std::vector<uint32_t>& all) {
  std::vector<uint32_t> list;
  size_t start = 0;
  for (size_t i = 0; i < all.size(); ++i) {
    if (all[i] == kRestartIndex) {
      start = i + 1;
      continue;
    }
    const size_t n = i - start;  // vertices before this one since the start
    if (topology == LINE_STRIP && n >= 1) list.insert(list.end(), {all[i - 1], all[i]});
    if (topology == TRIANGLE_FAN && n >= 2) list.insert(list.end(), {all[i - 1], all[i], all[start]});
    if (topology != TRIANGLE_STRIP || n < 2) continue;
    if (n % 2 == 0) list.insert(list.end(), {all[i - 2], all[i - 1], all[i]});
    if (n % 2 == 1) list.insert(list.end(), {all[i - 2], all[i], all[i - 1]});
  }
  return list;
}

bool dropDraws(Shrinking& s) {
  bool any = false;
  for (size_t d = s.scene().draws.size(); d-- > 0 && s.scene().draws.size() > 1;) {
    any |= s.edit([d](Scene& scene) { scene.draws.erase(scene.draws.begin() + static_cast<std::ptrdiff_t>(d)); });
  }
  return any;
}

bool toLists(Shrinking& s) {
  const PrimitiveTopology topology = s.scene().state.topology;
  if (unitOf(topology) != 1 || topology == POINT_LIST) return false;
  return s.edit([&](Scene& scene) {
    scene.state.topology = topology == LINE_STRIP ? LINE_LIST : TRIANGLE_LIST;
    scene.state.primitiveRestartEnable = false;
    for (Draw& draw : scene.draws) draw = withVertices(draw, asList(topology, consumed(draw)));
  });
}

bool unindex(Shrinking& s) {
  bool any = false;
  for (size_t d = 0; d < s.scene().draws.size(); ++d) {
    const Draw& draw = s.scene().draws[d];
    if (!draw.indices) continue;
    std::vector<uint32_t> order = *draw.indices;
    std::erase(order, kRestartIndex);
    any |= s.edit([&](Scene& scene) { scene.draws[d] = withVertices(scene.draws[d], order); });
  }
  return any;
}

/// Vertices that no index names.
bool compact(Shrinking& s) {
  bool any = false;
  for (size_t d = 0; d < s.scene().draws.size(); ++d) {
    const Draw& draw = s.scene().draws[d];
    if (!draw.indices) continue;
    const std::set<uint32_t> named(draw.indices->begin(), draw.indices->end());
    std::vector<uint32_t> order(named.begin(), named.end());
    std::erase(order, kRestartIndex);
    if (order.empty() || order.size() == draw.positions.size()) continue;
    any |= s.edit([&](Scene& scene) {
      std::vector<uint32_t> indices = *scene.draws[d].indices;
      for (uint32_t& index : indices) {
        if (index == kRestartIndex) continue;
        index = static_cast<uint32_t>(std::lower_bound(order.begin(), order.end(), index) - order.begin());
      }
      scene.draws[d] = withVertices(scene.draws[d], order);
      scene.draws[d].indices = std::move(indices);
    });
  }
  return any;
}

/// Leaves out runs of primitives (of strips: vertices), long runs first.
bool dropRuns(Shrinking& s, size_t d) {
  bool any = false;
  const size_t unit = unitOf(s.scene().state.topology);
  for (size_t run = consumed(s.scene().draws[d]).size() / unit; run >= 1; run /= 2) {
    for (size_t first = 0; first < consumed(s.scene().draws[d]).size() / unit && !s.exhausted();) {
      std::vector<uint32_t> order = consumed(s.scene().draws[d]);
      const auto begin = order.begin() + static_cast<std::ptrdiff_t>(first * unit);
      order.erase(begin, begin + static_cast<std::ptrdiff_t>(std::min(run * unit, order.size() - first * unit)));
      const bool took = !order.empty() && s.edit([&](Scene& scene) {
        Draw& draw = scene.draws[d];
        if (draw.indices) {
          draw.indices = order;
        } else {
          draw = withVertices(draw, order);
        }
      });
      any |= took;
      if (!took) first += run;
    }
  }
  return any;
}

}  // namespace

bool dropPrimitives(Shrinking& s) {
  bool any = dropDraws(s);
  any |= toLists(s);
  any |= unindex(s);
  for (size_t d = 0; d < s.scene().draws.size(); ++d) any |= dropRuns(s, d);
  return compact(s) || any;
}

}  // namespace rasterdiff::harness::hunt
