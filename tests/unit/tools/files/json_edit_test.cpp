// Values in a JSON text are set; nothing else changes.
#include "tools/files/json_edit.h"

#include <gtest/gtest.h>

#include "tools/files/scenario_reader.h"

namespace hyrax {
namespace {

constexpr char kHash[] = "0123456789abcdef0123456789abcdef";
constexpr char kOldHash[] = "ffffffffffffffffffffffffffffffff";

constexpr char kBegin[] =
    R"({"format": "hyrax-scenario/1", "name": "x", "description": "\"{ \\\u00e9 state_hash",
 "window": {"width_px": 10, "height_px": 10}, "sprite" :{"width_px":1,"height_px":1},
	"start": { "x_px": 1e0, "y_px": 2.50 }, "clock": { "dt_s": [0.1, 0.2] })";

std::string scenario_with(const std::string& end) { return kBegin + end; }

// The text is a valid scenario before and after, and then has the hash.
void expect_text(const std::string& before, const std::string& after) {
  static_cast<void>(parse_scenario(before, "before"));
  const std::string found = with_value(before, {"expect", "state_hash"}, std::string("\"") + kHash + '"');
  EXPECT_EQ(found, after);
  EXPECT_EQ(parse_scenario(found, "after").expect->state_hash, kHash);
}

TEST(JsonEdit, ReplacesTheHash) {
  const auto text = [](const std::string& hash) {
    return scenario_with(",\n  \"expect\" :\r\n{ \"contacts\": {\"top\": [0, 1] },\"state_hash\":\t\"" +
                         hash + "\" , \"finite\": true} } \n\n");
  };
  expect_text(text(kOldHash), text(kHash));
  expect_text(text(kHash), text(kHash));
}

TEST(JsonEdit, FindsTheHashByItsKeyHoweverItIsWritten) {
  const auto text = [](const std::string& hash) {
    return scenario_with(R"(, "\u0065xpect": {"state\u005fhash": ")" + hash + "\"}}");
  };
  expect_text(text(kOldHash), text(kHash));
}

TEST(JsonEdit, AddsAHashToExpectationsInTheirLayoutOrWithThem) {
  const std::string added = std::string("\"state_hash\": \"") + kHash + '"';
  expect_text(scenario_with(R"(, "expect": { "finite": true } })"),
              scenario_with(R"(, "expect": { "finite": true, )" + added + " } }"));
  expect_text(scenario_with(",\n \"expect\": {\n    \"finite\": true\n  }\n}\n"),
              scenario_with(",\n \"expect\": {\n    \"finite\": true,\n    " + added + "\n  }\n}\n"));
  expect_text(scenario_with(R"(, "expect": {}})"), scenario_with(R"(, "expect": { )" + added + " }}"));
  expect_text(scenario_with("}\n"), scenario_with(R"(,"expect": { )" + added + " }}\n"));
}

TEST(JsonEdit, SetsTheElementsOfAnArray) {
  EXPECT_EQ(with_elements("{\"a\" : {\"b\":[ 1,\n 2e0 ] }}", {"a", "b"}, {"3", "4.5"}),
            "{\"a\" : {\"b\":[ 3,\n 4.5 ] }}");
  EXPECT_EQ(with_elements("{\"b\": 7 ,\"c\":[1,2]}", {"b"}, {"3"}), "{\"b\": 3 ,\"c\":[1,2]}");
  EXPECT_EQ(with_elements("{\"b\": 7 ,\"c\":[1 ,2]}", {"c"}, {"3", "4"}), "{\"b\": 7 ,\"c\":[3 ,4]}");
}

}  // namespace
}  // namespace hyrax
