#include "harness/hunt/places.hpp"

#include <array>
#include <cmath>
#include <span>

#include "scene/sample_locations.hpp"

namespace rasterdiff::harness::hunt {

double Places::randomSteps(Prng& random) {
  constexpr std::array<double, 8> kSteps{2, 2, 4, 4, 16, 16, 256, 0};
  return kSteps[random.below(kSteps.size())];
}

double Places::snapped(double v) const { return steps_ == 0 ? v : std::round(v * steps_) / steps_; }

Place Places::anywhere() {
  return {snapped(random_.between(-1.0, target_.width + 1.0)), snapped(random_.between(-1.0, target_.height + 1.0))};
}

Place Places::onSample() {
  const std::span<const SampleLocation> table = standardSampleLocations(target_.samples);
  const SampleLocation at = table.empty() ? SampleLocation{8, 8} : table[random_.below(table.size())];
  return {random_.below(target_.width) + at.x / 16.0, random_.below(target_.height) + at.y / 16.0};
}

Place Places::onBorder() {
  constexpr std::array<uint32_t, 4> kTiles{4, 8, 16, 64};  // sizes of the blocks and tiles that rasterizers walk over
  Place place = anywhere();
  const uint32_t tile = kTiles[random_.below(kTiles.size())];
  const auto border = [&](uint32_t extent) {
    if (random_.chance(40)) return random_.chance(50) ? 0.0 : static_cast<double>(extent);
    return static_cast<double>(tile * random_.below(extent / tile + 1));
  };
  const uint32_t axes = random_.below(3);
  if (axes != 0) place.x = border(target_.width);
  if (axes != 1) place.y = border(target_.height);
  return place;
}

Place Places::inLine() {
  const Place a = earlier_.back();
  const double d = snapped(random_.between(-12.0, 12.0));
  switch (random_.below(5)) {
    case 0: return {a.x + d, a.y};
    case 1: return {a.x, a.y + d};
    case 2: return {a.x + d, a.y + d};
    case 3: return {a.x + d, a.y - d};
    default: break;
  }
  const Place b = earlier_.size() > 1 ? earlier_[earlier_.size() - 2] : a;
  constexpr std::array<double, 4> kAlong{0.5, 2, -1, 0.25};
  const double t = kAlong[random_.below(kAlong.size())];
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
}

Place Places::choose() {
  const uint32_t kind = random_.below(100);
  if (!earlier_.empty()) {
    if (kind < 25) {
      const double reach = random_.chance(50) ? 2 : 10;
      const Place a = earlier_.back();
      return {snapped(a.x + random_.between(-reach, reach)), snapped(a.y + random_.between(-reach, reach))};
    }
    if (kind < 40) return inLine();
    if (kind < 48) return earlier_[random_.below(earlier_.size())];
  }
  if (kind < 63) return onSample();
  if (kind < 72) return {std::floor(random_.between(0.0, target_.width + 1.0)), std::floor(random_.between(0.0, target_.height + 1.0))};
  if (kind < 84) return onBorder();
  return anywhere();
}

Place Places::next() {
  Place place = choose();
  if (random_.chance(10)) {
    const double step = 1 / (steps_ == 0 ? 256 : steps_);
    (random_.chance(50) ? place.x : place.y) += random_.chance(50) ? step : -step;
  }
  constexpr size_t kRemembered = 6;
  if (earlier_.size() == kRemembered) earlier_.erase(earlier_.begin());
  earlier_.push_back(place);
  return place;
}

}  // namespace rasterdiff::harness::hunt
