// One scene on one device: plan, upload, draw, read back.
#include <algorithm>
#include <iterator>
#include <new>

#include "scene/primitive_class.hpp"
#include "scene/stopwatch.hpp"
#include "vkref/commands.hpp"
#include "vkref/device_impl.hpp"
#include "vkref/readback.hpp"

namespace rasterdiff::vkref {
namespace {

/// The device may still use whatever it was given, and can draw no further scene.
bool isLost(const Error& error) { return error.code == ErrorCode::DeviceLost || error.code == ErrorCode::TimedOut; }

Result<Frame> draw(const Scene& scene, Device::Impl& impl) {
  Stopwatch watch;
  RenderCost& cost = impl.cost;
  cost = {};
  const Context& context = *impl.context;
  const uint32_t pipelinesBefore = impl.pipelines->created() + impl.unpack->created();
  double pipelineSecondsBefore = impl.pipelines->seconds() + impl.unpack->seconds();
  // Time since the last lap that no pipeline took.
  const auto lapWithoutPipelines = [&] {
    const double pipelineSeconds = impl.pipelines->seconds() + impl.unpack->seconds() - pipelineSecondsBefore;
    pipelineSecondsBefore += pipelineSeconds;
    cost.pipelineSeconds += pipelineSeconds;
    return watch.lap() - pipelineSeconds;
  };
  if (const Result<void> valid = validate(scene); !valid) return tl::unexpected(valid.error());
  const RenderPlan plan = planOf(scene, context.caps);
  if (const Result<void> offered = checkOffered(scene, plan, context.caps); !offered) {
    return tl::unexpected(offered.error());
  }
  DepthFetch fetch = DepthFetch::Quotient;
  if (plan.depth != VK_FORMAT_UNDEFINED && plan.samples > 1) {
    const Result<DepthFetch> asked = impl.depthFetches->of(plan.depth, plan.samples, *impl.images, *impl.buffers,
                                                           *impl.submission, *impl.unpack);
    if (!asked) return tl::unexpected(asked.error());
    fetch = *asked;
  }
  const PrimitiveSource primitives =
      context.caps.core().geometryShader ? PrimitiveSource::Builtin : PrimitiveSource::Vertex;
  Result<Geometry> geometry = upload(scene, primitives == PrimitiveSource::Vertex, *impl.buffers);
  if (!geometry) return tl::unexpected(geometry.error());
  Result<Attachments> attachments = acquireAttachments(plan, *impl.images, cost);
  if (!attachments) return tl::unexpected(attachments.error());
  const auto abandon = [&] {
    impl.abandonedAttachments = std::move(*attachments);
    impl.abandonedBuffers.push_back(std::move(geometry->buffer));
  };

  const Result<VkCommandBuffer> draws = impl.submission->begin();
  if (!draws) return tl::unexpected(draws.error());
  const Result<void> recorded =
      recordDraws(context, *draws, scene, plan, *attachments, *geometry, primitives, *impl.pipelines);
  if (!recorded) return tl::unexpected(recorded.error());
  cost.passes = static_cast<uint32_t>(plan.passes.size());
  cost.uploadSeconds = lapWithoutPipelines();
  if (const Result<void> drawn = impl.submission->run(); !drawn) {
    abandon();
    return tl::unexpected(drawn.error());
  }
  cost.drawSeconds = watch.lap();

  std::vector<Pool<Buffer>::Lease> buffers;
  ReadbackTools tools{context, *impl.submission, *impl.buffers, *impl.unpack, buffers};
  Result<Frame> frame = readFrame(scene, plan, *attachments, fetch, tools, cost);
  cost.pipelinesCreated = impl.pipelines->created() + impl.unpack->created() - pipelinesBefore;
  cost.readbackSeconds = lapWithoutPipelines();
  if (!frame && isLost(frame.error())) {
    abandon();
    std::move(buffers.begin(), buffers.end(), std::back_inserter(impl.abandonedBuffers));
  }
  return frame;
}

// Nothing that was drawn before may take part in a scene. What llvmpipe does with points outside of a side plane is decided
// for good by the first point that leaves any plane, and by whether the vertex shader of that one chose a viewport: so that
// all scenes are drawn alike, it is always the same one.
Result<void> beginPoints(const Scene& scene, Device::Impl& impl) {
  if (impl.pointsBegun || !drawsPoints(scene.state)) return {};
  impl.pointsBegun = true;
  Scene first;
  first.target.width = first.target.height = 1;
  first.viewport = {0, 0, 1, 1, 0, 1};
  first.state.topology = PrimitiveTopology::POINT_LIST;
  first.draws.push_back({.positions = {{0, 0, 2, 1}}});
  if (const Result<Frame> drawn = draw(first, impl); !drawn) return tl::unexpected(drawn.error());
  return {};
}

Result<Frame> drawAlone(const Scene& scene, Device::Impl& impl) {
  if (const Result<void> begun = beginPoints(scene, impl); !begun) return tl::unexpected(begun.error());
  return draw(scene, impl);
}

}  // namespace

Result<Frame> render(const Scene& scene, Device& device) {
  Device::Impl& impl = device.impl();
  if (impl.broken) return tl::unexpected(*impl.broken);
  try {
    Result<Frame> frame = drawAlone(scene, impl);
    if (!frame && isLost(frame.error())) impl.broken = frame.error();
    return frame;
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::NotOffered, "memory", "the frame needs more host memory than there is",
                "make the target smaller, or take fewer samples or varyings");
  }
}

}  // namespace rasterdiff::vkref
