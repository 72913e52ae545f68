// The readers against the table of good and bad documents, which also tests the JSON Schema.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/unit/tools/files/refusal.h"
#include "tools/files/json_pointer.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/sweep_reader.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

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

// The reader's message for an entry's document, one line per fault; empty for a good one.
std::string message_for(const Json& entry) {
  return refusal_of([&] { EXPECT_NE(to_scenario(document_of(entry), kSource, "base").name, ""); });
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// "SOURCE: PLACE: ... a part of the sentence ...".
bool reports(const std::string& line, const std::string& place, const std::string& part) {
  const std::string beginning = std::string(kSource) + ": " + place + (place.starts_with('/') ? ": " : "");
  return line.starts_with(beginning) && line.find(part, beginning.size()) != std::string::npos;
}

// Every fault of the entry is reported in a line of its own, and nothing else is reported.
void expect_reported(const Json& entry, const std::string& message) {
  std::vector<std::string> lines = lines_of(message);
  if (const Json* faults = entry.find("faults"))
    for (const Json& fault : *faults->get<Json::Array>()) {
      const Json::Array& pair = *fault.get<Json::Array>();
      const auto line = std::find_if(lines.begin(), lines.end(), [&](const std::string& text) {
        return reports(text, *pair[0].get<std::string>(), *pair[1].get<std::string>());
      });
      if (line != lines.end())
        lines.erase(line);
      else
        ADD_FAILURE() << to_text(entry) << ": not reported: " << *pair[0].get<std::string>() << ": "
                      << *pair[1].get<std::string>() << "\n but: " << message;
    }
  for (const std::string& line : lines) ADD_FAILURE() << to_text(entry) << ": also reported: " << line;
}

TEST(ScenarioVerdicts, AreWhatTheReaderSays) {
  const std::vector<Json> all = entries();
  ASSERT_GT(all.size(), 590u);
  for (const Json& entry : all) expect_reported(entry, message_for(entry));
}

TEST(SweepVerdicts, AreWhatTheReaderSays) {
  const Json::Array& sweeps = *table().find("sweeps")->get<Json::Array>();
  ASSERT_GE(sweeps.size(), 60u);
  for (const Json& entry : sweeps)
    expect_reported(entry, refusal_of([&] {
                      static_cast<void>(parse_sweep(to_text(document_of(entry, "sweep")), kSource));
                    }));
}

TEST(ScenarioVerdicts, OfGoodDocumentsReadTheSameOnceWritten) {
  for (const Json& entry : entries()) {
    if (entry.find("faults") != nullptr) continue;
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
  const std::vector<std::string> lines =
      lines_of(refusal_of([&] { static_cast<void>(parse_scenario(text + "]}", kSource)); }));
  ASSERT_EQ(lines.size(), 200'001u);
  // Beside the events, window, sprite, start and clock are missing.
  EXPECT_EQ(lines.back(), std::string(kSource) + ": and 14 more errors");
}

// Control: a table that expects too little, or something else, does not pass.
TEST(ScenarioVerdicts, NeedTheirPlaceAndSentence) {
  const std::string line = std::string(kSource) + ": /clock/rate_hz: must be greater than 0 (found -60)";
  EXPECT_TRUE(reports(line, "/clock/rate_hz", "greater than 0"));
  EXPECT_FALSE(reports(line, "/clock", "greater than 0"));
  EXPECT_FALSE(reports(line, "/clock/rate_hz", "at most 1"));
}

}  // namespace
}  // namespace hyrax
