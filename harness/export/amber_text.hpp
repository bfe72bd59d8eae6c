// Numbers as Amber's parser reads them: a float has a point and no exponent, and hexadecimal floats become 1.
#pragma once

#include <string>

namespace rasterdiff::harness {

/// The shortest decimal number that reads back as `value`, which must be finite.
[[nodiscard]] std::string amberFloat(float value);

}  // namespace rasterdiff::harness
