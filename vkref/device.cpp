// Opens devices by name or manifest, lists what could be opened, and closes a device whose work may still run.
#include <fmt/format.h>

#include <cmath>

#include "vkref/device_impl.hpp"
#include "vkref/drivers.hpp"
#include "vkref/environment.hpp"

namespace rasterdiff::vkref {
namespace {

constexpr double kClosingSeconds = 5;  ///< for work that a timeout left behind

/// An instance that sees one driver, and the driver's first device that can be used.
struct Opened {
  std::unique_ptr<Instance> instance;
  VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
  Capabilities caps;
};

/// Call with the manifest's environment set. Error: NoDevice.
Result<Opened> openInstance(const std::string& manifest, const std::string& library, bool validate) {
  Result<std::unique_ptr<Instance>> instance = Instance::create(validate);
  if (!instance) return tl::unexpected(instance.error());
  const Result<std::vector<VkPhysicalDevice>> devices = (*instance)->physicalDevices();
  if (!devices) return tl::unexpected(devices.error());
  std::string refusals;
  for (VkPhysicalDevice physicalDevice : *devices) {
    Result<Capabilities> caps = inspect(physicalDevice);
    if (!caps) {
      refusals += (refusals.empty() ? "" : "; ") + caps.error().what;
      continue;
    }
    caps->driver.manifest = manifest;
    caps->driver.library = library;
    return Opened{std::move(*instance), physicalDevice, std::move(*caps)};
  }
  return fail(ErrorCode::NoDevice, manifest, refusals);
}

Result<std::unique_ptr<Device>> openManifest(const std::string& manifest, const DeviceOptions& options) {
  const Result<std::string> library = checkManifest(manifest);
  if (!library) return tl::unexpected(library.error());
  const ScopedEnvironment environment(environmentFor(manifest));
  Result<Opened> opened = openInstance(manifest, *library, options.validate);
  if (!opened) return tl::unexpected(opened.error());

  auto impl = std::make_unique<Device::Impl>();
  impl->instance = std::move(opened->instance);
  Result<std::unique_ptr<Context>> context = Context::create(opened->physicalDevice, std::move(opened->caps));
  if (!context) return tl::unexpected(context.error());
  impl->context = std::move(*context);
  const Context& made = *impl->context;
  Result<std::unique_ptr<PipelineCache>> pipelines = PipelineCache::create(made);
  if (!pipelines) return tl::unexpected(pipelines.error());
  impl->pipelines = std::move(*pipelines);
  impl->mostPipelines = options.mostPipelines;
  Result<std::unique_ptr<Unpack>> unpack = Unpack::create(made, impl->pipelines->driverCache());
  if (!unpack) return tl::unexpected(unpack.error());
  impl->unpack = std::move(*unpack);
  Result<std::unique_ptr<Submission>> submission = Submission::create(made, options.timeoutSeconds);
  if (!submission) return tl::unexpected(submission.error());
  impl->submission = std::move(*submission);
  impl->depthFetches = std::make_unique<DepthFetches>(made);
  impl->images = std::make_unique<Pool<Image>>(made, kIdleImageBytes);
  impl->buffers = std::make_unique<Pool<Buffer>>(made, kIdleBufferBytes);
  return std::make_unique<Device>(std::move(impl));
}

std::string installHint(const std::string& driver) {
  for (const KnownDriver& known : knownDrivers()) {
    if (driver == known.name) return std::string(known.install);
  }
  return "`rasterdiff devices` lists what can be used";
}

DriverCandidate probe(std::string name, const std::string& manifest) {
  DriverCandidate candidate;
  candidate.name = std::move(name);
  candidate.manifest = manifest;
  const auto refuse = [&candidate](const Error& error) {
    candidate.refusal = error.hint.empty() ? error.what : fmt::format("{} ({})", error.what, error.hint);
    return candidate;
  };
  const Result<std::string> library = checkManifest(manifest);
  if (!library) return refuse(library.error());
  const ScopedEnvironment environment(environmentFor(manifest));
  Result<Opened> opened = openInstance(manifest, *library, false);
  if (!opened) return refuse(opened.error());
  candidate.usable = true;
  candidate.driver = opened->caps.driver;
  candidate.limits = opened->caps.limits;
  candidate.facts = factsOf(opened->physicalDevice);
  return candidate;
}

}  // namespace

Result<std::unique_ptr<Device>> openDevice(const DeviceOptions& options) {
  if (!(options.timeoutSeconds > 0)) {
    return fail(ErrorCode::BadInput, "timeout", "a timeout must be a positive number of seconds");
  }
  const Result<std::vector<std::string>> manifests = manifestsOf(options.driver);
  if (!manifests) return tl::unexpected(manifests.error());
  if (manifests->empty()) {
    return fail(ErrorCode::NoDevice, options.driver, fmt::format("{} is not installed", options.driver),
                installHint(options.driver));
  }
  std::string refusals, hint;
  for (const std::string& manifest : *manifests) {
    Result<std::unique_ptr<Device>> device = openManifest(manifest, options);
    if (device) return device;
    refusals += fmt::format("{}{}: {}", refusals.empty() ? "" : "; ", manifest, device.error().what);
    if (!device.error().hint.empty()) hint = device.error().hint;
  }
  return fail(ErrorCode::NoDevice, options.driver, refusals, hint.empty() ? installHint(options.driver) : hint);
}

std::vector<DriverCandidate> listDrivers() {
  std::vector<DriverCandidate> candidates;
  for (const KnownDriver& known : knownDrivers()) {
    const std::string name(known.name);
    const Result<std::vector<std::string>> manifests = manifestsOf(name);
    if (!manifests || manifests->empty()) {
      DriverCandidate missing;
      missing.name = name;
      missing.refusal = fmt::format("not installed ({})", known.install);
      candidates.push_back(std::move(missing));
      continue;
    }
    for (const std::string& manifest : *manifests) candidates.push_back(probe(name, manifest));
  }
  for (const std::string& manifest : otherManifests()) candidates.push_back(probe(manifest, manifest));
  return candidates;
}

Device::Device(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Device::~Device() {
  if (impl_->submission->settle(kClosingSeconds)) return;
  // The driver hangs: destroying what it still uses could crash or never return, so all of it stays until the end.
  static auto& hung = *new std::vector<std::unique_ptr<Impl>>;
  hung.push_back(std::move(impl_));
}

const DriverInfo& Device::driver() const { return impl_->context->caps.driver; }
const Limits& Device::limits() const { return impl_->context->caps.limits; }
const RenderCost& Device::lastCost() const { return impl_->cost; }
const std::vector<std::string>& Device::validationMessages() const { return impl_->instance->log().validation; }

}  // namespace rasterdiff::vkref
