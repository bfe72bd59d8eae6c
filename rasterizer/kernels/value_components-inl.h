// From sums along runs (value_run_sums-inl.h) to varyings of neighbouring pixels, which all are of one run or each of its own: runs are
// spread to pixels by permutations; for the instruction set being compiled.
#if defined(RASTERDIFF_VALUE_COMPONENTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_COMPONENTS_INL_H
#undef RASTERDIFF_VALUE_COMPONENTS_INL_H
#else
#define RASTERDIFF_VALUE_COMPONENTS_INL_H
#endif

#include <bit>
#include <cstdint>

#include "hwy/cache_control.h"
#include "rasterizer/kernels/value_run_sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

// A line: pixels whose floats are stored at once.
#if HWY_TARGET <= HWY_AVX3
using LineF = hn::CappedTag<float, 16>;
#else
using LineF = ShadeF;
#endif
inline constexpr size_t kLinePixels = hn::MaxLanes(LineF()), kLineParts = kLinePixels / kShadeLanes;

/// Which of eight neighbouring runs each of eight pixels is in, by the bits of pixels 1 to 7 that start one.
struct RunPlaces {
  alignas(64) uint8_t of[128][8] = {};

  constexpr RunPlaces() {
    for (size_t bits = 0; bits < 128; ++bits)
      for (size_t pixel = 1; pixel < 8; ++pixel) of[bits][pixel] = static_cast<uint8_t>(of[bits][pixel - 1] + (bits >> (pixel - 1) & 1));
  }
};
inline constexpr RunPlaces kRunPlaces;

/// From runs to the pixels of a line's parts by permutations. kNear: the line's pixels are in eight neighbouring runs.
template <bool kNear>
class Spread {
 public:
  static constexpr size_t kNearRuns = 8;

  /// Of pixels whose starts are `bits`, `before` runs having started left of them.
  HWY_INLINE Spread(uint64_t bits, size_t before) {
    for (size_t k = 0; k < kLineParts; ++k, bits >>= kShadeLanes) {
      first_[k] = before + (bits & 1) - 1;
      before += static_cast<size_t>(std::popcount(bits & kPartBits));
      const uint8_t* HWY_RESTRICT places = kRunPlaces.of[bits >> 1 & kPartBits >> 1];
#if HWY_TARGET <= HWY_AVX3
      __m128i bytes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(places));
      if (kNear) bytes = _mm_add_epi8(bytes, _mm_set1_epi8(static_cast<char>(first_[k] - first_[0])));
      wide_[k] = _mm512_cvtepu8_epi64(bytes), narrow_[k] = _mm256_cvtepu8_epi32(bytes);
#else
      const hn::Rebind<uint8_t, ShadeD> bytes;
      const hn::Rebind<int32_t, ShadeD> whole;
      hn::StoreU(hn::PromoteTo(whole, hn::LoadU(bytes, places)) + hn::Set(whole, static_cast<int32_t>(first_[k])), whole, lanes_[k]);
#endif
    }
  }

#if HWY_TARGET <= HWY_AVX3
  HWY_INLINE ShadeV Of(const double* HWY_RESTRICT runs, size_t k) const {
    return ShadeV{_mm512_permutexvar_pd(wide_[k], _mm512_loadu_pd(runs + first_[kNear ? 0 : k]))};
  }
  HWY_INLINE ShadeV Of(const int32_t* HWY_RESTRICT runs, size_t k) const {
    const __m256i window = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(runs + first_[kNear ? 0 : k]));
    return ShadeV{_mm512_cvtepi32_pd(_mm256_permutevar8x32_epi32(window, narrow_[k]))};
  }
#else
  HWY_INLINE ShadeV Of(const double* HWY_RESTRICT runs, size_t k) const {
    const hn::RebindToSigned<ShadeD> index;
    const hn::Rebind<int32_t, ShadeD> whole;
    return hn::GatherIndex(ShadeD(), runs, hn::PromoteTo(index, hn::LoadU(whole, lanes_[k])));
  }
  HWY_INLINE ShadeV Of(const int32_t* HWY_RESTRICT runs, size_t k) const {
    alignas(64) double pixels[kShadeLanes];
    for (size_t lane = 0; lane < kShadeLanes; ++lane) pixels[lane] = runs[lanes_[k][lane]];
    return hn::Load(ShadeD(), pixels);
  }
#endif

 private:
  static constexpr uint64_t kPartBits = (1u << kShadeLanes) - 1;

  size_t first_[kLineParts];
#if HWY_TARGET <= HWY_AVX3
  __m512i wide_[kLineParts];
  __m256i narrow_[kLineParts];
#else
  int32_t lanes_[kLineParts][kShadeLanes];
#endif
};

/// The same of pixels that are all in one run.
class OneRun {
 public:
  HWY_INLINE explicit OneRun(size_t run) : run_(run) {}

  template <class T>
  HWY_INLINE ShadeV Of(const T* HWY_RESTRICT runs, size_t) const {
    return hn::Set(ShadeD(), static_cast<double>(runs[run_]));
  }

 private:
  size_t run_;
};

HWY_INLINE hn::Mask<LineF> LineMask(uint64_t bits) {
#if HWY_TARGET <= HWY_AVX3
  return hn::Mask<LineF>{static_cast<__mmask16>(bits)};
#else
  const auto byte = static_cast<uint8_t>(bits);
  return hn::LoadMaskBits(LineF(), &byte);
#endif
}

/// Where components go: their planes, from the line's first pixel on; zero where nothing is drawn. kPast: past the caches.
template <bool kPast>
struct Outputs {
  float* const* to;
  size_t element;
  hn::Mask<LineF> drawn;

  HWY_INLINE void Put(size_t component, hn::Vec<LineF> value) const {
    const auto v = hn::IfThenElseZero(drawn, value);
    if (kPast && kLinePixels >= 4) {  // nothing smaller goes past them
      hn::Stream(v, LineF(), to[component] + element);
    } else {
      hn::Store(v, LineF(), to[component] + element);
    }
  }
};

/// Puts component `c`, of which part k of the line is valueOf(k).
template <class Out, class Value>
HWY_INLINE void PutParts(size_t c, const Out& out, const Value& valueOf) {
#if HWY_TARGET <= HWY_AVX3
  const auto low = hn::DemoteTo(ShadeF(), valueOf(0)), high = hn::DemoteTo(ShadeF(), valueOf(1));
  out.Put(c, hn::Combine(LineF(), high, low));
#else
  out.Put(c, hn::DemoteTo(ShadeF(), valueOf(0)));
#endif
}

/// Shades a line whose first pixel is `x` in its strip.
template <bool kAllPerspective, class Runs, class Out>
HWY_INLINE void ShadeLine(const Runs& runs, const Strip& strip, const RunSums& sums, const Components& components, double x, const Out& out) {
  const ShadeD d;
  const ShadeV one = hn::Set(d, 1.0), zero = hn::Zero(d);
  ShadeV i[kLineParts], perspective[kLineParts], noperspective[kLineParts];
  for (size_t k = 0; k < kLineParts; ++k) {
    i[k] = (hn::Iota(d, 0) + hn::Set(d, x + static_cast<double>(k * kShadeLanes))) - runs.Of(strip.columns, k);
    perspective[k] = noperspective[k] = zero;
    if (kAllPerspective || components.perspective)
      perspective[k] = one / (runs.Of(sums.perspective[0], k) + runs.Of(sums.perspective[1], k) * i[k]);
    if (!kAllPerspective && components.noperspective) noperspective[k] = one / runs.Of(sums.noperspective, k);
  }
  const auto mean = [&](size_t c, size_t k, const ShadeV* reciprocal) { return (runs.Of(sums.at[c], k) + runs.Of(sums.growth[c], k) * i[k]) * reciprocal[k]; };
  for (size_t c = 0; c < components.count; ++c) {
    if (kAllPerspective || components.kinds[c] == ValueKind::Perspective) {
      PutParts(c, out, [&](size_t k) { return mean(c, k, perspective); });
    } else if (components.kinds[c] == ValueKind::Noperspective) {
      PutParts(c, out, [&](size_t k) { return mean(c, k, noperspective); });
    } else {
      PutParts(c, out, [&](size_t k) { return runs.Of(sums.at[c], k); });
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
