// Matrices of floating-point numbers out of .npy files, NumPy's own format: strictly, since what a file holds becomes a
// scene. What rows and columns mean is the caller's business; writing .npy files is the harness's.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "scene/result.hpp"

namespace rasterdiff {

/// rows × columns of float32 or float64, as they lie in the file.
class NpyMatrix {
 public:
  /// Format versions 1.0 to 3.0; dtype '<f4', '>f4', '<f8' or '>f8'; C or Fortran order; two dimensions; exactly as many
  /// bytes as the shape says. Error: BadInput, `where` is `fileName`.
  /// Source: NumPy Enhancement Proposal 1 and numpy.lib.format.
  [[nodiscard]] static Result<NpyMatrix> parse(std::string bytes, const std::string& fileName);

  [[nodiscard]] size_t rows() const { return rows_; }
  [[nodiscard]] size_t columns() const { return columns_; }
  /// The number in `row` and `column`; of a float32 exactly.
  [[nodiscard]] double at(size_t row, size_t column) const;
  /// The number rounded to float32; a NaN of a float32 file keeps its bits.
  [[nodiscard]] float float32(size_t row, size_t column) const;

 private:
  template <class Word>
  [[nodiscard]] Word word(size_t row, size_t column) const;

  std::string bytes_;
  size_t data_ = 0;  ///< where the numbers begin
  size_t rows_ = 0, columns_ = 0;
  bool wide_ = false, swapped_ = false, columnMajor_ = false;
};

/// The file's matrix. Error: Io (missing, unreadable), BadInput (too large, or as NpyMatrix::parse).
[[nodiscard]] Result<NpyMatrix> loadNpy(const std::string& path);

}  // namespace rasterdiff
