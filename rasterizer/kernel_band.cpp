#include "rasterizer/kernel_band.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "rasterizer/depth/depth_stage.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr double kPixel = 1.0 / kSubpixelOne;

ValueTarget bandTarget(const Frame& frame, uint32_t rows) {
  ValueNeeds needs;
  needs.primitive = needs.count = true;
  needs.depth = frame.depth.has_value();
  return ValueTarget::create(frame.width, rows, frame.samples, needs).value();
}

}  // namespace

BandTally& BandTally::operator+=(const BandTally& other) {
  rows += other.rows;
  met += other.met, drawn += other.drawn, covered += other.covered, ofCut += other.ofCut, ofMany += other.ofMany;
  return *this;
}

BandDrawer::BandDrawer(const KernelGeometry& geometry, Frame& frame, std::span<const SubpixelPosition> pattern, const Interpolated& clear,
                       BandRows rows, std::unique_ptr<KernelInputs> inputs)
    : geometry_(geometry), frame_(frame), pattern_(pattern), clear_(clear), rows_(rows), target_(bandTarget(frame, rows.rows())),
      inputs_(std::move(inputs)),
      starts_(frame.width + kRowSlack), rowPrimitives_(size_t{frame.samples} * (frame.width + kRowSlack)),
      rowBounds_(frame.depth ? rowPrimitives_.size() : 0) {}

BandTally BandDrawer::draw(uint32_t band, bool counted) {
  const uint32_t firstRow = band << rows_.shift, rows = std::min(rows_.rows(), frame_.height - firstRow);
  gather(band);
  std::ranges::fill(target_.primitive, 0);
  std::ranges::fill(target_.count, 0);
  std::ranges::fill(target_.depth, clear_.value);
  ValueTriangles triangles;
  triangles.positions = positions_;
  triangles.corners = corners_;
  BandTally tally;
  tally.met = drawBand(triangles, target_, firstRow, firstRow + rows, 0);
  if (counted) {
    const TallyArea area{static_cast<int32_t>(frame_.width), static_cast<int32_t>(firstRow), static_cast<int32_t>(firstRow + rows), pattern_};
    tally.rows = tallyRows(positions_, area);
    if (inputs_) countCut(area, tally);
  }
  findRuns(rows);
  for (const SettledRun& run : runs_) tally.covered += run.primitive != 0 ? run.end - run.begin : 0;
  for (uint32_t row = 0; row < rows; ++row) {
    settleRow(row, firstRow + row, row + 1 == rows);
    copyRow(row, firstRow + row, tally);
  }
  return tally;
}

void BandDrawer::countCut(const TallyArea& area, BandTally& tally) {
  std::vector<SnappedTriangle> cut, many;
  for (size_t i = 0; i < origins_.size(); ++i) {
    if (origins_[i].cut) cut.push_back(positions_[i]);
    if (origins_[i].many) many.push_back(positions_[i]);
  }
  tally.ofCut = tallyRows(cut, area).inside;
  tally.ofMany = tallyRows(many, area).inside;
}

void BandDrawer::gather(uint32_t band) {
  constexpr size_t kAhead = 16;
  size_t size = 0;
  for (const KernelPieces& part : geometry_.parts()) size += part.bands[band].size();
  const bool deep = frame_.depth.has_value();
  positions_.resize(size);
  primitives_.resize(size);
  corners_.resize(deep ? size : 0);
  errors_.resize(deep ? size : 0);
  origins_.resize(inputs_ ? size : 0);
  size_t at = 0;
  for (const KernelPieces& part : geometry_.parts()) {
    const std::vector<uint32_t>& pieces = part.bands[band];
    for (size_t i = 0; i < pieces.size(); ++i, ++at) {
      const uint32_t piece = pieces[i], ahead = pieces[std::min(i + kAhead, pieces.size() - 1)];
      __builtin_prefetch(&part.positions[ahead]);
      __builtin_prefetch(&part.primitives[ahead]);
      positions_[at] = part.positions[piece];
      primitives_[at] = part.primitives[piece];
      if (inputs_) origins_[at] = part.origins[piece];
      if (!deep) continue;
      for (const uint32_t corner : part.corners[ahead]) __builtin_prefetch(&geometry_.corner(part, corner));
      DepthCorners& corners = corners_[at];
      CornerErrors errors;
      for (size_t k = 0; k < 3; ++k) {
        const DepthVertex& v = geometry_.corner(part, part.corners[piece][k]);
        corners.x[k] = v.x, corners.y[k] = v.y, corners.z[k] = v.z;
        errors.deviation = std::max(errors.deviation, v.deviation);
        errors.inputError = std::max(errors.inputError, v.error);
      }
      errors_[at] = errors;
    }
  }
}

uint32_t BandDrawer::planeOf(uint32_t number) {
  uint32_t& plane = seen_[number - 1];
  if (plane != 0) return plane;
  seenNumbers_.push_back(number);
  if (inputs_) inputs_->add(primitives_[number - 1], origins_[number - 1]);
  return plane = static_cast<uint32_t>(seenNumbers_.size());
}

// A run of samples with the same piece costs one look at the piece.
void BandDrawer::findRuns(uint32_t rows) {
  runs_.clear();
  rowRuns_.assign(1, 0);
  seen_.assign(positions_.size(), 0);
  seenNumbers_.clear();
  if (inputs_) inputs_->clear();
  for (uint32_t row = 0; row < rows; ++row) {
    for (uint32_t s = 0; s < frame_.samples; ++s) {
      const uint32_t* const numbers = target_.primitive.data() + target_.index(0, row, s);
      const size_t count = rasterizer::findRuns(numbers, frame_.width, starts_.data());
      starts_[count] = frame_.width;
      for (size_t r = 0; r < count; ++r) {
        const uint32_t number = numbers[starts_[r]];
        SettledRun& run = runs_.emplace_back(SettledRun{starts_[r], starts_[r + 1]});
        if (number == 0) continue;
        run.primitive = primitives_[number - 1];
        if (frame_.depth || inputs_) run.plane = planeOf(number);
      }
      rowRuns_.push_back(runs_.size());
    }
  }
  if (inputs_ || !frame_.depth) return;
  planes_.resize(seenNumbers_.size());
  depthPlanes(corners_, errors_, seenNumbers_, planes_);
}

// `last`: nothing may be written behind this row. Behind others the next row is, which overwrites what is too much, unless it is so
// short that there is more of that.
void BandDrawer::settleRow(uint32_t bandRow, uint32_t y, bool last) {
  const uint32_t samples = frame_.samples, width = frame_.width;
  const size_t length = width + kRowSlack, to = frame_.primitive.index(0, y, 0);
  const bool deep = frame_.depth.has_value(), atOnce = samples == 1 && !last && width >= kRowSlack;
  for (uint32_t s = 0; s < samples; ++s) {
    const size_t at = size_t{bandRow} * samples + s;
    const auto runs = std::span<const SettledRun>(runs_).subspan(rowRuns_[at], rowRuns_[at + 1] - rowRuns_[at]);
    SettledRow row{rowPrimitives_.data() + s * length, deep ? rowBounds_.data() + s * length : nullptr};
    if (atOnce) row = {frame_.primitive.data.data() + to, deep ? frame_.depthBounds->data.data() + to : nullptr};
    if (inputs_) inputs_->settle(runs, y, s, target_.primitive.data() + target_.index(0, bandRow, s), target_.primitive.data() + target_.index(0, bandRow, 0));
    settleRuns(runs, inputs_ ? inputs_->planes() : planes_, inputs_ ? inputs_->planesEach() : 1, pattern_[s].x * kPixel, y + pattern_[s].y * kPixel, clear_.bounds, row);
  }
  if (atOnce) return;
  switch (samples) {
    case 1: interleave<1>(y); break;
    case 4: interleave<4>(y); break;
    default: interleave<0>(y);
  }
}

template <size_t kSamples>
void BandDrawer::interleave(uint32_t y) {
  const size_t samples = kSamples == 0 ? frame_.samples : kSamples, width = frame_.width, length = width + kRowSlack;
  const size_t to = frame_.primitive.index(0, y, 0);
  const auto put = [&](auto* out, const auto* rows) {
    for (size_t x = 0; x < width; ++x) {
      for (size_t s = 0; s < samples; ++s) out[x * samples + s] = rows[s * length + x];
    }
  };
  put(frame_.primitive.data.data() + to, rowPrimitives_.data());
  if (frame_.depth) put(frame_.depthBounds->data.data() + to, rowBounds_.data());
}

void BandDrawer::copyRow(uint32_t bandRow, uint32_t y, BandTally& tally) {
  const size_t samples = frame_.samples, width = frame_.width, stride = target_.stride();
  const size_t from = target_.index(0, bandRow, 0), to = frame_.primitive.index(0, y, 0);
  const auto put = [&](auto* out, const auto* rows) {
    if (samples == 1) {
      std::memcpy(out, rows, width * sizeof(*out));
      return;
    }
    for (size_t s = 0; s < samples; ++s) {
      for (size_t x = 0; x < width; ++x) out[x * samples + s] = rows[s * stride + x];
    }
  };
  const uint32_t* const counts = target_.count.data() + from;
  put(frame_.count.data.data() + to, counts);
  for (size_t s = 0; s < samples; ++s) tally.drawn = std::accumulate(counts + s * stride, counts + s * stride + width, tally.drawn);
  if (frame_.depth) put(frame_.depth->data.data() + to, target_.depth.data() + from);
}

}  // namespace rasterdiff::rasterizer
