#include "harness/cli/parse.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "harness/cli/parse_verbs.hpp"

namespace rasterdiff::harness::cli {
namespace {

constexpr const char* kAbout =
    "Draws a scene with a reference rasterizer and with a Vulkan driver, and explains every sample that differs.";

constexpr const char* kMainExamples = R"(Examples:
  rasterdiff check                                     the whole catalogue on lavapipe
  rasterdiff check 'fill/*' --driver swiftshader       some of it on another driver
  rasterdiff explain fill/shared-diagonal 12 12        why is this sample covered?
  rasterdiff stability --report stability.html         where does each method break?
  rasterdiff infer -o driver.json                      which rules does the driver follow?
  rasterdiff devices                                   which drivers are here?

Exit status: 0 nothing unexpected; 1 a difference that nothing allows; 2 usage or bad input; 3 no usable device;
4 the driver crashed or hung.)";

constexpr const char* kCheckExamples = R"(SCENE is a catalogue name or glob ('fill/*'), a *.scene.json file, or a folder of them. None: the whole catalogue.

Examples:
  rasterdiff check --report report.html --json results.json
  rasterdiff check 'mesh/*' --driver swiftshader --rules spec
  rasterdiff check my.scene.json --dump planes
  rasterdiff check 'random/*' --count 1000000 --seed 7
  rasterdiff check 'random*/*' --count 100000          points, lines, strips, edges, cuts … of each kind
  rasterdiff check --driver mutant:truncating-snap     is this deliberate error caught?
  rasterdiff check --driver legal:7 --rules spec       is this random legal renderer let through?
  rasterdiff check --driver legal:1..100 --rules spec  are all of these? one summary
  rasterdiff check --driver 'mutant:*'                 which scenes catch which deliberate error? 0: all are caught
  rasterdiff check 'mesh/*depth*' --rounds 9 --jobs 1   where the time goes once shaders are compiled and memory is warm
  rasterdiff check --shard 2/8 --junit shard2.xml      one of eight machines)";

constexpr const char* kRenderExamples = R"(Writes one PNG (samples averaged) and one .npy (every sample) a plane.

Examples:
  rasterdiff render mesh/bunny --with reference -o bunny
  rasterdiff render my.scene.json --with driver --driver swiftshader -o out
  rasterdiff render fill/shared-diagonal --with method:edge-float -o out     a textbook method)";

constexpr const char* kExplainExamples = R"(Examples:
  rasterdiff explain fill/shared-diagonal 12 12
  rasterdiff explain my.scene.json 3 4 --sample 2 --driver swiftshader
  rasterdiff explain fill/shared-diagonal 12 12 --svg near.svg    a drawing of edges, vertices and samples around it
  rasterdiff explain fill/shared-diagonal 12 12 --driver none     the reference alone)";

constexpr const char* kDevicesExamples = R"(Examples:
  rasterdiff devices
  rasterdiff devices --json)";

constexpr const char* kListExamples = R"(Examples:
  rasterdiff list
  rasterdiff list 'clip/*'
  rasterdiff list --rules          every rule, its scenes and mutants, and how each driver stands to it (measured)
  rasterdiff list --rules --driver none      the same without drawing anything
  rasterdiff list 'line-*' --rules --driver lavapipe --json
  rasterdiff list --mutants        deliberate errors for --driver mutant:NAME
  rasterdiff list --freedoms       what the specification leaves open)";

/// "K/N" with 1 <= K <= N.
std::string readShard(const std::string& text, CheckOptions& options) {
  try {
    size_t used = 0;
    const size_t slash = text.find('/');
    const std::string k = text.substr(0, slash), n = slash == std::string::npos ? "" : text.substr(slash + 1);
    const bool digits = !k.empty() && !n.empty() && (k + n).find_first_not_of("0123456789") == std::string::npos;
    if (digits && (k + n).size() < 10) {
      options.shard = static_cast<uint32_t>(std::stoul(k, &used));
      options.shards = static_cast<uint32_t>(std::stoul(n, &used));
      if (options.shard >= 1 && options.shard <= options.shards) return {};
    }
  } catch (const std::exception&) {
  }
  return "wants K/N with 1 <= K <= N, as in 2/8";
}

void addCheck(CLI::App& app, CheckOptions& options) {
  CLI::App* verb = app.add_subcommand("check", "Render with both, compare every sample and value");
  verb->footer(kCheckExamples);
  verb->add_option("SCENE", options.scenes, "Catalogue glob, scene file or folder");
  addDriverOptions(*verb, options.choice, ", fault:KIND[=GLOB] (self-test); several: legal:FIRST..LAST, 'mutant:GLOB'");
  verb->add_option("--baseline", options.baseline,
                   "Known differences: a file, or none (default: those known to this project)");
  verb->add_option("--report", options.report, "Write one self-contained HTML file");
  verb->add_option("--json", options.json, "Write the results as JSON");
  verb->add_option("--junit", options.junit, "Write the results as JUnit XML");
  verb->add_option("--dump", options.dump, "Write both sides' planes as .npy below this folder");
  verb->add_option_function<std::string>(
          "--shard",
          [&options](const std::string& text) {
            if (const std::string wrong = readShard(text, options); !wrong.empty()) {
              throw CLI::ValidationError("--shard", wrong);
            }
          },
          "Only the K-th of N parts of the work")
      ->type_name("K/N");
  verb->add_option("--jobs", options.jobs, "Worker processes (0: one a core)")->check(CLI::Range(0U, 256U));
  verb->add_option("--rounds", options.rounds, "Draw and compare each scene so many times; times are medians, the rest is the last one's")
      ->check(CLI::Range(1U, 1000U));
  verb->add_option("--count", options.count,
                   "Random primitives of each kind (random, random-lines, …), shared out over its selected families in batches of 500")
      ->check(CLI::Range(uint64_t{1}, uint64_t{1} << 40));
  verb->add_option("--seed", options.seed, "Seed of --count")
      ->check(CLI::Range(uint64_t{0}, uint64_t{1} << 32))
      ->needs("--count")
      ->capture_default_str();
  verb->add_flag("--validate", options.choice.validate, "Khronos validation with synchronization validation");
  // A wrapper gives defaults before the user's words: the last one counts.
  for (CLI::Option* option : verb->get_options([](const CLI::Option* o) { return !o->get_positional(); })) {
    if (option->get_items_expected_max() == 1) option->take_last();
  }
}

void addRender(CLI::App& app, RenderOptions& options) {
  CLI::App* verb = app.add_subcommand("render", "Draw a scene with one side alone, as PNG and .npy");
  verb->footer(kRenderExamples);
  verb->add_option("SCENE", options.scene, "Catalogue name or scene file")->required();
  verb->add_option_function<std::string>(
          "--with",
          [&options](const std::string& with) {
            options.withDriver = with != "reference";
            if (with.find(':') != std::string::npos) {
              options.choice.driver = with;
            } else if (with != "reference" && with != "driver") {
              throw CLI::ValidationError("--with", "wants reference, driver, method:NAME or mutant:NAME");
            }
          },
          "Which side draws: reference, driver (see --driver), method:NAME or mutant:NAME")
      ->type_name("SIDE")
      ->required();
  verb->add_option("-o,--output", options.folder, "Folder for the files; made if it is missing")->required();
  addDriverOptions(*verb, options.choice, "");
}

void addExplain(CLI::App& app, ExplainOptions& options) {
  CLI::App* verb = app.add_subcommand("explain", "Why a sample is covered or not, and by whom");
  verb->footer(kExplainExamples);
  verb->add_option("SCENE", options.scene, "Catalogue name or scene file")->required();
  verb->add_option("X", options.x, "Pixel column, 0 = left")->required();
  verb->add_option("Y", options.y, "Pixel row, 0 = top")->required();
  verb->add_option("--sample", options.sample, "Sample of the pixel")->capture_default_str();
  verb->add_option("--svg", options.svg, "Draw the pixels around it: edges, vertices, samples");
  addDriverOptions(*verb, options.choice, ", none");
}

void addList(CLI::App& app, ListOptions& options) {
  CLI::App* verb = app.add_subcommand("list", "The catalogue, rules, deliberate errors, freedoms");
  verb->footer(kListExamples);
  verb->add_option("GLOB", options.glob, "Only scenes whose name matches")->capture_default_str();
  CLI::Option_group* what = verb->add_option_group("What");
  const auto add = [&](const char* name, ListOptions::What value, const char* text) {
    what->add_flag_callback(name, [&options, value] { options.what = value; }, text);
  };
  add("--rules", ListOptions::What::Rules, "Rules and the scenes that exercise them");
  add("--mutants", ListOptions::What::Mutants, "Deliberate errors");
  add("--freedoms", ListOptions::What::Freedoms, "Freedoms of the specification");
  what->require_option(0, 1);
  verb->add_option("--driver", options.drivers,
                   "With --rules: the driver to measure, as for check; may be given more than once; none (default: "
                   "lavapipe and swiftshader)")
      ->allow_extra_args(false);
  verb->add_flag("--json", options.json, "As JSON");
}

}  // namespace

tl::expected<Verb, NothingToRun> parse(int argc, const char* const* argv) {
  CLI::App app(kAbout, "rasterdiff");
  app.footer(kMainExamples);
  app.set_version_flag("--version", "rasterdiff " RASTERDIFF_VERSION);
  app.require_subcommand(1);
  CheckOptions check;
  RenderOptions render;
  ExplainOptions explain;
  BenchOptions bench;
  StabilityOptions stability;
  DevicesOptions devices;
  ListOptions list;
  HuntOptions hunt;
  BlessOptions bless;
  MethodsOptions methods;
  InvariantsOptions invariants;
  InferOptions infer;
  ExportOptions exported;
  addCheck(app, check);
  addRender(app, render);
  addExplain(app, explain);
  addBench(app, bench);
  addStability(app, stability);
  addInfer(app, infer);
  CLI::App* devicesVerb = app.add_subcommand("devices", "Which drivers are here, with the limits that matter");
  devicesVerb->footer(kDevicesExamples);
  devicesVerb->add_flag("--json", devices.json, "As JSON");
  addList(app, list);
  addHunt(app, hunt);
  addBless(app, bless);
  addMethods(app, methods);
  addInvariants(app, invariants);
  addExport(app, exported);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return tl::unexpected(NothingToRun{0, app.help(), {}});
  } catch (const CLI::CallForVersion& version) {
    return tl::unexpected(NothingToRun{0, std::string(version.what()) + "\n", {}});
  } catch (const CLI::ParseError& error) {
    const std::vector<CLI::App*> given = app.get_subcommands();
    if (given.empty() && argc > 1 && argv[1][0] != '-') {
      return tl::unexpected(NothingToRun{2, fmt::format("rasterdiff: there is no verb '{}'", argv[1]), "rasterdiff --help"});
    }
    const std::string verb = given.empty() ? "" : " " + given.front()->get_name();
    return tl::unexpected(NothingToRun{2, "rasterdiff" + verb + ": " + error.what(), "rasterdiff" + verb + " --help"});
  }
  const std::string verb = app.get_subcommands().front()->get_name();
  if (verb == "check") return check;
  if (verb == "render") return render;
  if (verb == "explain") return explain;
  if (verb == "bench") return bench;
  if (verb == "stability") return stability;
  if (verb == "infer") return infer;
  if (verb == "devices") return devices;
  if (verb == "hunt") return hunt;
  if (verb == "bless") return bless;
  if (verb == "methods") return methods;
  if (verb == "invariants") return invariants;
  if (verb == "export") return exported;
  return list;
}

}  // namespace rasterdiff::harness::cli
