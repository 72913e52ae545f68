// Scenario files: defaults, overrides, what cannot be read, and the readers against the table of good and bad
// documents, which also tests the JSON Schema.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <unistd.h>

#include "sim/scenario/frame_clock.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/files/refusal.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/json_pointer.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/sweep_reader.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

const std::string kScenarios = std::string(HYRAX_SOURCE_DIR) + "/scenarios/";

class ScenarioFile : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    write_bytes(folder_.at(name), text);
    return folder_.at(name);
  }
  // The message for the file and its overrides.
  static std::string refusal(const std::string& path, const std::vector<Override>& overrides = {}) {
    return refusal_of([&] { static_cast<void>(load_scenario(path, overrides)); });
  }

  const TempFolder folder_;
};

constexpr char kNameless[] =
    R"({"format": "hyrax-scenario/1", "window": {"width_px": 800, "height_px": 600}, "sprite": {"width_px": 9, "height_px": 9},
        "start": {"x_px": -0, "y_px": 2}, "clock": {"rate_hz": 60}, "steps": 5})";

TEST_F(ScenarioFile, LeavesWhatIsLeftOutAtItsDefault) {
  const Scenario scenario = load_scenario(file("plain.json", kNameless));
  EXPECT_EQ(scenario.name, "plain");
  EXPECT_EQ(scenario.start_velocity, Velocity{});
  EXPECT_EQ(scenario.record_every, 1);
  EXPECT_FALSE(scenario.description || scenario.schema || scenario.expect || scenario.clock.jitter);
  EXPECT_TRUE(std::signbit(scenario.start.x_px));
}

TEST_F(ScenarioFile, ThatIsAFolderCannotBeRead) {
  EXPECT_EQ(refusal_of([] { static_cast<void>(load_scenario(kScenarios)); }, ExitCode::cannot_access),
            kScenarios + ": cannot be read: Is a directory");
}

// As of `<(command)` in a shell.
TEST_F(ScenarioFile, MayComeThroughAPipeThatIsOpen) {
  for (const std::string folder : {"/dev/fd/", "/proc/self/fd/"}) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    ASSERT_EQ(write(ends[1], kNameless, sizeof kNameless - 1), static_cast<ssize_t>(sizeof kNameless - 1));
    close(ends[1]);
    EXPECT_EQ(load_scenario(folder + std::to_string(ends[0]), {{"/name", "piped"}}).name, "piped");
    close(ends[0]);
  }
}

TEST_F(ScenarioFile, TakesOverridesByPointer) {
  const std::string path = kScenarios + "flings/corner-fling.json";
  const Scenario scenario = load_scenario(path, {{"/clock/rate_hz", "72"},
                                                 {"/start/x_px", "-0"},
                                                 {"/name", "earlier"},
                                                 {"/name", "other"},
                                                 {"/description", "42 flings"},
                                                 {"/clock/jitter/seed", "18446744073709551615.0"},
                                                 {"/events/0/fling/vx_px_per_s", "1e3"},
                                                 {"/events/-", R"({"step": 899, "stop": {}})"},
                                                 {"/record/every", "10"}});
  EXPECT_EQ(base_dt_s(scenario.clock), 1.0 / 72.0);
  EXPECT_TRUE(std::signbit(scenario.start.x_px));
  EXPECT_EQ(scenario.name, "other");
  EXPECT_EQ(scenario.description, "42 flings");
  EXPECT_EQ(scenario.clock.jitter->seed, 18446744073709551615u);
  EXPECT_EQ(std::get<Fling>(scenario.events[0].action).velocity.vx_px_per_s, 1000.0);
  EXPECT_EQ(scenario.events.size(), 8u);
  EXPECT_EQ(scenario.record_every, 10);
}

// Comparing each key with all earlier ones would be slow. A key may contain control sequences for a terminal.
TEST_F(ScenarioFile, ReportsManyUnknownKeysInPrintableCharacters) {
  std::string text = R"({"\u0000\u001b[2J\n": 1,)";
  for (int key = 0; key < 10'000; ++key) text += "\"" + std::to_string(key) + "\": 0,";
  const std::string message = refusal(file("keys.json", text + "\"0\": 0}"));
  for (const char* const part :
       {R"(/\u0000\u001b[2J\u000a: unknown key)", "/9999: unknown key", "/0: duplicate key"})
    EXPECT_NE(message.find(part), std::string::npos) << part;
}

TEST_F(ScenarioFile, HoldsOverridesToTheSameRulesAndNeedsANameWhereItsOwnIsNone) {
  const std::string path = file("Not_A_Name.json", kNameless);
  EXPECT_EQ(refusal(path),
            path +
                ": /name: is missing, and the file name is not a name (found Not_A_Name); a name is 1 .. 64 "
                "of the characters a-z, 0-9 and -");
  EXPECT_EQ(load_scenario(path, {{"/name", "a-name"}}).name, "a-name");
  const auto overridden = [&](const char* pointer, const char* value) {
    return refusal(path, {{"/name", "a-name"}, {pointer, value}});
  };
  EXPECT_EQ(overridden("/steps", "many"),
            path + ": /steps: must be a whole number 0 .. 1000000000000 (found \"many\")");
  EXPECT_TRUE(overridden("/stpes", "7").starts_with(path + ": /stpes: unknown key"));
  EXPECT_EQ(overridden("/steps/x", "7"), path + ": /steps/x: does not exist (found no 'x')");
  EXPECT_TRUE(overridden("steps", "7").starts_with(path + ": steps: is not a JSON Pointer"));
}

TEST_F(ScenarioFile, KeepsTheSignOfZeroWhenWritten) {
  Scenario scenario = fling_at(60.0, 5, {{std::int64_t{1}, Fling{{-0.0, 0.0}}}});
  scenario.start = {-0.0, 0.0};
  scenario.clock.base = FixedStep{-0.0};
  const Scenario again = parse_scenario(scenario_file_text(scenario), "written");
  EXPECT_TRUE(std::signbit(again.start.x_px));
  EXPECT_FALSE(std::signbit(again.start.y_px));
  EXPECT_TRUE(std::signbit(std::get<FixedStep>(again.clock.base).dt_s));
  EXPECT_TRUE(std::signbit(std::get<Fling>(again.events[0].action).velocity.vx_px_per_s));
}

constexpr char kSource[] = "some/base.json";

const Json& table() {
  static const std::string path = std::string(HYRAX_SOURCE_DIR) + "/tests/unit/tools/files/verdicts.json";
  static const Json document = parse_json(read_text_file(path), path);
  return document;
}

const std::string& text_of(const Json& entry, std::string_view key) {
  return *entry.find(key)->get<std::string>();
}

// The table's entries, one for each place of those with `at`.
std::vector<Json> entries() {
  std::vector<Json> all;
  for (const Json& entry : *table().find("verdicts")->get<Json::Array>()) {
    if (entry.find("at") == nullptr) {
      all.push_back(entry);
      continue;
    }
    for (const Json& place : *table().find("places")->find(text_of(entry, "at"))->get<Json::Array>()) {
      std::string text = to_text(entry);
      for (std::size_t star; (star = text.find("\"*\"")) != text.npos;) text.replace(star, 3, to_text(place));
      all.push_back(parse_json(text, kSource));
    }
  }
  return all;
}

constexpr char kTakenOut[] = "taken out";

// Members that have this text are taken out.
void take_out(Json& json) {
  if (auto* const array = json.get<Json::Array>())
    for (Json& element : *array) take_out(element);
  if (auto* const object = json.get<Json::Object>()) {
    std::erase_if(*object, [](const auto& member) {
      const auto* const text = member.second.template get<std::string>();
      return text != nullptr && *text == kTakenOut;
    });
    for (auto& [key, value] : *object) take_out(value);
  }
}

Json document_of(const Json& entry, std::string_view base = "base") {
  if (entry.find("text") != nullptr) return parse_json(text_of(entry, "text"), kSource);
  Json document = *table().find(base);
  if (entry.find("at") != nullptr) set_at(document, "/events", *table().find("events"));
  if (const Json* values = entry.find("set"))
    for (const auto& [pointer, value] : *values->get<Json::Object>()) set_at(document, pointer, value);
  if (const Json* pointers = entry.find("without"))
    for (const Json& pointer : *pointers->get<Json::Array>())
      set_at(document, *pointer.get<std::string>(), kTakenOut);
  take_out(document);
  return document;
}

// The reader's message for an entry's document; empty for a good one.
std::string message_for(const Json& entry) {
  return refusal_of([&] { EXPECT_NE(to_scenario(document_of(entry), kSource, "base").name, ""); });
}

// The entry, and what is said of its document.
std::string verdict(const Json& entry, const std::string& message) {
  EXPECT_EQ(message.empty(), entry.find("refused") == nullptr) << to_text(entry) << message;
  return to_text(entry) + "\n" + message + "\n";
}

TEST(ScenarioVerdicts, OfScenariosAndSweepsAreThoseApproved) {
  std::string text;
  for (const Json& entry : entries()) text += verdict(entry, message_for(entry));
  for (const Json& entry : *table().find("sweeps")->get<Json::Array>())
    text += verdict(entry, refusal_of([&] {
                      static_cast<void>(parse_sweep(to_text(document_of(entry, "sweep")), kSource));
                    }));
  expect_approved("tests/unit/tools/files/verdicts.txt", text);
}

TEST(ScenarioVerdicts, OfGoodDocumentsReadTheSameOnceWritten) {
  for (const Json& entry : entries()) {
    if (entry.find("refused") != nullptr) continue;
    const Scenario scenario = to_scenario(document_of(entry), kSource, "base");
    const std::string text = scenario_file_text(scenario);
    const Scenario again = parse_scenario(text, "written");
    EXPECT_TRUE(plays_the_same(scenario, again)) << text;
    EXPECT_EQ(scenario.name, again.name) << text;
    EXPECT_EQ(scenario.description, again.description) << text;
    EXPECT_EQ(scenario.schema, again.schema) << text;
    EXPECT_EQ(scenario.expect, again.expect) << text;
    EXPECT_EQ(scenario_file_text(again), text);
  }
}

// A small file must not make a report of hundreds of megabytes.
TEST(ScenarioVerdicts, ListOnlyTheFirstOfVeryManyErrors) {
  std::string text = R"({"format": "hyrax-scenario/1", "name": "base", "events": [0)";
  for (int event = 1; event < 200'010; ++event) text += ",0";
  const std::string said = refusal_of([&] { static_cast<void>(parse_scenario(text + "]}", kSource)); });
  EXPECT_EQ(std::ranges::count(said, '\n'), 200'000);
  // Beside the events, window, sprite, start and clock are missing.
  EXPECT_TRUE(said.ends_with(std::string("\n") + kSource + ": and 14 more errors"));
}

}  // namespace
}  // namespace hyrax
