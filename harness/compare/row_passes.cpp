#include "harness/compare/row_passes.hpp"

#include "rasterizer/choice_table.hpp"
#include "scene/stopwatch.hpp"

namespace rasterdiff::harness {

RowPasses::RowPasses(const Scene& scene, const rasterizer::Rules& rules, const Frame& actual)
    : actual_(actual), mayOverlapItself_(mayOverlapItself(scene, rasterizer::rulesFor(scene, rules))) {}

void RowPasses::judge(const Frame& reference, uint32_t first, uint32_t end) {
  if (!alike(reference, actual_) || reference.primitive.data.size() > kSamplesAtOnce) return;
  Stopwatch watch;
  std::map<uint32_t, SamplePass>::node_type pass;
  {
    const std::scoped_lock lock(mutex_);
    pass = endingAt_.extract(first);
  }
  if (pass.empty()) {
    std::map<uint32_t, SamplePass> fresh;
    fresh.try_emplace(first, reference, actual_, mayOverlapItself_);
    pass = fresh.extract(first);
  }
  pass.mapped().run(reference.primitive.index(0, first, 0), reference.primitive.index(0, end, 0));
  pass.key() = end;
  const std::scoped_lock lock(mutex_);
  endingAt_.insert(std::move(pass));
  rows_ += end - first;
  seconds_ += watch.lap();
}

bool RowPasses::addTo(SamplePass& pass) const {
  if (rows_ != actual_.height) return false;
  for (const auto& [end, rows] : endingAt_) pass.append(rows);
  return true;
}

}  // namespace rasterdiff::harness
