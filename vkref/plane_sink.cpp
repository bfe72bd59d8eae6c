#include "vkref/plane_sink.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

#include "scene/built_ins.hpp"
#include "vkref/unpack.hpp"

namespace rasterdiff::vkref {
namespace {

/// A sum of ones in float32 stops growing here; below, every count is exact.
constexpr float kInexactCount = 16777216;

/// A plane of the plan's extents. All of it is going to be written.
template <class T>
Plane<T> emptyPlane(const RenderPlan& plan, uint32_t samples, uint32_t components) {
  auto plane = Plane<T>::unwritten(plan.width, plan.height, samples, components);
  return plane;
}

/// The numbers of a plane in some of its rows.
template <class T>
std::span<T> rowsOf(Plane<T>& plane, uint32_t first, uint32_t rows) {
  const size_t row = size_t{plane.width} * plane.samples * plane.components;
  return std::span(plane.data).subspan(first * row, rows * row);
}

/// The words at `from`, `stride` of them for `components` that are wanted; a single copy where they lie tight.
template <class T>
void copyWords(const std::byte* from, uint32_t stride, uint32_t components, std::span<T> to) {
  if (stride == components) {
    std::memcpy(to.data(), from, to.size_bytes());
    return;
  }
  const T* words = reinterpret_cast<const T*>(from);
  for (size_t i = 0; i < to.size(); i += components, words += stride) std::copy_n(words, components, to.data() + i);
}

/// Counts that were summed as floats, `stride` words a sample. Error: NotOffered where a sum has stopped being exact.
Result<void> convertCounts(const std::byte* from, size_t stride, std::span<uint32_t> counts) {
  // As integers, the bits of floats that are not negative are in the order of the floats.
  constexpr auto kInexactBits = std::bit_cast<int32_t>(kInexactCount);
  const int32_t* bits = reinterpret_cast<const int32_t*>(from);
  int32_t inexact = 0;
  const auto convert = [&](uint32_t& count, int32_t sum) {
    inexact |= static_cast<int32_t>(sum >= kInexactBits);
    count = static_cast<uint32_t>(static_cast<int32_t>(std::bit_cast<float>(std::min(sum, kInexactBits))));
  };
  if (stride == 1) {
    for (size_t i = 0; i < counts.size(); ++i) convert(counts[i], bits[i]);
  } else {
    for (size_t i = 0; i < counts.size(); ++i) convert(counts[i], bits[i * stride]);
  }
  if (inexact == 0) return {};
  return fail(ErrorCode::NotOffered, "draws", "a sample was written 2^24 times or more: float counts end there");
}

PlaneSink sinkOf(const Image& image, uint32_t components) {
  const Image::Key& key = image.key;
  PlaneSink sink;
  sink.image = &image;
  const bool copied = key.samples == 1;
  sink.stride = copied ? static_cast<uint32_t>(std::max<VkDeviceSize>(texelBytes(key.format) / 4, 1)) : unpackedComponents(key.samples, components);
  sink.rowBytes = VkDeviceSize{key.width} * key.samples * (copied ? copiedBytes(key.format) : sink.stride * 4);
  return sink;
}

template <class T>
PlaneSink wordSink(const Image& image, Plane<T>& plane) {
  PlaneSink sink = sinkOf(image, plane.components);
  sink.take = [&plane, stride = sink.stride](const std::byte* from, uint32_t first, uint32_t rows) -> Result<void> {
    copyWords(from, stride, plane.components, rowsOf(plane, first, rows));
    return {};
  };
  return sink;
}

PlaneSink countSink(const Image& image, Plane<uint32_t>& plane) {
  PlaneSink sink = sinkOf(image, 1);
  sink.take = [&plane, stride = sink.stride](const std::byte* from, uint32_t first, uint32_t rows) {
    return convertCounts(from, stride, rowsOf(plane, first, rows));
  };
  return sink;
}

PlaneSink depthSink(const Image& image, DepthFetch fetch, Plane<float>& plane) {
  PlaneSink sink = sinkOf(image, 1);
  sink.take = [&plane, fetch, stride = sink.stride, key = image.key](const std::byte* from, uint32_t first, uint32_t rows) -> Result<void> {
    const std::span<float> depths = rowsOf(plane, first, rows);
    if (key.samples == 1) {
      copyDepths(key.format, from, depths);
    } else {
      copyWords(from, stride, 1, depths);
      restoreFetchedDepths(key.format, fetch, depths);
    }
    return {};
  };
  return sink;
}

void makePlanes(const Scene& scene, const RenderPlan& plan, const Attachments& attachments, Frame& frame) {
  frame.width = plan.width;
  frame.height = plan.height;
  frame.samples = plan.samples;
  frame.primitive = emptyPlane<uint32_t>(plan, plan.samples, 1);
  frame.count = emptyPlane<uint32_t>(plan, plan.samples, 1);
  if (attachments.depth) frame.depth = emptyPlane<float>(plan, plan.samples, 1);
  for (size_t i = kFirstVarying; i < plan.color.size(); ++i) {
    const size_t v = i - kFirstVarying;
    const uint32_t components = plan.color[i].components;
    const std::string name(v < plan.varyings ? std::string_view(scene.draws.front().varyings[v].name)
                                             : builtInName(scene.builtIns[v - plan.varyings]));
    frame.varyings.push_back({name, emptyPlane<float>(plan, plan.samples, components), std::nullopt});
    if (v < attachments.resolved.size()) frame.resolved.push_back({name, emptyPlane<float>(plan, 1, components), std::nullopt});
  }
  if (attachments.resolvedDepth) frame.resolved.push_back({"depth", emptyPlane<float>(plan, 1, 1), std::nullopt});
}

}  // namespace

std::vector<PlaneSink> planeSinks(const Scene& scene, const RenderPlan& plan, const Attachments& attachments, DepthFetch fetch,
                                  Frame& frame) {
  makePlanes(scene, plan, attachments, frame);
  std::vector<PlaneSink> sinks{wordSink(*attachments.color[0], frame.primitive), countSink(*attachments.color[1], frame.count)};
  for (size_t v = 0; v < frame.varyings.size(); ++v) {
    sinks.push_back(wordSink(*attachments.color[kFirstVarying + v], frame.varyings[v].values));
  }
  for (size_t v = 0; v < attachments.resolved.size(); ++v) {
    sinks.push_back(wordSink(*attachments.resolved[v], frame.resolved[v].values));
  }
  if (attachments.depth) sinks.push_back(depthSink(*attachments.depth, fetch, *frame.depth));
  if (attachments.resolvedDepth) sinks.push_back(depthSink(*attachments.resolvedDepth, fetch, frame.resolved.back().values));
  return sinks;
}

}  // namespace rasterdiff::vkref
