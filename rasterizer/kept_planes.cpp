// The planes of a triangle, kept until its values are asked for (late_values.hpp): only those that the scene needs.
#include <algorithm>

#include "rasterizer/interpolation.hpp"

namespace rasterdiff::rasterizer {

std::vector<ValueKind> PieceValues::lateKinds() const {
  std::vector<ValueKind> kinds;
  for (size_t c = 0; c < inputs_.size(); ++c) {
    switch (inputs_[c].kind) {
      case Kind::Flat: kinds.push_back(ValueKind::Flat); break;
      case Kind::Linear: kinds.push_back(ValueKind::Noperspective); break;
      case Kind::Perspective: kinds.push_back(ValueKind::Perspective); break;
    }
  }
  return kinds;
}

void PieceValues::save(std::vector<LinearFunction>& planes, std::vector<float>& constants) const {
  if (needsDepth_) planes.push_back(planes_.depth);
  if (needsW_) planes.push_back(planes_.reciprocalW);
  planes.insert(planes.end(), planes_.inputs.begin(), planes_.inputs.end());
  constants.insert(constants.end(), constants_.begin(), constants_.end());
}

void PieceValues::restore(size_t n, std::span<const LinearFunction> planes, std::span<const float> constants) {
  const size_t each = size_t{needsDepth_} + size_t{needsW_} + planes_.inputs.size();
  const LinearFunction* plane = planes.data() + n * each;
  if (needsDepth_) planes_.depth = *plane++;
  if (needsW_) planes_.reciprocalW = *plane++;
  std::copy_n(plane, planes_.inputs.size(), planes_.inputs.begin());
  std::copy_n(constants.data() + n * constants_.size(), constants_.size(), constants_.begin());
}

}  // namespace rasterdiff::rasterizer
