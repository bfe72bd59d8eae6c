#include "harness/report/time_text.hpp"

#include <fmt/format.h>

#include "harness/report/numbers.hpp"

namespace rasterdiff::harness {

std::string timeText(const Seconds& seconds) {
  const DriverSeconds& parts = seconds.parts;
  std::string text = fmt::format("driver {} (drawing {}, pipelines {}, upload {}, readback {}), reference {}, compare {}, set-up {}",
                                 secondsText(seconds.driver), secondsText(parts.drawing), secondsText(parts.pipelines),
                                 secondsText(parts.upload), secondsText(parts.readback), secondsText(seconds.reference),
                                 secondsText(seconds.compare), secondsText(seconds.setUp));
  if (seconds.pictures > 0) text += fmt::format(", pictures {}", secondsText(seconds.pictures));
  return text;
}

std::string shareText(const Seconds& seconds) {
  std::string text = fmt::format("All but the driver's drawing and pipelines {}", secondsText(ownSeconds(seconds)));
  if (seconds.parts.drawing > 0) text += fmt::format(", {:.2f} times its drawing", ownSeconds(seconds) / seconds.parts.drawing);
  return text;
}

}  // namespace rasterdiff::harness
