// `render`: one side alone, as pictures for people and arrays for programs.
#include <fmt/format.h>

#include <filesystem>

#include "harness/cli/isolated.hpp"
#include "harness/cli/message.hpp"
#include "harness/cli/rule_choice.hpp"
#include "harness/cli/run.hpp"
#include "harness/cli/selection.hpp"
#include "harness/report/npy.hpp"
#include "harness/report/output.hpp"
#include "harness/report/picture.hpp"
#include "rasterizer/render.hpp"

namespace rasterdiff::harness::cli {
namespace {

/// Writes all files and returns their paths, one a line.
Result<std::string> writeFrame(const std::filesystem::path& folder, const Frame& frame) {
  const Result<std::vector<std::filesystem::path>> arrays = writeNpyFiles(folder, frame);
  if (!arrays) return tl::unexpected(arrays.error());
  std::string written;
  for (const auto& [name, image] : allImages(frame)) {
    const Result<std::string> png = encodePng(image);
    if (!png) return tl::unexpected(png.error());
    const std::filesystem::path path = folder / (name + ".png");
    if (Result<void> done = writeFile(path, *png); !done) return tl::unexpected(done.error());
    written += path.string() + "\n";
  }
  for (const std::filesystem::path& path : *arrays) written += path.string() + "\n";
  return written;
}

Result<std::string> renderReference(const Scene& scene, const RenderOptions& options) {
  const Result<rasterizer::Rules> rules = rulesWithoutDriver(options.choice.rules);
  if (!rules) return tl::unexpected(rules.error());
  const Result<Frame> frame = rasterizer::render(scene, *rules);
  if (!frame) return tl::unexpected(frame.error());
  return writeFrame(options.folder, *frame);
}

Result<std::string> renderDriver(const Scene& scene, const RenderOptions& options) {
  const Result<std::unique_ptr<Subject>> subject = openSubject(subjectOptions(options.choice));
  if (!subject) return tl::unexpected(subject.error());
  const Result<Frame> frame = (*subject)->render(scene);
  if (!frame) return tl::unexpected(frame.error());
  Result<std::string> written = writeFrame(options.folder, *frame);
  if (!written) return written;
  return fmt::format("drawn by {}\n{}", subjectLine(**subject), *written);
}

}  // namespace

int runVerb(const RenderOptions& options) {
  if (const Result<void> known = checkRulesName(options.choice.rules); !known) {
    return complain(known.error(), "rasterdiff render --help");
  }
  const Result<Job> job = selectScene(options.scene);
  if (!job) return complain(job.error(), nextCommand(job.error(), "render"));
  const Result<Scene> scene = drawable(*job);
  if (!scene) return complain(scene.error(), nextCommand(scene.error(), "render"));
  const Result<std::string> written =
      options.withDriver
          ? isolated(watchdogSeconds(options.choice.timeoutSeconds), [&] { return renderDriver(*scene, options); })
          : renderReference(*scene, options);
  if (!written) return complain(written.error(), nextCommand(written.error(), "render"));
  fmt::print("{}", *written);
  return 0;
}

}  // namespace rasterdiff::harness::cli
