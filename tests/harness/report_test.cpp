// The parts of the report that are hard to see from outside: records, sums, pictures, escaping.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "harness/report/base64.hpp"
#include "harness/report/markup.hpp"
#include "harness/report/numbers.hpp"
#include "harness/report/picture.hpp"
#include "harness/report/record.hpp"
#include "harness/report/text_picture.hpp"
#include "harness/report/time_text.hpp"

namespace rasterdiff::harness {
namespace {

/// One sample a pixel; row-major primitives.
Frame frameOf(uint32_t width, uint32_t height, const std::vector<uint32_t>& primitives) {
  Frame frame;
  frame.width = width;
  frame.height = height;
  frame.primitive = Plane<uint32_t>(width, height, 1);
  frame.count = Plane<uint32_t>(width, height, 1);
  for (size_t i = 0; i < primitives.size(); ++i) frame.count.data[i] = primitives[i] > 0 ? 1 : 0;
  frame.primitive.data.assign(primitives.begin(), primitives.end());
  return frame;
}

SceneEntry entryWith(Verdict verdict, uint64_t differing, const std::string& address) {
  SceneEntry entry;
  entry.result.id = "random/half-1x-w1";
  entry.result.verdict = verdict;
  entry.result.samples = 100;
  entry.result.same = 100 - differing;
  entry.result.differing = differing;
  entry.result.ruleCoverage = {{"R15", 7}};
  entry.address = address;
  entry.primitives = 500;
  if (differing > 0) entry.result.differences.push_back({3, 4, 0, Verdict::Differs, "wrong", "vk:x", 1, 2, 1, 1});
  return entry;
}

TEST(Record, AllBytesSurviveBase64) {
  std::string bytes;
  for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
  for (size_t length = 0; length <= bytes.size(); ++length) {
    EXPECT_EQ(fromBase64(toBase64(bytes.substr(0, length))), bytes.substr(0, length));
  }
  EXPECT_EQ(toBase64("Ma"), "TWE=");
}

TEST(Record, ASceneComesBackAsItWasSent) {
  SceneEntry sent = entryWith(Verdict::Differs, 2, "random/half-1x-w1@7000003");
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  ValueStats depth;
  depth.name = "depth";
  depth.compared = 10;
  depth.maxUlp = std::numeric_limits<double>::infinity();
  depth.worst = ValueStats::Worst{1, 2, 3, 0, 0.1F, nan, -infinity, infinity};
  sent.result.values = {depth};
  sent.pictures = {std::string("\x89PNG\0x", 6), "b", "c", "d", "<svg/>", 5, 6};
  sent.validationMessages = {"a \"quoted\" message"};
  const Result<SceneEntry> read = readSceneRecord(recordOf(sent));
  ASSERT_TRUE(read) << read.error().what;
  EXPECT_EQ(recordOf(*read), recordOf(sent));
  const ValueStats::Worst& worst = *read->result.values.at(0).worst;
  EXPECT_EQ(worst.expected, 0.1F);
  EXPECT_TRUE(std::isnan(worst.actual));
  EXPECT_EQ(worst.lo, -infinity);
  EXPECT_EQ(read->pictures.reference, sent.pictures.reference);
}

TEST(Record, EveryErrorCodeComesBack) {
  for (const ErrorCode code : {ErrorCode::BadInput, ErrorCode::Io, ErrorCode::NoDevice, ErrorCode::NotOffered,
                               ErrorCode::DeviceLost, ErrorCode::TimedOut}) {
    const Result<Error> read = readErrorRecord(recordOf(Error{code, "here", "this", "so"}));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->code, code);
    EXPECT_EQ(read->where, "here");
  }
}

TEST(Record, WhatIsNoRecordIsRefused) {
  for (const char* text : {"", "{", "[]", "null", "{\"id\": 3}", "{\"verdict\": \"Perhaps\"}"}) {
    EXPECT_FALSE(readSceneRecord(text)) << text;
    EXPECT_FALSE(readSubjectRecord(text)) << text;
    EXPECT_FALSE(readErrorRecord(text)) << text;
  }
  const std::string whole = recordOf(entryWith(Verdict::Same, 0, "a"));
  for (size_t length = 0; length < whole.size(); ++length) EXPECT_FALSE(readSceneRecord(whole.substr(0, length)));
}

TEST(Totals, BatchesAddUpAndTheWorstOneSpeaks) {
  SceneEntry sum = entryWith(Verdict::Same, 0, "f@1");
  addBatch(sum, entryWith(Verdict::Differs, 2, "f@2"));
  addBatch(sum, entryWith(Verdict::Differs, 5, "f@3"));
  addBatch(sum, entryWith(Verdict::Same, 0, "f@4"));
  EXPECT_EQ(sum.batches, 4U);
  EXPECT_EQ(sum.primitives, 2000U);
  EXPECT_EQ(sum.result.samples, 400U);
  EXPECT_EQ(sum.result.differing, 7U);
  EXPECT_EQ(sum.result.ruleCoverage.at("R15"), 28U);
  EXPECT_EQ(sum.result.verdict, Verdict::Differs);
  EXPECT_EQ(sum.address, "f@2");
}

Seconds everySecond(double unit) {
  return {1 * unit, 2 * unit, 60 * unit, 4 * unit, 5 * unit, {30 * unit, 20 * unit, 6 * unit, 3 * unit}};
}

TEST(Time, EveryPartSurvivesTheRecordAndAddsUp) {
  SceneEntry entry = entryWith(Verdict::Same, 0, "a");
  entry.result.seconds = everySecond(0.25);
  const Result<SceneEntry> read = readSceneRecord(recordOf(entry));
  ASSERT_TRUE(read);
  EXPECT_EQ(recordOf(*read), recordOf(entry));
  addBatch(entry, *read);
  const Seconds all = totalsOf(std::vector<SceneEntry>{entry, *read}).seconds;
  SceneEntry expected = entryWith(Verdict::Same, 0, "a");
  expected.result.seconds = everySecond(0.75);
  SceneEntry summed = entryWith(Verdict::Same, 0, "a");
  summed.result.seconds = all;
  EXPECT_EQ(recordOf(summed), recordOf(expected));
}

TEST(Time, WhatIsNotTheDriversOwnWorkIsTheHarnesss) {
  const Seconds seconds = everySecond(1);  // one second of the driver's call belongs to none of its parts
  EXPECT_EQ(ownSeconds(seconds), 1 + 2 + (60 - 30 - 20) + 4 + 5);
  EXPECT_EQ(shareText(seconds), "All but the driver's drawing and pipelines 22.0 s, 0.73 times its drawing");
  EXPECT_EQ(timeText(seconds),
            "driver 60.0 s (drawing 30.0 s, pipelines 20.0 s, upload 6.00 s, readback 3.00 s), reference 2.00 s, compare 4.00 s, "
            "set-up 1.00 s, pictures 5.00 s");
  EXPECT_EQ(shareText({}), "All but the driver's drawing and pipelines 0 µs");
}

TEST(Totals, ExitStatusRanksCrashOverErrorOverDifference) {
  const auto statusOf = [](std::vector<SceneEntry> scenes) {
    Report report;
    report.scenes = std::move(scenes);
    return exitStatus(report);
  };
  const SceneEntry same = entryWith(Verdict::Same, 0, "a"), differs = entryWith(Verdict::Differs, 1, "b");
  const SceneEntry crashed = entryWith(Verdict::Crashed, 0, "c"), skipped = entryWith(Verdict::Skipped, 0, "d");
  SceneEntry unmade = same, known = differs, improved = same;
  unmade.error = Error{};
  known.result.baseline = BaselineStatus::ExpectedDiff;
  improved.result.baseline = BaselineStatus::Improved;
  EXPECT_EQ(statusOf({same}), 0);
  EXPECT_EQ(statusOf({same, skipped}), 0);
  EXPECT_EQ(statusOf({skipped}), 3);
  EXPECT_EQ(statusOf({known}), 0);
  EXPECT_EQ(statusOf({improved}), 1);
  EXPECT_EQ(statusOf({same, differs}), 1);
  EXPECT_EQ(statusOf({same, differs, unmade}), 2);
  EXPECT_EQ(statusOf({same, differs, unmade, crashed}), 4);
}

TEST(TextPicture, MarksTheAskedPixelAndWhatDiffers) {
  Frame reference = frameOf(3, 2, {0, 4, 4, 9, 9, 4});
  reference.coverage = Plane<Coverage>(3, 2, 1, 1, Coverage::In);
  reference.coverage->data[3] = Coverage::Either;
  const Frame actual = frameOf(3, 2, {0, 4, 9, 9, 9, 4});
  EXPECT_EQ(textPicture(reference, &actual, {1, 0, 0}),
            "        reference    driver\n"
            "     0   . [A] A      . [A] B*\n"
            "     1   ?  B  A      B  B  A\n"
            "        columns 0 to 2: . none, A primitive 4, B primitive 9, ? either is legal,\n"
            "        * not the reference's own answer\n");
}

TEST(DifferencePicture, OneDifferingSampleSurvivesShrinking) {
  const Frame reference = frameOf(64, 64, std::vector<uint32_t>(64 * 64, 1));
  Frame actual = reference;
  actual.primitive.at(37, 21, 0) = 0;
  SceneResult result;
  result.differing = 1;
  const Image image = differenceImage(reference, actual, result);
  const Image small = shrunk(image, 8, Shrink::Worst);
  ASSERT_EQ(small.width, 8U);
  const size_t at = (21 / 8 * 8 + 37 / 8) * 4;
  EXPECT_GT(small.rgba[at], 200);      // red
  EXPECT_LT(small.rgba[at + 1], 64);   // not green
  EXPECT_EQ(small.rgba[0], small.rgba[4]);
}

TEST(DifferencePicture, AValueOutsideItsBoundsIsRedAndInsideIsNot) {
  Frame reference = frameOf(3, 1, {1, 1, 1});
  reference.depth = Plane<float>(3, 1, 1, 1, 0.5F);
  reference.depthBounds = Plane<Bounds>(3, 1, 1, 1, Bounds{0.4F, 0.6F});
  Frame actual = frameOf(3, 1, {1, 1, 1});
  actual.depth = Plane<float>(3, 1, 1);
  actual.depth->data = {0.5F, 0.55F, 0.7F};
  const Image image = differenceImage(reference, actual, SceneResult{});
  EXPECT_EQ(image.rgba[0], 128);
  EXPECT_LT(image.rgba[4], 200);
  EXPECT_GT(image.rgba[8], 200);
}

TEST(Pictures, UncoveredPixelsAreTransparentAndHalfCoveredOnesHalf) {
  Frame frame;
  frame.width = 2;
  frame.height = 1;
  frame.samples = 2;
  frame.primitive = Plane<uint32_t>(2, 1, 2);
  frame.primitive.data = {1, 0, 0, 0};
  const Image image = primitiveImage(frame);
  EXPECT_EQ(image.rgba[3], 128);
  EXPECT_EQ(image.rgba[7], 0);
}

TEST(Markup, NothingBreaksOutOfAnAttribute) {
  EXPECT_EQ(escaped("<a b=\"c\">'&"), "&lt;a b=&quot;c&quot;&gt;&#39;&amp;");
  EXPECT_EQ(escaped(std::string("x\0\x1b\xff\xc3\xa9\xed\xa0\x80", 9)), "x  ?\xc3\xa9???");
}

TEST(Numbers, ReadAsPeopleWriteThem) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1234567), "1,234,567");
  EXPECT_EQ(counted(1, "scene"), "1 scene");
  EXPECT_EQ(secondsText(125), "2 min 05 s");
  EXPECT_EQ(shellQuoted("fill/a-b"), "fill/a-b");
  EXPECT_EQ(shellQuoted("it's *"), "'it'\\''s *'");
}

}  // namespace
}  // namespace rasterdiff::harness
