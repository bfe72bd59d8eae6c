// `export`: a scene as an Amber script for a driver's developers, or as a scene file.
#include <fmt/format.h>

#include "harness/cli/isolated.hpp"
#include "harness/cli/message.hpp"
#include "harness/cli/rule_choice.hpp"
#include "harness/cli/run.hpp"
#include "harness/cli/selection.hpp"
#include "harness/export/amber_script.hpp"
#include "harness/report/numbers.hpp"
#include "harness/report/output.hpp"
#include "scene/file/scene_file.hpp"

namespace rasterdiff::harness::cli {
namespace {

std::string commandOf(const ExportOptions& options) {
  std::string command = fmt::format("rasterdiff export {} --amber {}", shellQuoted(options.scene), shellQuoted(options.amber));
  if (options.choice.driver != "none") command += " --driver " + shellQuoted(options.choice.driver);
  if (options.choice.rules != "spec") command += " --rules " + shellQuoted(options.choice.rules);
  return command;
}

/// Writes the script and returns what to tell about it.
Result<std::string> writeAmber(const Scene& scene, const rasterizer::Rules& rules, const ExportOptions& options) {
  const Result<AmberScript> script = amberScript(scene, rules, commandOf(options));
  if (!script) return tl::unexpected(script.error());
  if (Result<void> written = writeFile(options.amber, script->text); !written) return tl::unexpected(written.error());
  std::string said = fmt::format("{}: {} demanded, {} left open; {} in an interval\n", options.amber, counted(script->expected, "sample"),
                                 grouped(script->free), counted(script->values, "value"));
  if (script->expected + script->values == 0) {
    return said + "the rules leave everything open; a driver's own profile demands its coverage: --driver NAME --rules auto\nrasterdiff export --help\n";
  }
  return said + "amber " + shellQuoted(options.amber) + "\n";
}

/// In the driver's process, for its limits.
Result<std::string> writeForDriver(const Scene& scene, const ExportOptions& options) {
  Result<std::unique_ptr<Subject>> subject = openSubject(subjectOptions(options.choice));
  if (!subject) return tl::unexpected(subject.error());
  const Result<rasterizer::Rules> rules = rulesFor(options.choice, **subject);
  if (!rules) return tl::unexpected(rules.error());
  return writeAmber(scene, *rules, options);
}

Result<std::string> exportAmber(const Scene& scene, const ExportOptions& options) {
  if (options.choice.driver != "none") {
    return isolated(watchdogSeconds(options.choice.timeoutSeconds), [&] { return writeForDriver(scene, options); });
  }
  const Result<rasterizer::Rules> rules = rulesWithoutDriver(options.choice.rules);
  if (!rules) return tl::unexpected(rules.error());
  return writeAmber(scene, *rules, options);
}

}  // namespace

int runVerb(const ExportOptions& options) {
  if (const Result<void> known = checkRulesName(options.choice.rules); !known) {
    return complain(known.error(), "rasterdiff export --help");
  }
  const Result<Job> job = selectScene(options.scene);
  if (!job) return complain(job.error(), nextCommand(job.error(), "export"));
  const Result<Scene> scene = drawable(*job);
  if (!scene) return complain(scene.error(), nextCommand(scene.error(), "export"));
  if (!options.file.empty()) {
    if (const Result<void> written = writeFile(options.file, writeScene(*scene)); !written) {
      return complain(written.error(), "rasterdiff export --help");
    }
    fmt::print("{}\nrasterdiff check {}\n", options.file, shellQuoted(options.file));
  }
  if (options.amber.empty()) return 0;
  const Result<std::string> written = exportAmber(*scene, options);
  if (!written) return complain(written.error(), nextCommand(written.error(), "export"));
  fmt::print("{}", *written);
  return 0;
}

}  // namespace rasterdiff::harness::cli
