// Where the time of a scene, or of many, went. All of it is wall-clock time of the process that did the work.
#pragma once

#include <span>

namespace rasterdiff::harness {

/// The parts of a driver's render(); a renderer that is no device only draws.
struct DriverSeconds {
  double drawing = 0;    ///< from the submit of the draws to its fence: whatever the device does then, clears and resolves too
  double pipelines = 0;  ///< in which the driver creates pipelines: what it compiles only when it draws is drawing
  double upload = 0;     ///< everything else before the submit: attachments, vertices, recording
  double readback = 0;   ///< everything after the fence: recording, copying and unpacking on the device, planes on the host
};

struct Seconds {
  double setUp = 0;      ///< of the scene: files, generators, cameras
  double reference = 0;
  double driver = 0;     ///< the whole call; its parts add up to it
  double compare = 0;
  double pictures = 0;   ///< and dumped planes
  DriverSeconds parts;
};

inline Seconds& operator+=(Seconds& sum, const Seconds& more) {
  sum.setUp += more.setUp;
  sum.reference += more.reference;
  sum.driver += more.driver;
  sum.compare += more.compare;
  sum.pictures += more.pictures;
  sum.parts.drawing += more.parts.drawing;
  sum.parts.pipelines += more.parts.pipelines;
  sum.parts.upload += more.parts.upload;
  sum.parts.readback += more.parts.readback;
  return sum;
}

/// Of each part the median; of at least one.
[[nodiscard]] Seconds medianOf(std::span<const Seconds> rounds);

/// All that the harness does beside the driver's own work, which is drawing and making pipelines.
[[nodiscard]] inline double ownSeconds(const Seconds& s) {
  return s.setUp + s.reference + s.driver - s.parts.drawing - s.parts.pipelines + s.compare + s.pictures;
}

}  // namespace rasterdiff::harness
