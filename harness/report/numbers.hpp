// Numbers and words as people read them; shared by all writers that write for people.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rasterdiff::harness {

[[nodiscard]] std::string grouped(uint64_t number);                          ///< 1,234,567
[[nodiscard]] std::string counted(uint64_t number, std::string_view noun);   ///< "1 scene", "2,000 scenes"
[[nodiscard]] std::string ulps(double ulp);                                  ///< "0", "12", "3.1e+06"; "∞" if not finite
[[nodiscard]] std::string secondsText(double seconds);                       ///< "45 µs", "3.2 ms", "0.31 s", "12.4 s", "2 min 05 s"
[[nodiscard]] std::string primitiveText(uint32_t primitive);  ///< "primitive 7", "none"
[[nodiscard]] std::string floatText(float value);  ///< shortest text that reads back as the same float
[[nodiscard]] std::string shellQuoted(std::string_view word);  ///< as it has to be typed in a shell
[[nodiscard]] std::string oneLine(std::string_view text);      ///< control characters replaced by spaces

}  // namespace rasterdiff::harness
