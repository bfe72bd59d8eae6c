// Scenes on one device: plan, upload, draw, read back; one, or some by one submit.
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

constexpr uint64_t kTogetherBytes = uint64_t{32} << 20;  ///< of the planes of scenes that are drawn by one submit
constexpr size_t kTogether = 64;                          ///< scenes, at most

/// The device may still use whatever it was given, and can draw no further scene.
bool isLost(const Error& error) { return error.code == ErrorCode::DeviceLost || error.code == ErrorCode::TimedOut; }

/// A scene with all that its draws need.
struct Prepared {
  const Scene* scene = nullptr;
  size_t place = 0;  ///< among those that are drawn together
  RenderPlan plan;
  DepthFetch fetch = DepthFetch::Quotient;
  Geometry geometry;
  Attachments attachments;
};

PrimitiveSource primitiveSource(const Context& context) {
  return context.caps.core().geometryShader ? PrimitiveSource::Builtin : PrimitiveSource::Vertex;
}

Result<Prepared> prepare(const Scene& scene, size_t place, Device::Impl& impl) {
  const Context& context = *impl.context;
  if (const Result<void> valid = validate(scene); !valid) return tl::unexpected(valid.error());
  Prepared made;
  made.scene = &scene;
  made.place = place;
  made.plan = planOf(scene, context.caps);
  if (const Result<void> offered = checkOffered(scene, made.plan, context.caps); !offered) return tl::unexpected(offered.error());
  if (made.plan.depth != VK_FORMAT_UNDEFINED && made.plan.samples > 1) {
    const Result<DepthFetch> asked = impl.depthFetches->of(made.plan.depth, made.plan.samples, *impl.images, *impl.buffers,
                                                           *impl.submission, *impl.unpack);
    if (!asked) return tl::unexpected(asked.error());
    made.fetch = *asked;
  }
  Result<Geometry> geometry = upload(scene, primitiveSource(context) == PrimitiveSource::Vertex, *impl.buffers);
  if (!geometry) return tl::unexpected(geometry.error());
  made.geometry = std::move(*geometry);
  Result<Attachments> attachments = acquireAttachments(made.plan, *impl.images, impl.cost);
  if (!attachments) return tl::unexpected(attachments.error());
  made.attachments = std::move(*attachments);
  return made;
}

/// Some scenes by one submit, with their frames or errors by place.
class Together {
 public:
  explicit Together(Device::Impl& impl)
      : impl_(impl), pipelinesBefore_(impl.pipelines->created() + impl.unpack->created()), pipelineSeconds_(pipelineSeconds()) {}

  std::vector<Result<Frame>> draw(std::span<const Scene* const> scenes) {
    frames_.resize(scenes.size());
    std::vector<Prepared> prepared;
    for (size_t i = 0; i < scenes.size(); ++i) {
      Result<Prepared> made = prepare(*scenes[i], i, impl_);
      if (made) {
        prepared.push_back(std::move(*made));
      } else if (isLost(made.error())) {
        frames_.assign(scenes.size(), tl::unexpected(made.error()));
        return std::move(frames_);
      } else {
        frames_[i] = tl::unexpected(made.error());
      }
    }
    if (const Result<void> drawn = drawAll(std::move(prepared)); !drawn) give(drawn.error());
    impl_.cost.pipelinesCreated += impl_.pipelines->created() + impl_.unpack->created() - pipelinesBefore_;
    return std::move(frames_);
  }

 private:
  [[nodiscard]] double pipelineSeconds() const { return impl_.pipelines->seconds() + impl_.unpack->seconds(); }

  /// Time since the last lap that no pipeline took.
  double lapWithoutPipelines() {
    const double made = pipelineSeconds() - pipelineSeconds_;
    pipelineSeconds_ += made;
    impl_.cost.pipelineSeconds += made;
    return watch_.lap() - made;
  }

  Result<void> drawAll(std::vector<Prepared> prepared) {
    impl_.pipelines->dropIfMore(impl_.mostPipelines);  // what was drawn before has ended
    const Result<VkCommandBuffer> commands = impl_.submission->begin();
    if (!commands) {
      recorded_ = std::move(prepared);
      return tl::unexpected(commands.error());
    }
    for (Prepared& made : prepared) {
      const Result<void> recorded = recordDraws(*impl_.context, *commands, *made.scene, made.plan, made.attachments, made.geometry,
                                                primitiveSource(*impl_.context), *impl_.pipelines);
      if (recorded) {
        impl_.cost.passes += static_cast<uint32_t>(made.plan.passes.size());
        recorded_.push_back(std::move(made));
      } else {
        // Passes that it recorded before are drawn, and read by nobody.
        frames_[made.place] = tl::unexpected(recorded.error());
        unread_.push_back(std::move(made));
      }
    }
    impl_.cost.uploadSeconds += lapWithoutPipelines();
    if (recorded_.empty()) return {};
    if (const Result<void> drawn = impl_.submission->run(); !drawn) {
      abandon();
      return drawn;
    }
    impl_.cost.drawSeconds += watch_.lap();
    return read();
  }

  Result<void> read() {
    std::vector<DrawnScene> drawn;
    for (const Prepared& made : recorded_) drawn.push_back({made.scene, &made.plan, &made.attachments, made.fetch});
    std::vector<Pool<Buffer>::Lease> buffers;
    ReadbackTools tools{*impl_.context, *impl_.submission, *impl_.buffers, *impl_.unpack, buffers};
    Result<std::vector<Frame>> read = readFrames(drawn, tools, impl_.cost);
    impl_.cost.readbackSeconds += lapWithoutPipelines();
    if (read) {
      for (size_t k = 0; k < recorded_.size(); ++k) frames_[recorded_[k].place] = std::move((*read)[k]);
      return {};
    }
    if (isLost(read.error())) {
      abandon();
      std::move(buffers.begin(), buffers.end(), std::back_inserter(impl_.abandonedBuffers));
    }
    return tl::unexpected(read.error());
  }

  void abandon() {
    for (std::vector<Prepared>* all : {&recorded_, &unread_}) {
      for (Prepared& made : *all) {
        impl_.abandonedAttachments.push_back(std::move(made.attachments));
        impl_.abandonedBuffers.push_back(std::move(made.geometry.buffer));
      }
    }
  }

  /// Whose the error is, is known of one scene, and does not matter if the device is lost.
  void give(const Error& error) {
    const bool all = isLost(error) || recorded_.size() == 1;
    for (const Prepared& made : recorded_) {
      frames_[made.place] = all ? tl::unexpected(error) : std::move(Together(impl_).draw(std::span(&made.scene, 1)).front());
    }
  }

  Device::Impl& impl_;
  Stopwatch watch_;
  uint32_t pipelinesBefore_;
  double pipelineSeconds_;
  std::vector<Result<Frame>> frames_;
  std::vector<Prepared> recorded_, unread_;
};

// Nothing that was drawn before may take part in a scene. What llvmpipe does with points outside of a side plane is decided
// for good by the first point that leaves any plane, and by whether the vertex shader of that one chose a viewport: so that
// all scenes are drawn alike, it is always the same one.
Result<void> beginPoints(std::span<const Scene* const> scenes, Device::Impl& impl) {
  if (impl.pointsBegun || std::ranges::none_of(scenes, [](const Scene* scene) { return drawsPoints(scene->state); })) return {};
  impl.pointsBegun = true;
  Scene first;
  first.target.width = first.target.height = 1;
  first.viewport = {0, 0, 1, 1, 0, 1};
  first.state.topology = PrimitiveTopology::POINT_LIST;
  first.draws.push_back({.positions = {{0, 0, 2, 1}}});
  const Scene* const scene = &first;
  const Result<Frame> drawn = std::move(Together(impl).draw(std::span(&scene, 1)).front());
  impl.cost = {};
  if (!drawn) return tl::unexpected(drawn.error());
  return {};
}

/// Appends the frames of scenes that are drawn by one submit.
void drawGroup(std::span<const Scene* const> scenes, Device::Impl& impl, std::vector<Result<Frame>>& frames) {
  std::vector<Result<Frame>> drawn;
  const auto forAll = [&](const Error& error) {
    drawn.assign(scenes.size(), Result<Frame>(tl::unexpected(error)));
  };
  try {
    if (impl.broken) {
      forAll(*impl.broken);
    } else if (const Result<void> begun = beginPoints(scenes, impl); !begun) {
      forAll(begun.error());
    } else {
      drawn = Together(impl).draw(scenes);
    }
  } catch (const std::bad_alloc&) {
    forAll({ErrorCode::NotOffered, "memory", "the frame needs more host memory than there is",
            "make the target smaller, or take fewer samples or varyings"});
  }
  for (Result<Frame>& frame : drawn) {
    if (!frame && isLost(frame.error())) impl.broken = frame.error();
    frames.push_back(std::move(frame));
  }
}

/// Of its planes, roughly; of a scene that is not valid, any.
uint64_t bytesOf(const Scene& scene) {
  uint64_t components = scene.target.depthFormat ? 3 : 2;
  if (!scene.draws.empty()) {
    for (const Varying& varying : scene.draws[0].varyings) components += varying.components;
  }
  return uint64_t{scene.target.width} * scene.target.height * scene.target.samples * 4 * (components + 4 * scene.builtIns.size());
}

}  // namespace

Result<Frame> render(const Scene& scene, Device& device) {
  device.impl().cost = {};
  std::vector<Result<Frame>> frames;
  const Scene* const one = &scene;
  drawGroup(std::span(&one, 1), device.impl(), frames);
  return std::move(frames.front());
}

std::vector<Result<Frame>> renderTogether(std::span<const Scene> scenes, Device& device) {
  device.impl().cost = {};
  std::vector<Result<Frame>> frames;
  frames.reserve(scenes.size());
  std::vector<const Scene*> group;
  uint64_t bytes = 0;
  const auto draw = [&] {
    if (!group.empty()) drawGroup(group, device.impl(), frames);
    group.clear();
    bytes = 0;
  };
  for (const Scene& scene : scenes) {
    const uint64_t own = bytesOf(scene);
    if (group.size() == kTogether || own > kTogetherBytes - std::min(bytes, kTogetherBytes)) draw();
    group.push_back(&scene);
    bytes += std::min(own, kTogetherBytes);
  }
  draw();
  return frames;
}

}  // namespace rasterdiff::vkref
