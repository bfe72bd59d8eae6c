// What was typed, as plain data: one struct a verb. Parsing (parse.hpp) knows the library, the verbs know only this.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rasterdiff::harness::cli {

struct DriverChoice {
  std::string driver = "lavapipe";  ///< also "none" for `explain`
  std::string rules = "auto";       ///< "auto", "spec", a profile, or a profile's file
  double timeoutSeconds = 20;
  bool validate = false;
};

struct CheckOptions {
  std::vector<std::string> scenes;  ///< empty = the whole catalogue
  DriverChoice choice;
  std::string baseline;                   ///< file; "none"; empty = the differences known to this project
  std::string report, json, junit, dump;  ///< paths; empty = not wanted
  uint32_t shard = 1, shards = 1;         ///< 1-based
  uint32_t jobs = 0;                      ///< 0 = one a core
  uint32_t rounds = 1;                    ///< draws of each scene; times are medians
  std::optional<uint64_t> count;          ///< random primitives of each selected kind
  uint64_t seed = 1;
};

struct RenderOptions {
  std::string scene, folder;
  bool withDriver = false;
  DriverChoice choice;
};

struct ExplainOptions {
  std::string scene;
  uint32_t x = 0, y = 0, sample = 0;
  std::string svg;  ///< path of the drawing; empty: none
  DriverChoice choice;
};

struct BenchOptions {
  std::vector<std::string> scenes;  ///< instead of the built-in workloads
  std::string workloads;            ///< empty: all, or a few for `quick`
  std::string size = "1920x1080", samples = "1";  ///< each one or several, by commas
  std::string tasks = "coverage,depth,varyings";
  std::string kernels = "*";  ///< globs, by commas
  DriverChoice choice;        ///< "none": no driver
  uint32_t rounds = 5;
  unsigned threads = 1;
  bool quick = false, targets = false, scaling = false;
  std::string json, csv, svg, report;  ///< paths; empty = not wanted
};

struct StabilityOptions {
  std::string family = "*";    ///< glob
  std::string driver = "all";  ///< "all" that are installed, "none", or as DriverChoice::driver
  std::string json, csv, svg, report;  ///< paths; empty = not wanted
};

struct DevicesOptions {
  bool json = false;
};

struct ListOptions {
  enum class What { Scenes, Rules, Mutants, Freedoms };
  std::string glob = "*";
  What what = What::Scenes;
  std::vector<std::string> drivers;  ///< whose standing to each rule is measured; empty = all known ones; "none"
  bool json = false;
};

struct HuntOptions {
  std::string family = "any";
  uint64_t seed = 1;
  std::optional<uint64_t> count;  ///< scenes, rounded up to whole lanes
  double seconds = 60;            ///< without count: rounds begin until then
  std::string folder = "findings", json;
  bool known = false;             ///< list known differences too
  uint32_t jobs = 0;              ///< 0 = one a core
  DriverChoice choice;
};

struct BlessOptions {
  std::string results, baseline;  ///< files
  std::vector<std::string> scenes;
  std::string reason, rule, anchor;
};

struct MethodsOptions {
  std::string family;  ///< empty = all
  uint64_t seed = 1;
  uint32_t cases = 300;
  bool markdown = false;
  std::string json, csv;  ///< paths; empty = not wanted
};

struct InvariantsOptions {
  std::string glob = "*";
  uint64_t seed = 1, count = 40;  ///< cases of each
  std::string folder = "findings", json;
  DriverChoice choice;
};

struct InferOptions {
  DriverChoice choice;
  std::string output;  ///< path of the profile; empty: not written
  bool json = false;
  uint64_t seed = 1;
};

struct ExportOptions {
  std::string scene;
  std::string amber, file;  ///< paths of the Amber script and of the scene file; empty = not wanted
  DriverChoice choice{.driver = "none", .rules = "spec"};
};

using Verb = std::variant<CheckOptions, RenderOptions, ExplainOptions, BenchOptions, DevicesOptions, ListOptions, HuntOptions,
                          BlessOptions, MethodsOptions, StabilityOptions, InvariantsOptions, InferOptions, ExportOptions>;

}  // namespace rasterdiff::harness::cli
