// Scenarios of described cores: the reader against the table of good and bad documents, which also tests the
// JSON Schema; what is written reads back the same.
#include "tools/described/scenario_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/described/pool_description.h"
#include "tests/unit/tools/files/refusal.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/json_pointer.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

const std::string kFolder = "tests/unit/tools/described/";

Json document_of(const Json& entry, const Json& base) {
  if (const auto* const text = entry.get<std::string>("text")) return parse_json(*text, "some/base.json");
  Json document = base;
  if (const auto* const set = entry.get<Json::Object>("set"))
    for (const auto& [pointer, value] : *set) set_at(document, pointer, value);
  if (const auto* const without = entry.get<Json::Array>("without"))
    for (const Json& pointer : *without)
      std::erase_if(*document.get<Json::Object>(),
                    [&](const auto& member) { return "/" + member.first == *pointer.get<std::string>(); });
  return document;
}

TEST(DescribedScenarioJson, IsJudgedAsTheTableSays) {
  const Json table = parse_json(
      read_text_file(std::string(HYRAX_SOURCE_DIR) + "/" + kFolder + "verdicts.json"), "verdicts.json");
  const Description pool = pool_description();
  std::size_t refused = 0;
  for (const Json& entry : *table.get<Json::Array>("verdicts")) {
    SCOPED_TRACE(*entry.get<std::string>("name"));
    std::string expected;
    if (const auto* const faults = entry.get<Json::Array>("faults"))
      for (const Json& fault : *faults)
        expected += (expected.empty() ? "" : "\n") + ("some/base.json: " + *fault.get<std::string>());
    DescribedScenario scenario;
    const std::string message = refusal_of([&] {
      scenario = to_described_scenario(pool, document_of(entry, *table.find("base")), "some/base.json", "");
    });
    EXPECT_EQ(message, expected);
    refused += expected.empty() ? 0 : 1;
    if (!expected.empty()) continue;
    const Json written = to_json(pool, scenario);
    EXPECT_EQ(parse_described_scenario(pool, to_text(written), "written"), scenario);
    const Json* const start = entry.find("start");
    if (start != nullptr) {
      EXPECT_EQ(to_text(*written.find("start")), to_text(*start));
    }
  }
  EXPECT_GT(refused, 40u);
}

TEST(DescribedScenarioJson, OverridesMakeAMissingObject) {
  const TempFolder folder;
  const std::string path = folder.at("least.json");
  write_bytes(path, R"({"format": "hyrax-scenario/1", "clock": {"rate_hz": 60}, "steps": 2})");
  const DescribedScenario scenario = load_described_scenario(pool_description(), path,
                                                             {{"/start/a.x_px", "120"},
                                                              {"/start/mood", "wild"},
                                                              {"/inputs/push", "true"},
                                                              {"/parameters/gravity_px_per_s2", "-0"}});
  EXPECT_EQ(scenario.name, "least");
  EXPECT_EQ(scenario.start, (std::vector<GivenValue>{{0, word_of(120.0)}, {3, 1}}));
  EXPECT_EQ(scenario.inputs, (std::vector<GivenValue>{{1, 1}}));
  EXPECT_EQ(scenario.parameters, (std::vector<GivenValue>{{0, word_of(-0.0)}}));
}

TEST(DescribedScenarioJson, AFloatIsWrittenShortestAndReadsBackTheSame) {
  const ValueInfo value = value_info("speed", 0.1F);
  EXPECT_EQ(value_text(value, word_of(0.1F)), "0.1");
  EXPECT_EQ(value_text(value, word_of(16777216.0F)), "16777216");
  std::uint32_t bits = 1;
  for (int tried = 0; tried < 100'000; ++tried) {
    bits = bits * 1664525U + 1013904223U;
    const float speed = std::bit_cast<float>(bits);
    if (!std::isfinite(speed)) continue;
    const Json written = parse_json(value_text(value, word_of(speed)), "float");
    JsonProblems problems;
    EXPECT_EQ(read_value(JsonPlace(&written, "", problems), value), word_of(speed)) << speed;
  }
}

TEST(DescribedScenarioJson, ALimitOfAFloatBindsTheNumberAsItIsWritten) {
  const auto read = [](const char* text) {
    const Json number = parse_json(text, "float");
    JsonProblems problems;
    return read_value(JsonPlace(&number, "", problems), value_info<float>("gain", 1.0F, {{0.1F, 2.0F}}));
  };
  EXPECT_EQ(read("0.1"), word_of(0.1F));
  EXPECT_EQ(read("2"), word_of(2.0F));
  EXPECT_EQ(read("2.0000001"), std::nullopt);     // Rounds to 2.
  EXPECT_EQ(read("0.0999999999"), std::nullopt);  // Rounds to 0.1.
}

TEST(DescribedScenarioJson, AnEventIsWrittenWithoutItsTime) {
  const Description pool = pool_description();
  EXPECT_EQ(to_text(event_json(pool, Act{0, {word_of(1.5), word_of(-2.0)}})),
            R"({ "strike": { "vx_px_per_s": 1.5, "vy_px_per_s": -2 } })");
  EXPECT_EQ(to_text(event_json(pool, SetValues{{{1, 1}}, {{3, 1}}})),
            R"({ "set": { "push": true, "mood": "wild" } })");
  EXPECT_EQ(to_text(event_json(pool, Hold{})), R"({ "hold": {} })");
}

TEST(DescribedScenarioJson, NoPlaceToRestIsAnErrorWithoutPixels) {
  Description clock;
  clock.core = "clock";
  clock.state.values = {value_info("hand_rad", 0.0)};
  EXPECT_EQ(refusal_of([&] {
              static_cast<void>(parse_described_scenario(
                  clock,
                  R"({"format": "hyrax-scenario/1", "name": "a", "clock": {"rate_hz": 60}, "steps": 2,
                      "expect": {"at_rest_since_s": 1}})",
                  "a.json"));
            }),
            "a.json: /expect/at_rest_since_s: needs a state value in px; the core clock has none (names that "
            "end in _px)");
}

TEST(DescribedScenarioJson, AnInfiniteLimitOrDefaultIsOneOfTheCoreAndOfNoFile) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Description open;
  open.core = "open";
  open.state.values = {value_info<double>("x", 0.0, {{0.0, kInfinity}})};
  open.parameters.values = {value_info("cap", kInfinity), value_info("none", std::nan("")),
                            value_info("low", -std::numeric_limits<float>::infinity())};
  const std::string text = to_text(description_json(open), 3);
  EXPECT_EQ(parse_description(text, "open", "description"), open) << text;
  EXPECT_EQ(value_text(open.parameters.values[2], open.parameters.values[2].initial), "-Infinity");
  EXPECT_EQ(file_limits(open.state.values[0]), (std::array{word_of(0.0), word_of(1.7976931348623157e308)}));
  EXPECT_EQ(to_text(schema_json(open)).find("Infinity"), std::string::npos);
}

TEST(DescribedScenarioJson, DescriptionAndSchemaAreApproved) {
  const Description pool = pool_description();
  expect_approved(kFolder + "pool_description.json", to_text(description_json(pool), 3) + "\n");
  expect_approved(kFolder + "pool_schema.json", to_text(schema_json(pool), 3) + "\n");
}

// Not the JSON of hundreds of thousands of long lists of names.
TEST(DescribedScenarioJson, ManyErrorsInLongListsTakeLittleTime) {
  Description many;
  many.core = "many";
  for (int value = 0; value < 500; ++value)
    many.state.values.push_back(value_info("value_" + std::to_string(value), 0.0));
  std::string text =
      R"({"format": "hyrax-scenario/1", "name": "a", "clock": {"rate_hz": 60}, "steps": 2, "start": {)";
  for (int key = 0; key < 20'000; ++key) text += "\"key_" + std::to_string(key) + "\": 0,";
  const std::string message = refusal_of(
      [&] { static_cast<void>(parse_described_scenario(many, text + "\"value_0\": 1}}", "a.json")); });
  EXPECT_NE(message.find("a.json: /start/key_0: unknown key (found key_0); allowed: value_0, value_1, "),
            std::string::npos);
  EXPECT_NE(message.find(" and 460 more"), std::string::npos);
  EXPECT_LT(message.size(), 3'000'000u);
}

}  // namespace
}  // namespace hyrax
