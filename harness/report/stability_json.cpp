#include "harness/report/json_parts.hpp"
#include "harness/report/stability_text.hpp"

namespace rasterdiff::harness {

std::string stabilityJson(const stability::Results& results) {
  Json families = Json::array();
  for (const stability::Family& family : results.families) {
    Json all = Json::array();
    for (const stability::Series& series : results.series) {
      if (series.family != family.name) continue;
      Json points = Json::array();
      for (const stability::Point& p : series.points) {
        if (!p.offered) continue;
        points.push_back({{"dial", p.dial}, {"cases", p.cases}, {"wrong", p.wrong}, {"maxUlp", jsonNumber(p.maxUlp)}, {"notFinite", p.notFinite}});
      }
      Json entry{{"method", series.method}, {"measure", series.values ? "values" : "coverage"}, {"judged", series.judged}};
      entry["breaksAt"] = nullptr;
      if (const auto at = stability::breaksAt(series)) entry["breaksAt"] = *at;
      entry["points"] = std::move(points);
      all.push_back(std::move(entry));
    }
    families.push_back({{"name", family.name}, {"what", family.what}, {"dial", family.dial}, {"series", std::move(all)}});
  }
  return textOf({{"drivers", results.drivers}, {"seconds", results.wallSeconds}, {"families", std::move(families)}}) + "\n";
}

}  // namespace rasterdiff::harness
