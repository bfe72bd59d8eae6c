// The driver under test, whatever it is: a Vulkan device, a mutant of the reference, a textbook method, a planted fault, a recorded frame.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "harness/compare/seconds.hpp"
#include "scene/frame.hpp"
#include "scene/limits.hpp"
#include "scene/result.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness {

struct SubjectOptions {
  std::string driver = "lavapipe";  ///< "lavapipe", "swiftshader", "PATH.json", "mutant:NAME", "legal:SEED",
                                    ///< "method:NAME", "fault:KIND[=GLOB]"
  bool validate = false;
  double timeoutSeconds = 20;
  std::string profile = "reference";  ///< the profile that mutants, methods and faults are made of; a device ignores it
};

class Subject {
 public:
  virtual ~Subject() = default;
  [[nodiscard]] virtual std::string name() const = 0;  ///< driverName, or "mutant:NAME"
  [[nodiscard]] virtual std::string info() const = 0;  ///< exact version
  [[nodiscard]] virtual const Limits& limits() const = 0;
  [[nodiscard]] virtual Result<Frame> render(const Scene& scene) = 0;
  /// The same of many scenes, each as if it were drawn alone; a device draws many by one submit.
  [[nodiscard]] virtual std::vector<Result<Frame>> renderTogether(std::span<const Scene> scenes);
  /// Where the time of the last render() or renderTogether() went; none where only the whole call is known.
  [[nodiscard]] virtual std::optional<DriverSeconds> driverSeconds() const { return std::nullopt; }
  /// Validation messages so far; empty is clean.
  [[nodiscard]] virtual std::vector<std::string> validationMessages() const { return {}; }
  /// Whatever else a bug report needs: "deviceName", "apiVersion", "manifest".
  [[nodiscard]] virtual std::vector<std::pair<std::string, std::string>> details() const { return {}; }
};

/// "llvmpipe: Mesa 22.3.6 (LLVM 15.0.6), device …, Vulkan 1.3.230": what was tested, in one line.
[[nodiscard]] std::string subjectLine(const Subject& subject);

/// `fault:crash`, `fault:hang`, `fault:lost`, `fault:timeout`, `fault:refuse` are subjects for testing the harness
/// itself: the reference, except that on scenes whose name matches GLOB (default: all) they die by a signal, sleep for
/// ever, or return DeviceLost, TimedOut, NotOffered.
/// Error: NoDevice (no such driver, every candidate refused), BadInput (no such mutant, method, fault or profile).
[[nodiscard]] Result<std::unique_ptr<Subject>> openSubject(const SubjectOptions& options);

}  // namespace rasterdiff::harness
