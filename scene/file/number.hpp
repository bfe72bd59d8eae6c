// Numbers as text that keep every bit: decimals where they round-trip, C hex floats and names of non-finite ones else.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rasterdiff {

/// "0x1.8p+3", "-0X.1P-2", "0x10" (C99 hexadecimal floating constants with an optional sign). Nothing for other text,
/// and for magnitudes beyond double.
[[nodiscard]] std::optional<double> parseHexFloat(std::string_view text);

/// "nan", "inf", "-inf", and "nan(0x7fc00001)" for a NaN of exactly these bits.
[[nodiscard]] std::optional<float> parseNonFinite(std::string_view text);

/// As it stands in a scene file: a JSON number if reading it (decimal to double to float32) gives `value` back bit by
/// bit, else a JSON string that parseHexFloat or parseNonFinite reads.
[[nodiscard]] std::string jsonNumber(float value);

}  // namespace rasterdiff
