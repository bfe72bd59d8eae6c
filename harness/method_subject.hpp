// `method:NAME`: a way to find coverage (rasterizer/kernels/coverage_methods.hpp) as the driver under test, to see on
// whole scenes what it costs.
#pragma once

#include <string_view>

#include "harness/subject.hpp"

namespace rasterdiff::harness {

/// Assembly, clipping, snapping and culling are the reference's; the method decides which samples a triangle covers.
/// Its render() refuses (NotOffered) scenes of more than the coverage of filled triangles.
/// Error: BadInput, no such method or profile.
[[nodiscard]] Result<std::unique_ptr<Subject>> openMethod(const SubjectOptions& options, std::string_view name);

}  // namespace rasterdiff::harness
