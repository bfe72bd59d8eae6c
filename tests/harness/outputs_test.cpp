// The files that a run writes: JSON as its schema says, HTML that loads nothing, PNG and .npy that others can read.
#include <gtest/gtest.h>
#include <png.h>

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "tests/harness/program.hpp"

namespace rasterdiff::test {
namespace {

/// Everything that the document breaks of harness/report/results.schema.json; empty = valid.
std::string complaintsAbout(const nlohmann::json& document) {
  using Adapter = valijson::adapters::NlohmannJsonAdapter;
  const auto text = nlohmann::json::parse(readAll(RASTERDIFF_SOURCE_DIR "/harness/report/results.schema.json"));
  valijson::Schema schema;
  valijson::SchemaParser().populateSchema(Adapter(text), schema);
  valijson::ValidationResults results;
  valijson::Validator().validate(schema, Adapter(document), &results);
  std::string complaints;
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (const std::string& part : error.context) complaints += part;
    complaints += ": " + error.description + "\n";
  }
  return complaints;
}

nlohmann::json resultsOf(const std::vector<std::string>& words) {
  const TemporaryFolder folder;
  const std::string path = folder.path("results.json");
  std::vector<std::string> all{"check"};
  all.insert(all.end(), words.begin(), words.end());
  all.insert(all.end(), {"--json", path});
  (void)runProgram(all);
  return nlohmann::json::parse(readAll(path));
}

TEST(Json, EveryKindOfRunFollowsTheSchema) {
  const std::vector<std::vector<std::string>> runs{
      {"*/*", "--driver", "mutant:tie-owner-bottom-right", "--shard", "1/4"},
      {"random/*", "--driver", "mutant:missing-perspective", "--rules", "spec"},
      {"random/half-*", "--driver", "fault:crash=*4x*", "--jobs", "1"},
      {"random/half-*", "--driver", "fault:refuse"},
      {"random/*", "--driver", "fault:lost"}};
  for (const auto& words : runs) EXPECT_EQ(complaintsAbout(resultsOf(words)), "") << words[2];
}

TEST(Json, TheSchemaRefusesWhatIsNotResults) {
  nlohmann::json results = resultsOf({"random/half-*", "--driver", "fault:refuse"});
  results["scenes"][0]["verdict"] = "Perhaps";
  EXPECT_NE(complaintsAbout(results), "");
}

TEST(Json, CountsAddUp) {
  const nlohmann::json results = resultsOf({"random/*", "--driver", "mutant:half-pixel-shift"});
  uint64_t samples = 0, differing = 0;
  for (const auto& scene : results.at("scenes")) {
    const uint64_t all = scene.at("samples");
    EXPECT_EQ(all, scene.at("same").get<uint64_t>() + scene.at("allowed").get<uint64_t>() + scene.at("differing").get<uint64_t>());
    samples += all;
    differing += scene.at("differing").get<uint64_t>();
  }
  EXPECT_GT(differing, 0U);
  EXPECT_EQ(results.at("totals").at("samples"), samples);
  EXPECT_EQ(results.at("totals").at("differing"), differing);
}

TEST(Json, RoundsChangeNothingButTimes) {
  const auto withoutTimes = [](nlohmann::json results) {
    for (auto& scene : results.at("scenes")) scene.erase("seconds");
    return results.at("scenes");
  };
  const std::vector<std::string> scenes{"random/half-*", "depth/*", "--driver", "mutant:depth-undivided"};
  std::vector<std::string> thrice = scenes;
  thrice.insert(thrice.end(), {"--rounds", "3"});
  EXPECT_EQ(withoutTimes(resultsOf(thrice)), withoutTimes(resultsOf(scenes)));
}

TEST(Json, PartsOfTheDriversTimeAreThoseOfTheWholeCall) {
  const nlohmann::json results = resultsOf({"fill/*", "samples/*", "invariant/indexed"});
  ASSERT_FALSE(results.at("scenes").empty()) << "no driver";
  double drawing = 0;
  for (const auto& scene : results.at("scenes")) {
    const nlohmann::json& seconds = scene.at("seconds");
    const double parts = seconds.at("drawing").get<double>() + seconds.at("pipelines").get<double>() +
                         seconds.at("upload").get<double>() + seconds.at("readback").get<double>();
    EXPECT_LE(parts, seconds.at("driver").get<double>() * (1 + 1e-9)) << scene.at("id");
    EXPECT_EQ(seconds.at("pictures"), 0.0);
    drawing += seconds.at("drawing").get<double>();
  }
  EXPECT_GT(drawing, 0);
  EXPECT_NEAR(results.at("totals").at("seconds").at("drawing").get<double>(), drawing, 1e-9 * drawing);
}

TEST(Json, ARendererThatIsNoDeviceOnlyDraws) {
  const nlohmann::json results = resultsOf({"fill/*", "--driver", "mutant:half-pixel-shift"});
  for (const auto& scene : results.at("scenes")) {
    const nlohmann::json& seconds = scene.at("seconds");
    EXPECT_EQ(seconds.at("drawing"), seconds.at("driver"));
    for (const char* part : {"pipelines", "upload", "readback"}) EXPECT_EQ(seconds.at(part), 0.0);
  }
}

TEST(Html, LoadsNothingFromAnywhere) {
  const TemporaryFolder folder;
  const std::string path = folder.path("report.html");
  ASSERT_EQ(runProgram({"check", "fill/*", "random/*", "--driver", "mutant:half-pixel-shift", "--report", path}).status, 1);
  const std::string html = readAll(path);
  ASSERT_NE(html.find("<!doctype html>"), std::string::npos);
  for (const char* loader : {"src=", "<link", "url("}) {
    for (size_t at = html.find(loader); at != std::string::npos; at = html.find(loader, at + 1)) {
      EXPECT_NE(html.substr(at, 40).find("data:"), std::string::npos) << html.substr(at, 80);
    }
  }
  EXPECT_EQ(html.find("@import"), std::string::npos);
  EXPECT_EQ(html.find("<script"), std::string::npos);
}

TEST(Html, ShowsFailuresFirstAndOpen) {
  const TemporaryFolder folder;
  const std::string path = folder.path("report.html");
  (void)runProgram({"check", "random/half-*", "--driver", "fault:crash=random/half-4x-persp", "--report", path});
  const std::string html = readAll(path);
  const size_t crashed = html.find("random/half-4x-persp"), same = html.find("random/half-1x-w1");
  ASSERT_NE(crashed, std::string::npos);
  ASSERT_NE(same, std::string::npos);
  EXPECT_LT(crashed, same);
  EXPECT_NE(html.find("<details class=\"scene\" open><summary>"), std::string::npos);
  EXPECT_NE(html.find(">FAIL</div>"), std::string::npos);
}

TEST(Junit, HasASuiteAFamilyAndACaseAScene) {
  const TemporaryFolder folder;
  const std::string path = folder.path("junit.xml");
  (void)runProgram({"check", "random/half-*", "--driver", "fault:refuse=*1x*", "--junit", path});
  const std::string xml = readAll(path);
  EXPECT_NE(xml.find("<testsuite name=\"random\" tests=\"4\" failures=\"0\" errors=\"0\" skipped=\"2\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("name=\"random/half-4x-persp\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("<skipped message="), std::string::npos) << xml;
}

struct Npy {
  std::string header;
  std::vector<uint32_t> words;  ///< the data, 4 bytes an element
};

/// Reads version 1.0 files.
Npy readNpy(const std::string& path) {
  const std::string bytes = readAll(path);
  if (bytes.size() < 10 || bytes.compare(0, 8, std::string("\x93NUMPY\x01\x00", 8)) != 0) return {};
  const size_t length = static_cast<uint8_t>(bytes[8]) + 256U * static_cast<uint8_t>(bytes[9]);
  Npy npy{bytes.substr(10, length), std::vector<uint32_t>((bytes.size() - 10 - length) / 4)};
  EXPECT_EQ((10 + length) % 64, 0U);
  std::memcpy(npy.words.data(), bytes.data() + 10 + length, npy.words.size() * 4);
  return npy;
}

TEST(Npy, RenderWritesEverySampleOfEveryPlane) {
  const TemporaryFolder folder;
  const Outcome outcome = runProgram({"render", "random/half-4x-w1", "--with", "reference", "-o", folder.path("out")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Npy coverage = readNpy(folder.path("out/coverage.npy")), count = readNpy(folder.path("out/count.npy"));
  EXPECT_NE(coverage.header.find("'descr': '<u4', 'fortran_order': False, 'shape': (256, 256, 4), "), std::string::npos)
      << coverage.header;
  ASSERT_EQ(coverage.words.size(), 256U * 256 * 4);
  ASSERT_EQ(count.words.size(), coverage.words.size());
  size_t covered = 0;
  for (size_t i = 0; i < coverage.words.size(); ++i) {
    EXPECT_EQ(coverage.words[i] > 0, count.words[i] > 0);
    covered += coverage.words[i] > 0;
  }
  EXPECT_GT(covered, 0U);
}

TEST(Npy, DumpHoldsBothSides) {
  const TemporaryFolder folder;
  const Outcome outcome =
      runProgram({"check", "random/values-w1", "--driver", "fault:crash=nothing", "--dump", folder.path("planes")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* file : {"coverage.npy", "count.npy", "depth.npy"}) {
    const Npy reference = readNpy(folder.path("planes/random/values-w1/reference/") + file);
    const Npy driver = readNpy(folder.path("planes/random/values-w1/driver/") + file);
    EXPECT_GT(reference.words.size(), 0U) << file;
    EXPECT_EQ(reference.words, driver.words) << file;
  }
}

TEST(Png, RenderWritesPicturesThatShowWhatIsCovered) {
  const TemporaryFolder folder;
  ASSERT_EQ(runProgram({"render", "random/half-1x-w1", "--with", "reference", "-o", folder.path("out")}).status, 0);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&png, folder.path("out/primitive.png").c_str()), 0) << png.message;
  png.format = PNG_FORMAT_RGBA;
  std::vector<uint8_t> rgba(PNG_IMAGE_SIZE(png));
  ASSERT_NE(png_image_finish_read(&png, nullptr, rgba.data(), 0, nullptr), 0) << png.message;
  const Npy coverage = readNpy(folder.path("out/coverage.npy"));
  ASSERT_EQ(rgba.size(), coverage.words.size() * 4);
  for (size_t pixel = 0; pixel < coverage.words.size(); ++pixel) {
    EXPECT_EQ(rgba[pixel * 4 + 3], coverage.words[pixel] > 0 ? 255 : 0) << pixel;
  }
}

}  // namespace
}  // namespace rasterdiff::test
