#include "rasterizer/kernel_band.hpp"

#include <algorithm>
#include <numeric>

#include "rasterizer/depth/depth_stage.hpp"
#include "rasterizer/fragment/triangle_plane.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr double kPixel = 1.0 / kSubpixelOne;

ValueTarget bandTarget(const Frame& frame, uint32_t rows) {
  ValueNeeds needs;
  needs.primitive = needs.count = true;
  needs.depth = frame.depth.has_value();
  return ValueTarget::create(frame.width, rows, frame.samples, needs).value();
}

LinearFunction depthPlane(const DepthCorners& c, const CornerErrors& errors) {
  std::array<FramebufferPosition, 3> corners;
  for (size_t i = 0; i < 3; ++i) corners[i] = {c.x[i], c.y[i], c.z[i]};
  return TrianglePlane(corners, errors.deviation).through(c.z, errors.inputError, 0);
}

}  // namespace

BandTally& BandTally::operator+=(const BandTally& other) {
  rows += other.rows;
  met += other.met, drawn += other.drawn, covered += other.covered;
  return *this;
}

BandDrawer::BandDrawer(Frame& frame, std::span<const SubpixelPosition> pattern, const Interpolated& clear, uint32_t rows)
    : frame_(frame), pattern_(pattern), clear_(clear), target_(bandTarget(frame, rows)), starts_(frame.width + kRowSlack) {
  const size_t size = size_t{frame.samples} * (frame.width + kRowSlack);
  primitives_.resize(size);
  lo_.resize(size);
  hi_.resize(size);
}

BandTally BandDrawer::draw(std::span<const BandPieces* const> lists, uint32_t firstRow, uint32_t endRow, bool counted) {
  std::ranges::fill(target_.primitive, 0);
  std::ranges::fill(target_.count, 0);
  std::ranges::fill(target_.depth, clear_.value);
  BandTally tally;
  uint32_t before = 0;
  for (const BandPieces* pieces : lists) {
    ValueTriangles triangles;
    triangles.positions = pieces->positions;
    triangles.corners = pieces->corners;
    tally.met += drawBand(triangles, target_, firstRow, endRow, before);
    before += static_cast<uint32_t>(pieces->positions.size());
    if (!counted) continue;
    tally.rows += tallyRows(pieces->positions, {static_cast<int32_t>(frame_.width), static_cast<int32_t>(firstRow),
                                                static_cast<int32_t>(endRow), pattern_});
  }
  planeOf_.assign(before, 0);
  planes_.clear();
  planes_.reserve(before);  // so that pointers to them stay valid
  for (uint32_t y = firstRow; y < endRow; ++y) settleRow(lists, firstRow, y, tally);
  return tally;
}

BandDrawer::Piece BandDrawer::pieceOf(std::span<const BandPieces* const> lists, uint32_t piece) {
  if (piece == 0) return {0, nullptr};
  size_t at = piece - 1;
  for (const BandPieces* pieces : lists) {
    if (at >= pieces->positions.size()) {
      at -= pieces->positions.size();
      continue;
    }
    if (!frame_.depth) return {pieces->primitives[at], nullptr};
    uint32_t& plane = planeOf_[piece - 1];
    if (plane == 0) {
      planes_.push_back(depthPlane(pieces->corners[at], pieces->errors[at]));
      plane = static_cast<uint32_t>(planes_.size());
    }
    return {pieces->primitives[at], &planes_[plane - 1]};
  }
  return {0, nullptr};
}

// A run of samples with the same piece costs one look at the piece.
void BandDrawer::settleRow(std::span<const BandPieces* const> lists, uint32_t firstRow, uint32_t y, BandTally& tally) {
  const size_t samples = frame_.samples, width = frame_.width, length = width + kRowSlack;
  const bool deep = frame_.depth.has_value();
  for (uint32_t s = 0; s < samples; ++s) {
    const uint32_t* const pieces = target_.primitive.data() + target_.index(0, y - firstRow, s);
    runs_.resize(findRuns(pieces, width, starts_.data()));
    for (size_t r = 0; r < runs_.size(); ++r) {
      const uint32_t begin = starts_[r], end = r + 1 < runs_.size() ? starts_[r + 1] : static_cast<uint32_t>(width);
      const Piece known = pieceOf(lists, pieces[begin]);
      runs_[r] = {begin, end, known.primitive, known.depth};
      tally.covered += pieces[begin] != 0 ? end - begin : 0;
    }
    const SettledRow row{primitives_.data() + s * length, deep ? lo_.data() + s * length : nullptr, hi_.data() + s * length};
    settleRuns(runs_, pattern_[s].x * kPixel, y + pattern_[s].y * kPixel, clear_.bounds, row);
  }
  switch (samples) {
    case 1: writeRow<1>(y - firstRow, y, tally); break;
    case 4: writeRow<4>(y - firstRow, y, tally); break;
    default: writeRow<0>(y - firstRow, y, tally);
  }
}

template <size_t kSamples>
void BandDrawer::writeRow(uint32_t bandRow, uint32_t y, BandTally& tally) {
  const size_t samples = kSamples == 0 ? frame_.samples : kSamples, width = frame_.width, length = width + kRowSlack;
  const size_t from = target_.index(0, bandRow, 0), to = frame_.primitive.index(0, y, 0), stride = target_.stride();
  const auto interleave = [&](auto* out, const auto& at) {
    for (size_t x = 0; x < width; ++x) {
      for (size_t s = 0; s < samples; ++s) out[x * samples + s] = at(s, x);
    }
  };
  const uint32_t* const counts = target_.count.data() + from;
  const uint32_t* const primitives = primitives_.data();
  interleave(frame_.primitive.data.data() + to, [&](size_t s, size_t x) { return primitives[s * length + x]; });
  interleave(frame_.count.data.data() + to, [&](size_t s, size_t x) { return counts[s * stride + x]; });
  uint64_t drawn = 0;
  for (size_t s = 0; s < samples; ++s) drawn = std::accumulate(counts + s * stride, counts + s * stride + width, drawn);
  tally.drawn += drawn;
  if (!frame_.depth) return;
  const float* const depths = target_.depth.data() + from;
  const float *const lo = lo_.data(), *const hi = hi_.data();
  interleave(frame_.depth->data.data() + to, [&](size_t s, size_t x) { return depths[s * stride + x]; });
  interleave(frame_.depthBounds->data.data() + to, [&](size_t s, size_t x) { return Bounds{lo[s * length + x], hi[s * length + x]}; });
}

}  // namespace rasterdiff::rasterizer
