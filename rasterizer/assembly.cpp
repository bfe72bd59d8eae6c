#include "rasterizer/assembly.hpp"

namespace rasterdiff::rasterizer {
namespace {

// Positions in the vertex stream of primitive i; the provoking vertex is at the end the mode names.
std::array<uint32_t, 3> stream(PrimitiveTopology topology, bool firstProvokes, bool ignoreParity, uint32_t i) {
  switch (topology) {
    case PrimitiveTopology::POINT_LIST: return {i, i, i};
    case PrimitiveTopology::LINE_LIST: return {2 * i, 2 * i + 1, 2 * i + 1};
    case PrimitiveTopology::LINE_STRIP: return {i, i + 1, i + 1};
    case PrimitiveTopology::TRIANGLE_LIST: return {3 * i, 3 * i + 1, 3 * i + 2};
    case PrimitiveTopology::TRIANGLE_STRIP: {
      if (i % 2 == 0 || ignoreParity) return {i, i + 1, i + 2};
      if (firstProvokes) return {i, i + 2, i + 1};
      return {i + 1, i, i + 2};
    }
    case PrimitiveTopology::TRIANGLE_FAN:
      if (firstProvokes) return {i + 1, i + 2, 0};
      return {0, i + 1, i + 2};
  }
  return {};
}

class Assembler {
 public:
  Assembler(const Draw& draw, const State& state, DeliberateError error)
      : draw_(draw), topology_(state.topology), error_(error),
        firstProvokes_(state.provokingVertexMode == ProvokingVertexMode::FIRST_VERTEX) {}

  // `vertices` of the stream from `base` on form one strip, fan or list.
  void add(uint32_t base, uint32_t vertices) {
    const uint32_t primitives = primitiveCount(topology_, vertices);
    const bool ignoreParity = error_ == DeliberateError::StripParityIgnored;
    for (uint32_t i = 0; i < primitives; ++i) {
      AssembledTriangle primitive;
      primitive.count = verticesEach(topology_);
      primitive.continuesLine = topology_ == PrimitiveTopology::LINE_STRIP && i > 0;
      primitive.vertices = stream(topology_, firstProvokes_, ignoreParity, i);
      for (uint32_t& vertex : primitive.vertices) vertex = fetch(base + vertex);
      const bool takeFirst = firstProvokes_ != (error_ == DeliberateError::WrongProvokingVertex);
      primitive.provoking = primitive.vertices[takeFirst ? 0 : 2];
      const bool byHub = error_ == DeliberateError::FanHubProvokes && topology_ == PrimitiveTopology::TRIANGLE_FAN;
      if (byHub) primitive.provoking = fetch(base);
      assembled.push_back(primitive);
    }
  }

  std::vector<AssembledTriangle> assembled;

 private:
  static uint32_t verticesEach(PrimitiveTopology topology) {
    switch (topology) {
      case PrimitiveTopology::POINT_LIST: return 1;
      case PrimitiveTopology::LINE_LIST:
      case PrimitiveTopology::LINE_STRIP: return 2;
      case PrimitiveTopology::TRIANGLE_LIST:
      case PrimitiveTopology::TRIANGLE_STRIP:
      case PrimitiveTopology::TRIANGLE_FAN: return 3;
    }
    return 3;
  }

  [[nodiscard]] uint32_t fetch(uint32_t position) const {
    if (!draw_.indices) return position;
    const std::vector<uint32_t>& indices = *draw_.indices;
    const bool last = position > 0 && position + 1 == indices.size() && indices[position - 1] != kRestartIndex;
    return indices[error_ == DeliberateError::IndexOffByOne && last ? position - 1 : position];
  }

  const Draw& draw_;
  const PrimitiveTopology topology_;
  const DeliberateError error_;
  const bool firstProvokes_;
};

}  // namespace

std::vector<AssembledTriangle> assemble(const Draw& draw, const State& state, DeliberateError error) {
  if (error == DeliberateError::RestartIgnored && state.primitiveRestartEnable && draw.indices) {
    Draw joined = draw;
    std::erase(*joined.indices, kRestartIndex);
    return assemble(joined, state);
  }
  Assembler assembler(draw, state, error);
  assembler.assembled.reserve(primitiveCount(state, draw));
  const uint32_t vertices = vertexCount(draw);
  uint32_t base = 0;
  // [vk:VkPipelineInputAssemblyStateCreateInfo] the special index ends one strip, fan or list and begins the next.
  if (state.primitiveRestartEnable && draw.indices) {
    for (uint32_t i = 0; i < vertices; ++i) {
      if ((*draw.indices)[i] != kRestartIndex) continue;
      assembler.add(base, i - base);
      base = i + 1;
    }
  }
  assembler.add(base, vertices - base);
  return std::move(assembler.assembled);
}

}  // namespace rasterdiff::rasterizer
