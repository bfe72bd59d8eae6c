// A subject that adds up the time of its renders.
#pragma once

#include "harness/subject.hpp"

namespace rasterdiff::harness::cli {

/// Draws with `subject`, which it must not outlive.
class MeteredSubject final : public Subject {
 public:
  explicit MeteredSubject(Subject& subject) : subject_(subject) {}

  std::string name() const override { return subject_.name(); }
  std::string info() const override { return subject_.info(); }
  const Limits& limits() const override { return subject_.limits(); }
  Result<Frame> render(const Scene& scene) override;
  std::vector<Result<Frame>> renderTogether(std::span<const Scene> scenes) override;
  std::optional<DriverSeconds> driverSeconds() const override { return subject_.driverSeconds(); }
  std::vector<std::string> validationMessages() const override { return subject_.validationMessages(); }
  std::vector<std::pair<std::string, std::string>> details() const override { return subject_.details(); }

  /// Of the renders so far: `driver` and its parts. A call that failed, or of which the parts are unknown, is drawing.
  [[nodiscard]] const Seconds& seconds() const { return seconds_; }

 private:
  /// Adds what a call took; `drew`: something came of it.
  void add(double seconds, bool drew);

  Subject& subject_;
  Seconds seconds_;
};

}  // namespace rasterdiff::harness::cli
