// Line methods against Vulkan's diamond-exit rule.
#include <algorithm>
#include <iterator>

#include "rasterizer/methods/line_methods.hpp"
#include "rasterizer/methods/measure_row.hpp"
#include "rasterizer/methods/method_inputs.hpp"

namespace rasterdiff::rasterizer {

void measureLines(const MethodTableOptions& options, std::vector<MethodRow>& rows) {
  struct Inputs {
    bool hard;
    const char* what;
    LineEnds (*make)(Prng&);
  };
  static constexpr Inputs kInputs[] = {{false, "ends on pixel centres", centredLine},
                                       {true, "ends on the 1/256 and the ¼ grid", hardLine}};
  for (const LineMethod& method : lineMethods()) {
    for (const Inputs& inputs : kInputs) {
      Prng prng(options.seed);
      ErrorSum errors;
      uint64_t wrong = 0;
      for (uint32_t i = 0; i < options.cases; ++i) {
        const LineEnds ends = inputs.make(prng);
        std::vector<PixelIndex> exact = drawLineDiamondVulkan(ends.a, ends.b), drawn = method.draw(ends.a, ends.b);
        std::sort(exact.begin(), exact.end());
        std::sort(drawn.begin(), drawn.end());
        std::vector<PixelIndex> differing;
        std::set_symmetric_difference(exact.begin(), exact.end(), drawn.begin(), drawn.end(),
                                      std::back_inserter(differing));
        wrong += differing.size();
        errors.add(static_cast<double>(differing.size()));
      }
      rows.push_back(measuredRow("line", std::string(method.name), inputs.hard, inputs.what, errors, wrong));
    }
  }
}

}  // namespace rasterdiff::rasterizer
