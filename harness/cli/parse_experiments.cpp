// Options and help of the verbs that measure and search: bench, stability, methods, hunt, invariants, infer, bless, export.
#include <CLI/CLI.hpp>

#include "harness/cli/parse_verbs.hpp"

namespace rasterdiff::harness::cli {
namespace {

constexpr const char* kBenchExamples = R"(Workloads (fixed seed, fully on screen): W1 a million triangles of 10 pixels, W2 100,000 of 1,000, W3 1,000 of 500,000,
W4a and W4b a mesh of about 1.6 and 30 pixels a triangle, W5 100,000 slivers of 1000 x 0.3 pixels.
Methods are verified before they are timed; one that promises to be exact and is not is not timed.

Examples:
  rasterdiff bench                                     speed against error, everything
  rasterdiff bench --quick                             in a few seconds, with larger deviations
  rasterdiff bench --workload W1,W4a --size 4096 --samples 4
  rasterdiff bench --scaling --report bench.html --svg bench.svg --json bench.json --csv bench.csv
  rasterdiff bench my.scene.json --kernels 'spans,render' --driver none)";

constexpr const char* kStabilityExamples = R"(Examples:
  rasterdiff stability --report stability.html         everything: about a minute
  rasterdiff stability 'w-*' --driver none             some families, methods and reference alone
  rasterdiff stability sliver --driver swiftshader --svg sliver.svg --csv sliver.csv)";

constexpr const char* kMethodsExamples = R"(FAMILY: coverage, polygon, line, interpolation, depth, sampling, jaggies, aliasing or moire. None: all.
What a coverage method costs on a whole scene: rasterdiff check 'fill/*' --driver method:edge-float

Examples:
  rasterdiff methods coverage
  rasterdiff methods --cases 1000 --seed 7 --json methods.json --csv methods.csv
  rasterdiff methods --markdown                                   the tables of docs/methods.md)";

constexpr const char* kHuntExamples = R"(Looks for scenes that differ, shrinks each to the smallest that still does, and writes it as a scene file and a picture.

Examples:
  rasterdiff hunt --seconds 300                          five minutes of everything on lavapipe
  rasterdiff hunt --driver swiftshader --rules spec --family clip --seed 7
  rasterdiff hunt --driver mutant:scissor-off-by-one --count 2000
  rasterdiff hunt --known                                also what the baseline knows

Exit status: 0 nothing new; 1 something found; 4 the driver crashed or hung.)";

constexpr const char* kInvariantsExamples = R"(What has to hold of a driver without any reference: shared edges, the same picture said in two ways, what must not matter.

Examples:
  rasterdiff invariants
  rasterdiff invariants 'shared-edges-*' --driver swiftshader --count 500)";

constexpr const char* kInferExamples = R"(Draws some hundred small scenes, drops every candidate rule that the driver contradicts, and prints what is left.

Examples:
  rasterdiff infer
  rasterdiff infer --driver swiftshader -o swiftshader.json
  rasterdiff check 'random/*' --driver swiftshader --rules swiftshader.json
  rasterdiff infer --driver synthetic:7      random rules that nobody told it: are they found?
  rasterdiff infer --driver synthetic:1..100     are those of all these? exit status 0: every choice of each)";

constexpr const char* kBlessExamples = R"(A scene that differs gets an entry for the driver's version and the rules of that run. Entries whose scene no longer differs go.

Examples:
  rasterdiff check --driver swiftshader --json results.json
  rasterdiff bless results.json 'depth/*' -o baseline.json --reason "x mirrored in the pixel at 4 samples" --rule R22
  rasterdiff check --driver swiftshader --baseline baseline.json)";

constexpr const char* kExportExamples = R"(An Amber script repeats a scene for people who do not have this program: Amber draws it and demands every sample and value that the
rules determine. Run it with `amber FILE`.

Examples:
  rasterdiff export fill/shared-diagonal --amber shared.amber
  rasterdiff export findings/1.scene.json --amber bug.amber --driver lavapipe     with the device's own limits
  rasterdiff export viewport/flipped --scene flipped.scene.json                   a scene of the catalogue, to be changed)";

void addTimeout(CLI::App& verb, DriverChoice& choice) {
  verb.add_option("--timeout", choice.timeoutSeconds, "Seconds a driver may take over one submit")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
}

}  // namespace

void addDriverOptions(CLI::App& verb, DriverChoice& choice, const std::string& alsoDrivers) {
  verb.add_option("--driver", choice.driver,
                  "lavapipe, swiftshader, the path of an ICD manifest (*.json), mutant:NAME, method:NAME, legal:SEED" +
                      alsoDrivers)
      ->capture_default_str();
  verb.add_option("--rules", choice.rules,
                  "auto (the driver's profile if one is known, else spec), spec, a profile (reference, lavapipe, d3d11), or the "
                  "file of one (rasterdiff infer -o FILE)")
      ->capture_default_str();
  addTimeout(verb, choice);
}

void addBench(CLI::App& app, BenchOptions& options) {
  CLI::App* verb = app.add_subcommand("bench", "Speed against error for every kernel, the reference and the driver");
  verb->footer(kBenchExamples);
  verb->add_option("SCENE", options.scenes, "Catalogue glob, scene file or folder instead of the workloads");
  verb->add_option("--workload", options.workloads, "W1, W2, W3, W4a, W4b, W5, with commas (default: all; W1,W2,W4b with --quick)");
  verb->add_option("--size", options.size, "Targets, as in 1920x1080,4096")->capture_default_str();
  verb->add_option("--samples", options.samples, "Samples a pixel, as in 1,4")->capture_default_str();
  verb->add_option("--tasks", options.tasks, "What has to come out of a draw")->capture_default_str();
  verb->add_option("--kernels", options.kernels, "Globs over the methods' names, with commas; also render, driver, driver-whole")
      ->capture_default_str();
  verb->add_option("--rounds", options.rounds, "Interleaved rounds")->check(CLI::Range(1U, 1000U))->capture_default_str();
  verb->add_option("--threads", options.threads, "For the methods that can use several, and the driver")
      ->check(CLI::Range(1U, 256U))
      ->capture_default_str();
  verb->add_flag("--targets", options.targets, "Every instruction set of this machine, not only the best");
  verb->add_flag("--scaling", options.scaling, "Also how costs grow with triangle size and count, target size, samples, threads");
  verb->add_option("--json", options.json, "Write the results as JSON");
  verb->add_option("--csv", options.csv, "Write the rows as CSV");
  verb->add_option("--svg", options.svg, "Write the plots as one SVG file");
  verb->add_option("--report", options.report, "Write one self-contained HTML file");
  verb->add_flag("--quick", options.quick, "Shorter draws, fewer samples verified");
  verb->add_option("--driver", options.choice.driver, "lavapipe, swiftshader, the path of an ICD manifest (*.json), none")
      ->capture_default_str();
  addTimeout(*verb, options.choice);
}

void addStability(CLI::App& app, StabilityOptions& options) {
  CLI::App* verb = app.add_subcommand("stability", "Error as a function of how hard a scene is, and where each method breaks");
  verb->footer(kStabilityExamples);
  verb->add_option("FAMILY", options.family, "Only families whose name matches")->capture_default_str();
  verb->add_option("--driver", options.driver, "all (that are installed), none, or one driver as in check")->capture_default_str();
  verb->add_option("--json", options.json, "Write the results as JSON");
  verb->add_option("--csv", options.csv, "Write the results as CSV");
  verb->add_option("--svg", options.svg, "Write the plots as one SVG file");
  verb->add_option("--report", options.report, "Write tables and plots as one HTML file");
}

void addMethods(CLI::App& app, MethodsOptions& options) {
  CLI::App* verb = app.add_subcommand("methods", "The lectures' algorithms, measured against the exact answer");
  verb->footer(kMethodsExamples);
  verb->add_option("FAMILY", options.family, "Only this family");
  verb->add_option("--seed", options.seed, "Seed of the inputs")->capture_default_str();
  verb->add_option("--cases", options.cases, "Inputs a set")->check(CLI::Range(1U, 1'000'000U))->capture_default_str();
  verb->add_flag("--markdown", options.markdown, "Tables as in docs/methods.md");
  verb->add_option("--json", options.json, "Write the rows as JSON");
  verb->add_option("--csv", options.csv, "Write the rows as CSV");
}

void addHunt(CLI::App& app, HuntOptions& options) {
  CLI::App* verb = app.add_subcommand("hunt", "Search for scenes that differ, and shrink them");
  verb->footer(kHuntExamples);
  addDriverOptions(*verb, options.choice, ", fault:KIND[=GLOB] (self-test)");
  verb->add_option("--family", options.family, "any, fill, line, point, clip, depth, values, samples, state")->capture_default_str();
  verb->add_option("--seed", options.seed, "The same seed and count find the same")
      ->check(CLI::Range(uint64_t{0}, uint64_t{1} << 32))
      ->capture_default_str();
  CLI::Option* count =
      verb->add_option("--count", options.count, "Scenes, rounded up to lanes of 32")->check(CLI::Range(uint64_t{1}, uint64_t{1} << 32));
  verb->add_option("--seconds", options.seconds, "Search this long, then shrink what is left")
      ->check(CLI::Range(0.1, 1e6))
      ->capture_default_str()
      ->excludes(count);
  verb->add_option("-o,--output", options.folder, "Folder for what is found; made when needed")->capture_default_str();
  verb->add_option("--json", options.json, "Write the result as JSON");
  verb->add_flag("--known", options.known, "List and write known differences too");
  verb->add_option("--jobs", options.jobs, "Worker processes (0: one a core)")->check(CLI::Range(0U, 256U));
}

void addInvariants(CLI::App& app, InvariantsOptions& options) {
  CLI::App* verb = app.add_subcommand("invariants", "What has to hold of a driver without a reference");
  verb->footer(kInvariantsExamples);
  verb->add_option("NAME", options.glob, "Only invariants whose name matches this glob")->capture_default_str();
  verb->add_option("--driver", options.choice.driver, "lavapipe, swiftshader, the path of an ICD manifest (*.json), mutant:NAME")->capture_default_str();
  addTimeout(*verb, options.choice);
  verb->add_option("--seed", options.seed, "The same seed gives the same cases")->check(CLI::Range(uint64_t{0}, uint64_t{1} << 32))->capture_default_str();
  verb->add_option("--count", options.count, "Random cases of each invariant")->check(CLI::Range(uint64_t{1}, uint64_t{1} << 32))->capture_default_str();
  verb->add_option("-o,--output", options.folder, "Folder for the scenes of broken ones; made when needed")->capture_default_str();
  verb->add_option("--json", options.json, "Write the result as JSON");
}

void addInfer(CLI::App& app, InferOptions& options) {
  CLI::App* verb = app.add_subcommand("infer", "Find the rules that a driver follows, by experiment");
  verb->footer(kInferExamples);
  verb->add_option("--driver", options.choice.driver,
                   "lavapipe, swiftshader, the path of an ICD manifest (*.json), mutant:NAME, synthetic:SEED or synthetic:FIRST..LAST")
      ->capture_default_str();
  verb->add_option("-o,--output", options.output, "Write the profile here, for --rules");
  verb->add_flag("--json", options.json, "The card as JSON");
  verb->add_option("--seed", options.seed, "Seed of the experiments")->capture_default_str();
  addTimeout(*verb, options.choice);
}

void addBless(CLI::App& app, BlessOptions& options) {
  CLI::App* verb = app.add_subcommand("bless", "Turn what differs in a check's results into a baseline");
  verb->footer(kBlessExamples);
  verb->add_option("RESULTS", options.results, "File that check --json wrote")->required();
  verb->add_option("SCENE", options.scenes, "Only scenes with this name or glob");
  verb->add_option("-o,--output", options.baseline, "Baseline file; what it holds already is kept or renewed")->required();
  verb->add_option("--reason", options.reason, "Why they differ, in a sentence")->required()->check([](const std::string& text) {
    return text.empty() ? std::string("a difference without a reason is not known, only old") : std::string();
  });
  verb->add_option("--rule", options.rule, "Id of the broken rule, as R39");
  verb->add_option("--anchor", options.anchor, "Its place in the specification, as vk:fragops-scissor");
}

void addExport(CLI::App& app, ExportOptions& options) {
  CLI::App* verb = app.add_subcommand("export", "A scene as an Amber script, or as a scene file");
  verb->footer(kExportExamples);
  verb->add_option("SCENE", options.scene, "Catalogue name or scene file")->required();
  CLI::Option_group* what = verb->add_option_group("What");
  what->add_option("--amber", options.amber, "Write an Amber script");
  what->add_option("--scene", options.file, "Write a scene file");
  what->require_option(1, 2);
  addDriverOptions(*verb, options.choice, ", none: no device, common limits");
}

}  // namespace rasterdiff::harness::cli
