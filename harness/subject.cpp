#include "harness/subject.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <charconv>
#include <chrono>
#include <csignal>
#include <optional>
#include <string_view>
#include <thread>

#include "rasterizer/legal/legal_rules.hpp"
#include "rasterizer/mistakes/played_device.hpp"
#include "harness/infer/synthetic.hpp"
#include "harness/method_subject.hpp"
#include "rasterizer/render.hpp"
#include "vkref/device.hpp"

namespace rasterdiff::harness {
namespace {

class DeviceSubject final : public Subject {
 public:
  explicit DeviceSubject(std::unique_ptr<vkref::Device> device) : device_(std::move(device)) {}

  std::string name() const override { return device_->driver().name; }
  std::string info() const override { return device_->driver().info; }
  const Limits& limits() const override { return device_->limits(); }
  Result<Frame> render(const Scene& scene) override { return vkref::render(scene, *device_); }
  std::vector<Result<Frame>> renderTogether(std::span<const Scene> scenes) override { return vkref::renderTogether(scenes, *device_); }
  std::optional<DriverSeconds> driverSeconds() const override {
    const vkref::RenderCost& cost = device_->lastCost();
    return DriverSeconds{cost.drawSeconds, cost.pipelineSeconds, cost.uploadSeconds, cost.readbackSeconds};
  }
  std::vector<std::string> validationMessages() const override { return device_->validationMessages(); }
  std::vector<std::pair<std::string, std::string>> details() const override {
    const vkref::DriverInfo& driver = device_->driver();
    return {{"deviceName", driver.deviceName}, {"apiVersion", driver.apiVersion}, {"manifest", driver.manifest}};
  }

 private:
  std::unique_ptr<vkref::Device> device_;
};

/// The reference with one deliberate mistake, with other legal choices, or with rules of its own.
class VariantSubject final : public Subject {
 public:
  VariantSubject(std::string name, std::string what, rasterizer::Rules rules)
      : name_(std::move(name)), what_(std::move(what)), rules_(std::move(rules)) {}

  std::string name() const override { return name_; }
  std::string info() const override { return what_; }
  const Limits& limits() const override { return rules_.limits; }
  Result<Frame> render(const Scene& scene) override { return rasterizer::render(scene, rules_); }

 private:
  std::string name_, what_;
  rasterizer::Rules rules_;
};

enum class Fault { Crash, Hang, Lost, Timeout, Refuse };

std::optional<Fault> faultByName(std::string_view name) {
  if (name == "crash") return Fault::Crash;
  if (name == "hang") return Fault::Hang;
  if (name == "lost") return Fault::Lost;
  if (name == "timeout") return Fault::Timeout;
  if (name == "refuse") return Fault::Refuse;
  return std::nullopt;
}

/// The reference, except on the scenes that the fault was planted in.
class FaultSubject final : public Subject {
 public:
  FaultSubject(std::string name, Fault fault, std::string glob, rasterizer::Rules rules)
      : name_(std::move(name)), fault_(fault), glob_(std::move(glob)), rules_(std::move(rules)) {}

  std::string name() const override { return name_; }
  std::string info() const override { return "self-test of the harness"; }
  const Limits& limits() const override { return rules_.limits; }
  Result<Frame> render(const Scene& scene) override {
    if (fnmatch(glob_.c_str(), scene.name.c_str(), 0) != 0) return rasterizer::render(scene, rules_);
    switch (fault_) {
      case Fault::Crash: std::raise(SIGSEGV); break;
      case Fault::Hang:
        for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
      case Fault::Lost: return fail(ErrorCode::DeviceLost, name_, "the planted fault lost the device");
      case Fault::Timeout: return fail(ErrorCode::TimedOut, name_, "the planted fault let the submit time out");
      case Fault::Refuse: return fail(ErrorCode::NotOffered, name_, "the planted fault offers nothing");
    }
    return fail(ErrorCode::DeviceLost, name_, "the planted signal was ignored");
  }

 private:
  std::string name_;
  Fault fault_;
  std::string glob_;
  rasterizer::Rules rules_;
};

Result<std::unique_ptr<Subject>> openMutant(const SubjectOptions& options, std::string_view name) {
  const std::optional<rasterizer::DeliberateError> error = rasterizer::deliberateErrorByName(name);
  if (!error || *error == rasterizer::DeliberateError::None) {
    return fail(ErrorCode::BadInput, "--driver", fmt::format("there is no mutant named '{}'", name),
                "rasterdiff list --mutants");
  }
  Result<rasterizer::Rules> rules = rasterizer::Rules::profile(options.profile, rasterizer::playedDevice(*error));
  if (!rules) return tl::unexpected(rules.error());
  rules->error = *error;
  std::string what;
  for (const rasterizer::DeliberateErrorInfo& known : rasterizer::deliberateErrors()) {
    if (known.error == *error) what = known.what;
  }
  return std::make_unique<VariantSubject>(options.driver, std::move(what), std::move(*rules));
}

Result<std::unique_ptr<Subject>> openLegal(const SubjectOptions& options, std::string_view seed) {
  uint64_t number = 0;
  const auto [end, error] = std::from_chars(seed.data(), seed.data() + seed.size(), number);
  if (error != std::errc{} || end != seed.data() + seed.size()) {
    return fail(ErrorCode::BadInput, "--driver", fmt::format("'{}' is no number of a legal renderer", seed), "legal:1, legal:2, …");
  }
  rasterizer::Rules rules = rasterizer::legalRules(number);
  std::string what = rasterizer::describe(rules);
  return std::make_unique<VariantSubject>(options.driver, std::move(what), std::move(rules));
}

Result<std::unique_ptr<Subject>> openFault(const SubjectOptions& options, std::string_view name) {
  const size_t equals = name.find('=');
  const std::optional<Fault> fault = faultByName(name.substr(0, equals));
  if (!fault) {
    return fail(ErrorCode::BadInput, "--driver", fmt::format("there is no fault named '{}'", name),
                "faults: crash, hang, lost, timeout, refuse, each with =GLOB for some scenes only");
  }
  Result<rasterizer::Rules> rules = rasterizer::Rules::profile(options.profile, Limits{});
  if (!rules) return tl::unexpected(rules.error());
  std::string glob(equals == std::string_view::npos ? "*" : name.substr(equals + 1));
  return std::make_unique<FaultSubject>(options.driver, *fault, std::move(glob), std::move(*rules));
}

Result<std::unique_ptr<Subject>> openSynthetic(const SubjectOptions& options, std::string_view seed) {
  uint64_t value = 0;
  const auto [end, wrong] = std::from_chars(seed.data(), seed.data() + seed.size(), value);
  if (wrong != std::errc{} || end != seed.data() + seed.size()) {
    return fail(ErrorCode::BadInput, "--driver", fmt::format("'{}' is no seed", seed), "a whole number, as in synthetic:7");
  }
  return std::make_unique<VariantSubject>(options.driver, "random rules", syntheticRules(value));
}

}  // namespace

std::vector<Result<Frame>> Subject::renderTogether(std::span<const Scene> scenes) {
  std::vector<Result<Frame>> frames;
  for (const Scene& scene : scenes) frames.push_back(render(scene));
  return frames;
}

std::string subjectLine(const Subject& subject) {
  std::string line = subject.name();
  if (!subject.info().empty()) line += ": " + subject.info();
  for (const auto& [name, value] : subject.details()) {
    if (value.empty() || name == "manifest") continue;
    line += (name == "apiVersion" ? ", Vulkan " : ", ") + value;
  }
  return line;
}

Result<std::unique_ptr<Subject>> openSubject(const SubjectOptions& options) {
  constexpr std::string_view kSynthetic = "synthetic:";
  constexpr std::string_view kMutant = "mutant:", kLegal = "legal:", kFault = "fault:", kMethod = "method:";
  if (options.driver.starts_with(kLegal)) {
    return openLegal(options, std::string_view(options.driver).substr(kLegal.size()));
  }
  if (options.driver.starts_with(kMethod)) {
    return openMethod(options, std::string_view(options.driver).substr(kMethod.size()));
  }
  if (options.driver.starts_with(kMutant)) {
    return openMutant(options, std::string_view(options.driver).substr(kMutant.size()));
  }
  if (options.driver.starts_with(kFault)) {
    return openFault(options, std::string_view(options.driver).substr(kFault.size()));
  }
  if (options.driver.starts_with(kSynthetic)) {
    return openSynthetic(options, std::string_view(options.driver).substr(kSynthetic.size()));
  }
  Result<std::unique_ptr<vkref::Device>> device =
      vkref::openDevice({options.driver, options.validate, options.timeoutSeconds});
  if (!device) return tl::unexpected(device.error());
  return std::make_unique<DeviceSubject>(std::move(*device));
}

}  // namespace rasterdiff::harness
