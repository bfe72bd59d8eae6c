// What every renderer may rely on: validate() runs the checks of a scene's parts (scene/checks.hpp), and how many
// primitives assembly makes. Where in a file a field stands is the loader's business (scene/file).
#include "scene/scene.hpp"

#include <fmt/format.h>

#include "scene/built_ins.hpp"
#include "scene/checks.hpp"

namespace rasterdiff {
namespace {

/// Bytes of the reference's frame with its bounds: primitive, count, coverage; depth, varyings, built-ins and resolved
/// values with bounds; as large as it is drawn.
uint64_t frameBytes(const Scene& scene) {
  constexpr uint64_t kValue = 4 + 8;  // a float and its bounds
  uint64_t varyings = 0, perSample = 4 + 4 + 1;
  for (const Varying& varying : scene.draws.front().varyings) varyings += varying.components * kValue;
  for (const BuiltIn builtIn : scene.builtIns) perSample += builtInComponents(builtIn) * kValue;
  if (scene.target.depthFormat) perSample += kValue;
  perSample += varyings;
  const Target& t = scene.target;
  const uint64_t perPixel = t.samples * perSample + (t.resolve ? varyings : 0) + (t.depthResolveMode ? kValue : 0);
  return uint64_t{t.width} * t.height * t.supersample * t.supersample * perPixel;
}

}  // namespace

tl::unexpected<Error> checks::bad(std::string where, std::string what, std::string hint) {
  return fail(ErrorCode::BadInput, std::move(where), std::move(what), std::move(hint));
}

Result<void> validate(const Scene& scene) {
  using namespace checks;
  if (auto ok = checkName(scene.name); !ok) return ok;
  if (auto ok = checkTarget(scene.target); !ok) return ok;
  if (auto ok = checkViewports(scene); !ok) return ok;
  if (auto ok = checkState(scene); !ok) return ok;
  if (auto ok = checkBuiltIns(scene); !ok) return ok;
  if (scene.draws.empty()) return bad("draws", "a scene without draws");
  uint64_t primitives = 0;
  for (size_t i = 0; i < scene.draws.size(); ++i) {
    if (auto ok = checkDraw(scene, i); !ok) return ok;
    primitives += primitiveCount(scene.state, scene.draws[i]);
  }
  if (primitives >= UINT32_MAX) return bad("draws", "more than 2^32 - 2 primitives");
  if (frameBytes(scene) > kMaxFrameBytes) {
    return bad("target",
               fmt::format("the planes of this scene would take {} MiB; at most {}", frameBytes(scene) >> 20,
                           kMaxFrameBytes >> 20),
               "use a smaller target, fewer samples or fewer varyings");
  }
  return {};
}

uint32_t vertexCount(const Draw& draw) {
  return static_cast<uint32_t>(draw.indices ? draw.indices->size() : draw.positions.size());
}

uint32_t primitiveCount(PrimitiveTopology topology, uint32_t vertices) {
  switch (topology) {
    case PrimitiveTopology::POINT_LIST: return vertices;
    case PrimitiveTopology::LINE_LIST: return vertices / 2;
    case PrimitiveTopology::LINE_STRIP: return vertices < 2 ? 0 : vertices - 1;
    case PrimitiveTopology::TRIANGLE_LIST: return vertices / 3;
    case PrimitiveTopology::TRIANGLE_STRIP:
    case PrimitiveTopology::TRIANGLE_FAN: return vertices < 3 ? 0 : vertices - 2;
  }
  return 0;
}

uint32_t primitiveCount(const State& state, const Draw& draw) {
  if (!state.primitiveRestartEnable || !draw.indices) return primitiveCount(state.topology, vertexCount(draw));
  uint32_t primitives = 0, vertices = 0;
  for (const uint32_t index : *draw.indices) {
    if (index != kRestartIndex) {
      ++vertices;
      continue;
    }
    primitives += primitiveCount(state.topology, vertices);
    vertices = 0;
  }
  return primitives + primitiveCount(state.topology, vertices);
}

}  // namespace rasterdiff
