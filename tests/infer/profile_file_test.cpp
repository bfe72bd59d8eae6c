// Profiles survive being written and read; bad ones are refused with their place.
#include "harness/profile/profile_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

// g++ 12 sees an overlapping copy in its own std::string::replace (GCC bug 105651).
#pragma GCC diagnostic ignored "-Wrestrict"
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "harness/infer/synthetic.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Choice;

Profile someProfile(uint64_t seed) {
  Profile profile;
  profile.name = "some \"driver\" 1.0";
  profile.driver = "some";
  profile.info = "1.0";
  profile.choices = syntheticRules(seed).choices;
  return profile;
}

bool conforms(const std::string& text) {
  std::ifstream file(RASTERDIFF_SOURCE_DIR "/harness/profile/profile.schema.json");
  const nlohmann::json schemaText = nlohmann::json::parse(file), document = nlohmann::json::parse(text);
  valijson::Schema schema;
  valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(schemaText), schema);
  valijson::Validator validator;
  return validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), nullptr);
}

std::string errorOf(const std::string& text) {
  const Result<Profile> profile = parseProfile(text, "p.json");
  EXPECT_FALSE(profile.has_value()) << text;
  return profile ? "" : profile.error().where + ": " + profile.error().what;
}

TEST(ProfileFile, WrittenProfilesAreReadBackAndConformToTheSchema) {
  for (uint64_t seed = 0; seed < 50; ++seed) {
    const Profile profile = someProfile(seed);
    const std::string text = writeProfile(profile);
    EXPECT_TRUE(conforms(text)) << text;
    const Result<Profile> read = parseProfile(text, "p.json");
    ASSERT_TRUE(read.has_value()) << read.error().what;
    EXPECT_EQ(read->choices, profile.choices);
    EXPECT_EQ(read->openChoices, 0U);
    EXPECT_EQ(read->name, profile.name);
  }
}

TEST(ProfileFile, NullAndMissingChoicesStayOpen) {
  Profile profile = someProfile(3);
  profile.openChoices = rasterizer::bitOf(Choice::LineArithmetic) | rasterizer::bitOf(Choice::TieOwner);
  const std::string text = writeProfile(profile);
  EXPECT_TRUE(conforms(text)) << text;
  EXPECT_EQ(parseProfile(text, "p.json")->openChoices, profile.openChoices);
  const std::string little = R"({"format": "rasterdiff-profile-1", "choices": {"tieOwner": "BottomRight"}})";
  EXPECT_TRUE(conforms(little));
  const Result<Profile> read = parseProfile(little, "p.json");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->choices.tieOwner, rasterizer::TieOwner::BottomRight);
  EXPECT_EQ(read->openChoices, (1U << rasterizer::kChoices) - 1 - rasterizer::bitOf(Choice::TieOwner));
}

TEST(ProfileFile, SchemaAndTableListTheSameAnswers) {
  std::ifstream file(RASTERDIFF_SOURCE_DIR "/harness/profile/profile.schema.json");
  const nlohmann::json schema = nlohmann::json::parse(file);
  const nlohmann::json& listed = schema["properties"]["choices"]["properties"];
  EXPECT_EQ(listed.size(), rasterizer::kChoices + 1);  // and sampleLocations
  for (const rasterizer::ChoiceInfo& row : rasterizer::choiceTable()) {
    nlohmann::json answers(row.answers);
    answers.push_back(nullptr);
    EXPECT_EQ(listed[std::string(row.name)]["enum"], answers) << row.name;
  }
}

TEST(ProfileFile, MistakesAreRefusedWithTheirPlace) {
  EXPECT_EQ(errorOf(R"({"choices": {}})"), "p.json:1:1: a profile without 'format'");
  EXPECT_EQ(errorOf("{\"format\": \"rasterdiff-profile-1\",\n \"choices\": {\"tieOwner\": \"TopLift\"}}").substr(0, 13), "p.json:2:26: ");
  EXPECT_NE(errorOf(R"({"format": "rasterdiff-profile-2", "choices": {}})").find("is no format"), std::string::npos);
  EXPECT_NE(errorOf(R"({"format": "rasterdiff-profile-1", "choices": {"tiesOwner": null}})").find("tiesOwner"), std::string::npos);
  EXPECT_NE(errorOf(R"({"format": "rasterdiff-profile-1", "choices": {"tieOwner": 3}})").find("string"), std::string::npos);
  const std::string locations = R"({"format": "rasterdiff-profile-1", "choices": {"sampleLocations": )";
  EXPECT_NE(errorOf(locations + R"({"4": [[1, 2]]}}})").find("one place for each sample"), std::string::npos);
  EXPECT_NE(errorOf(locations + R"({"1": [[1, 16]]}}})").find("multiple of 1/16"), std::string::npos);
  EXPECT_NE(errorOf(locations + R"({"3": []}}})").find("3"), std::string::npos);
  EXPECT_FALSE(loadProfile("no/such/profile.json").has_value());
}

}  // namespace
}  // namespace rasterdiff::harness
