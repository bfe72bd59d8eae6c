#include "harness/report/plot.hpp"

#include <gtest/gtest.h>

namespace rasterdiff::harness {
namespace {

// An <svg> inside of another that has no size is as large as the whole of it.
TEST(SvgSheet, GivesEachPlotAPlaceAndASize) {
  const std::string plots[] = {"<svg>one</svg>", "<svg>two</svg>", "<svg>three</svg>"};
  const std::string sheet = svgSheet("title", "subtitle", plots);
  EXPECT_NE(sheet.find("<svg x=\"16\" y=\"56\" width=\"440\" height=\"400\"><svg>one</svg></svg>"), std::string::npos);
  EXPECT_NE(sheet.find("<svg x=\"472\" y=\"56\" width=\"440\" height=\"400\"><svg>two</svg></svg>"), std::string::npos);
  EXPECT_NE(sheet.find("<svg x=\"16\" y=\"472\" width=\"440\" height=\"400\"><svg>three</svg></svg>"), std::string::npos);
}

}  // namespace
}  // namespace rasterdiff::harness
