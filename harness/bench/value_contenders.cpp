// The kernels of index, count, depth and varyings as contenders: each method with the planes that a task can want.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "harness/bench/contender.hpp"
#include "harness/bench/machine.hpp"
#include "rasterizer/kernels/value_kernel.hpp"
#include "rasterizer/kernels/value_methods.hpp"

namespace rasterdiff::harness::bench {
namespace {

using rasterizer::ValueKind;
using rasterizer::ValueMethod;
using rasterizer::ValueNeeds;
using rasterizer::ValueTarget;
using rasterizer::ValueTriangles;

constexpr const char* kDispatched = "value-spans";  ///< chooses an instruction set and can use threads

/// Planes by name; "all" are those of a frame of the reference or the driver.
struct Planes {
  const char* name;
  ValueNeeds needs;
};

std::vector<Planes> planesOf(Task task) {
  switch (task) {
    case Task::Coverage: return {{"index", {true, false, false, 0}}, {"count", {false, true, false, 0}}, {"all", {true, true, false, 0}}};
    case Task::Depth: return {{"depth", {false, false, true, 0}}, {"all", {true, true, true, 0}}};
    case Task::Varyings: return {{"varyings", {true, false, true, kComponents}}, {"all", {true, true, true, kComponents}}};
  }
  return {};
}

/// What all contenders on a load draw.
struct Input {
  const Load* load;
  std::vector<float> depth;
  rasterizer::ValueRows<float> carried;
  std::vector<ValueKind> kinds = std::vector<ValueKind>(kComponents, ValueKind::Perspective);

  Input(const Load& drawn, Attributes attributes)
      : load(&drawn), depth(std::move(attributes.depth)),
        carried(rasterizer::carriedValues(attributes.reciprocalW, attributes.values, kComponents)) {}

  [[nodiscard]] ValueTriangles first(size_t triangles, const ValueNeeds& needs) const {
    ValueTriangles all{std::span(load->triangles).first(triangles), {}, {}, {}};
    if (needs.depth) all.depth = std::span(depth).first(3 * triangles);
    if (needs.components == 0) return all;
    all.carried = carried;
    all.kinds = kinds;
    return all;
  }
};

struct Variant {
  const ValueMethod* method;
  Planes planes;
  Run run;

  void draw(const ValueTriangles& triangles, ValueTarget& target) const {
    const TargetScope scope(run);
    if (run.threads > 1) {
      rasterizer::drawValues(triangles, target, run.threads);
    } else {
      method->draw(triangles, target);
    }
  }
};

Result<ValueTarget> newTarget(const Load& load, const ValueNeeds& needs) {
  return ValueTarget::create(load.width, load.height, load.samples, needs);
}

/// The frame that the reference or the driver would give.
Frame frameOf(const ValueTarget& target) {
  Frame frame;
  frame.width = target.width(), frame.height = target.height(), frame.samples = target.samples();
  frame.primitive = Plane<uint32_t>(frame.width, frame.height, frame.samples);
  frame.count = frame.primitive;
  if (target.needs().depth) frame.depth.emplace(frame.width, frame.height, frame.samples);
  const uint32_t components = target.needs().components;
  if (components > 0) frame.varyings.push_back({"color", Plane<float>(frame.width, frame.height, frame.samples, components), {}});
  for (uint32_t y = 0; y < frame.height; ++y) {
    for (uint32_t x = 0; x < frame.width; ++x) {
      for (uint32_t s = 0; s < frame.samples; ++s) {
        const size_t from = target.index(x, y, s);
        frame.primitive.at(x, y, s) = target.primitive[from];
        frame.count.at(x, y, s) = target.count[from];
        if (frame.depth) frame.depth->at(x, y, s) = target.depth[from];
        for (uint32_t c = 0; c < components; ++c) frame.varyings[0].values.at(x, y, s, c) = target.varyings[c][from];
      }
    }
  }
  return frame;
}

/// Only the planes that `actual` has are judged; `expected` has them all.
ErrorCount difference(const ValueTarget& expected, const ValueTarget& actual) {
  const ValueNeeds& needs = actual.needs();
  ErrorCount error;
  UlpSum ulps;
  for (uint32_t row = 0; row < expected.height() * expected.samples(); ++row) {
    for (uint32_t x = 0; x < expected.width(); ++x) {
      const size_t k = row * expected.stride() + x;
      error.covered += expected.count[k];
      const bool same = !needs.primitive || expected.primitive[k] == actual.primitive[k];
      if (!same || (needs.count && expected.count[k] != actual.count[k])) ++error.wrong;
      if (!same || expected.primitive[k] == 0) continue;
      if (needs.depth) ulps.add(expected.depth[k], actual.depth[k]);
      for (uint32_t c = 0; c < needs.components; ++c) ulps.add(expected.varyings[c][k], actual.varyings[c][k]);
    }
  }
  ulps.put(error);
  return error;
}

Row rowOf(const Variant& variant, Task task) {
  Row row;
  row.task = task;
  row.method = fmt::format("{}/{}", variant.method->name, variant.planes.name);
  row.what = variant.method->what;
  row.exact = variant.method->exact;
  row.threads = variant.run.threads;
  if (variant.method->name == kDispatched) row.target = targetName(variant.run);
  return row;
}

Contender contenderOf(const Variant& variant, Row row, std::shared_ptr<const Input> input, const Settings& settings) {
  Contender contender;
  contender.mostSeconds = settings.kernelSeconds;
  contender.wholeSeconds = settings.kernelWhole;
  contender.rows.push_back(std::move(row));
  const auto target = std::make_shared<std::optional<ValueTarget>>();
  contender.draw = [variant, input, target](size_t triangles) -> Result<std::vector<double>> {
    if (!*target) {
      Result<ValueTarget> made = newTarget(*input->load, variant.planes.needs);
      if (!made) return tl::unexpected(made.error());
      *target = std::move(*made);
    }
    (*target)->clear();
    const ValueTriangles drawn = input->first(std::min(triangles, input->load->triangles.size()), variant.planes.needs);
    return std::vector<double>{secondsOf([&] { variant.draw(drawn, **target); })};
  };
  contender.peak = [variant, input](size_t triangles) {
    const ValueTriangles drawn = input->first(std::min(triangles, input->load->triangles.size()), variant.planes.needs);
    const PeakMeter meter;
    if (auto made = newTarget(*input->load, variant.planes.needs)) variant.draw(drawn, *made);
    return meter.growth();
  };
  return contender;
}

}  // namespace

Result<std::vector<Contender>> valueContenders(const Load& load, Task task, const Truth& truth, const Settings& settings,
                                               Frame* expected) {
  std::vector<Variant> variants;
  for (const ValueMethod& method : rasterizer::valueMethods()) {
    for (const Planes& planes : planesOf(task)) {
      if (method.rounded && std::string_view(planes.name) != "all") continue;  // the yardstick is there for its answer
      if (!chosen(settings, fmt::format("{}/{}", method.name, planes.name)) && !chosen(settings, method.name)) continue;
      for (const Run& run : runsOf(settings, method.name == kDispatched)) variants.push_back({&method, planes, run});
    }
  }
  if (variants.empty() && expected == nullptr) return std::vector<Contender>{};
  const auto input = std::make_shared<const Input>(Input(load, attributesOf(task == Task::Coverage ? 0 : load.triangles.size())));
  const ValueNeeds all = planesOf(task).back().needs;
  Result<ValueTarget> exact = newTarget(load, all);
  if (!exact) return tl::unexpected(exact.error());
  const auto rounded = std::ranges::find_if(rasterizer::valueMethods(), &ValueMethod::rounded);
  rounded->draw(input->first(truth.triangles(), all), *exact);
  std::vector<Contender> contenders;
  for (const Variant& variant : variants) {
    Result<ValueTarget> target = newTarget(load, variant.planes.needs);
    if (!target) return tl::unexpected(target.error());
    variant.draw(input->first(truth.triangles(), variant.planes.needs), *target);
    Row row = rowOf(variant, task);
    row.error = difference(*exact, *target);
    row.error->triangles = truth.triangles();
    if (task == Task::Coverage && row.exact && row.error->wrong > 0)
      row.refused = fmt::format("{} wrong samples in an exact method", row.error->wrong);
    contenders.push_back(contenderOf(variant, std::move(row), input, settings));
  }
  if (expected != nullptr) *expected = frameOf(*exact);
  return contenders;
}

}  // namespace rasterdiff::harness::bench
