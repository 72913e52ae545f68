#include "tools/files/json_pointer.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "sim/scenario/split_mix64.h"
#include "tests/unit/tools/files/refusal.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

using namespace std::string_literals;

Json parsed(const std::string& text) { return parse_json(text, "f.json"); }

// The messages for text that is not JSON.
std::string refusal(const std::string& text) {
  return refusal_of([&] { static_cast<void>(parsed(text)); });
}

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

// Finite doubles of every exponent.
double any_double(std::uint64_t k) {
  const auto value = std::bit_cast<double>(split_mix64(99, k));
  return std::isfinite(value) ? value : static_cast<double>(k);
}

std::int64_t count_doubles_lost(std::uint64_t count) {
  std::int64_t lost = 0;
  for (std::uint64_t k = 0; k < count; ++k)
    if (bits(parsed(to_text(any_double(k))).number()) != bits(any_double(k))) ++lost;
  return lost;
}

TEST(Json, KeepsIntegersOf64BitsAndReadsLargerOnesAsDoubles) {
  EXPECT_EQ(*parsed("18446744073709551615").get<std::uint64_t>(), 18446744073709551615u);
  EXPECT_EQ(*parsed("-9223372036854775808").get<std::int64_t>(), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(to_text(parsed("18446744073709551615")), "18446744073709551615");
  EXPECT_EQ(to_text(parsed("9007199254740993")), "9007199254740993");
  for (const auto& [text, integer] : {std::pair{"9007199254740993.0", 9007199254740993u},
                                      {"9007199254740993e0", 9007199254740993u},
                                      {"9007199254740993000.00e-3", 9007199254740993u},
                                      {"1.2345678901234567891e19", 12345678901234567891u},
                                      {"0.00018446744073709551615E+23", 18446744073709551615u},
                                      {"18446744073709551615.0", 18446744073709551615u}})
    EXPECT_EQ(to_text(parsed(text)), std::to_string(integer)) << text;
  EXPECT_EQ(*parsed("18446744073709551616").get<double>(), 0x1p64);
  EXPECT_EQ(*parsed("18446744073709551616.0").get<double>(), 0x1p64);
  EXPECT_EQ(*parsed("-9223372036854775809").get<double>(), -0x1p63);
}

TEST(Json, RoundsDecimalsCorrectlyAndKeepsTheSignOfZero) {
  for (const auto& [text, value] : {std::pair{"-0", -0.0},
                                    {"-0.0", -0.0},
                                    {"-0e5", -0.0},
                                    {"0", 0.0},
                                    {"1e-400", 0.0},
                                    {"0.1", 0.1},
                                    {"2.2250738585072011e-308", 0x0.fffffffffffffp-1022},
                                    {"4.9e-324", 5e-324},
                                    {"9007199254740993.0", 9007199254740992.0},  // A tie, to even.
                                    {"9007199254740993.00000000000000000000000000001", 9007199254740994.0}})
    EXPECT_EQ(bits(parsed(text).number()), bits(value)) << text;
  EXPECT_EQ(to_text(parsed("-0")), "-0");
}

TEST(Json, KnowsAFractionThatIsLostInRounding) {
  for (const char* const text :
       {"60", "60.0", "1e9", "1.50e1", "-0.0", "0e-99999999999999999999", "1200e-2", "10.0000e-1"})
    EXPECT_TRUE(parsed(text).is_whole()) << text;
  for (const char* const text :
       {"60.5", "99.99999999999999999999999", "1e-400", "1e-99999999999999999999", "1205e-1"})
    EXPECT_FALSE(parsed(text).is_whole()) << text;
  for (const char* const text : {"99.99999999999999999999999", "1e-400", "9007199254740993.5"})
    EXPECT_EQ(to_text(parsed(text)), text);
}

TEST(Json, KeepsTheTextsOfNumbersBeyondBinary64) {
  const std::string digits(1000, '9');
  const std::string text = "[0e0, 1e999, 2, 1.5, -1e309, " + digits + ", 0e0]";
  const Json json = parsed(text);
  EXPECT_EQ(to_text(json), "[0, 1e999, 2, 1.5, -1e309, " + digits + ", 0]");
  const auto& numbers = *json.get<Json::Array>();
  EXPECT_EQ(numbers[1].number(), HUGE_VAL);
  EXPECT_EQ(numbers[4].number(), -HUGE_VAL);
  EXPECT_FALSE(numbers[1].is_whole());
}

TEST(Json, ReadsBackTheBitsOfEveryDouble) { EXPECT_EQ(count_doubles_lost(100'000), 0); }

TEST(Json, ReadsAndWritesTheSameWhereACommaMarksDecimals) {
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) {
    ASSERT_EQ(std::getenv("CI"), nullptr) << "no German locale";
    GTEST_SKIP() << "no German locale here; ctest makes one where localedef can";
  }
  const std::string comma = std::localeconv()->decimal_point;
  const std::int64_t lost = count_doubles_lost(10'000);
  const std::string written = to_text(parsed("[0.5, 1e-3, 60.5]"));
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(comma, ",");
  EXPECT_EQ(lost, 0);
  EXPECT_EQ(written, "[0.5, 0.001, 60.5]");
}

TEST(Json, WritesWhatIsNotFiniteAsText) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(to_text(Json::Array{infinity, -infinity, std::nan("")}), R"(["Infinity", "-Infinity", "NaN"])");
}

TEST(Json, KeepsOrderAndRepetitionOfKeysAndEscapesWhatATextCannotHold) {
  EXPECT_EQ(to_text(parsed(R"({"b": 1, "a": 2, "b": 3})")), R"({ "b": 1, "a": 2, "b": 3 })");
  EXPECT_EQ(parsed(R"({"b": 1, "b": 3})").find("b")->number(), 1.0);
  const std::string text = R"("\"\\\n\u0000ä\u2028")";
  for (const std::string& each : {text, to_text(parsed(text))})
    EXPECT_EQ(*parsed(each).get<std::string>(), "\"\\\n\0ä\u2028"s);
}

TEST(JsonRefusal, NamesLineAndColumn) {
  for (const auto& [text, place, part] : std::initializer_list<std::array<std::string, 3>>{
           {"{\n  \"a\": 1,\n  \"b\": ?\n}", "line 3, column 8", "not JSON"},
           {"\r\n{\r\n\r\n  ?\r\n}", "line 4, column 3", "not JSON"},
           {"?", "line 1, column 1", "not JSON"},
           {"", "line 1, column 1", "unexpected end of input"},
           {"{} x", "line 1, column 4", "expected end of input"},
           {"[1] [2]", "line 1, column 5", "expected end of input"},
           {"1\n2", "line 2, column 1", "expected end of input"},
           {"{}\0"s, "line 1, column 3", "zero byte"},
           {"{}\n\0 x"s, "line 2, column 1", "zero byte"},
           {"\0"s, "line 1, column 1", "zero byte"},
           {"\xEF\xBB\xBF{}", "line 1, column 1", "save it as UTF-8 without one"},
           {"[\n\"\xff\"]", "line 2, column 2", "ill-formed UTF-8 byte"},
           {"[1e999, ?]", "line 1, column 9", "not JSON"}}) {
    const std::string said = refusal(text);
    EXPECT_TRUE(said.starts_with("f.json: " + place + ": ")) << said;
    EXPECT_NE(said.find(part), std::string::npos) << said;
  }
  for (const char* const text : {"{} \r\n\t", "1.7976931348623157e308"}) EXPECT_EQ(refusal(text), "");
}

TEST(JsonRefusal, ShowsOnlyAPartOfALongTokenOrNumberAndOnlyWhatCanBeRead) {
  const std::string said = refusal("[\"" + std::string(100'000, 'x') + "\xff\"]");
  EXPECT_LT(said.size(), 300u);
  EXPECT_NE(said.find("xxx?'"), std::string::npos);
  std::string text = "[1e999";  // Very many numbers beyond binary64.
  for (int number = 0; number < 20; ++number) text += ",\n1" + std::string(100'000, '0');
  EXPECT_EQ(refusal(text + "]"),
            "f.json: line 21, column 100001: number is too large (found 1" + std::string(59, '0') + "...)");
}

TEST(JsonRefusal, IsForWhatOnlyOtherDialectsHaveAndBytesThatAreNoUtf8) {
  for (const std::string text :
       {"NaN",       "Infinity",    "-Infinity",   "+1",    ".5",      "1.",        "01",
        "-",         "0x10",        "1e",          "1e+",   "--1",     "1e309.5",   "{'a': 1}",
        "{a: 1}",    "[1,]",        "{\"a\": 1,}", "[1 2]", "// x\n1", "/* x */ 1", "\"a\tb\"",
        "\"\\x41\"", "\"\\ud800\"", "True",        "nul"})
    EXPECT_NE(refusal(text), "") << text;
  for (const std::string bytes : {"\xff", "\xc0\x80", "\xc3", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\x80"})
    EXPECT_NE(refusal("{\"" + bytes + "\": 1}").find("ill-formed UTF-8 byte"), std::string::npos);
  EXPECT_NE(refusal("\xFF\xFE{\0}\0"s), "");
}

TEST(JsonRefusal, IsForNestingWithoutEnd) {
  EXPECT_EQ(refusal(std::string(100, '[') + std::string(100, ']')), "");
  EXPECT_EQ(refusal(std::string(101, '[') + std::string(101, ']')),
            "f.json: line 1, column 101: nested more than 100 levels");
  EXPECT_EQ(refusal(std::string(10'000'000, '[')), "f.json: line 1, column 101: nested more than 100 levels");
  const std::string before = R"({"a]": "[\"{\\", "b": [1, {}], "c": )";  // Brackets that are closed, or text.
  EXPECT_EQ(
      refusal(before + std::string(100, '[')),
      "f.json: line 1, column " + std::to_string(before.size() + 100) + ": nested more than 100 levels");
}

std::string set(Json json, const std::string& pointer, const Json& value) {
  const std::string refused = refusal_of([&] { set_at(json, pointer, value); });
  return refused.empty() ? to_text(json) : refused;
}

// Each row is a document, a pointer, and the document in which 9 is set there, or the message.
TEST(JsonPointer, ReplacesAValueMakesWhatIsMissingOnTheWayAndReportsWhatDoesNotExist) {
  const std::string path = HYRAX_SOURCE_DIR "/tests/unit/tools/files/pointers.json";
  const Json table = parse_json(read_text_file(path), path);
  for (const Json& row : *table.get<Json::Array>()) {
    const Json::Array& parts = *row.get<Json::Array>();
    const std::string* const refused = parts[2].get<std::string>();
    EXPECT_EQ(set(parts[0], *parts[1].get<std::string>(), 9), refused ? *refused : to_text(parts[2]));
  }
  EXPECT_EQ(pointer_to("/x", "a/~b"), "/x/a~1~0b");
}

TEST(JsonPointer, GoesNoDeeperThanADocumentMayNest) {
  std::string pointer;
  for (int level = 0; level < 100; ++level) pointer += "/a";
  const Json empty = Json::Object{};
  EXPECT_TRUE(set(empty, pointer, 9).starts_with("{ \"a\": "));
  EXPECT_NE(set(empty, pointer + "/a", 9).find("nested more than 100 levels"), std::string::npos);
  for (int level = 0; level < 100'000; ++level) pointer += "/a";
  EXPECT_LT(set(empty, pointer, 9).size(), 200u);
}

TEST(HexFloat, IsWhatTheCLibraryPrints) {
  for (const double value : {0.0, -0.0, 1.0, -0.5, 1.0 / 3.0, 952.0, 1e300, 2.2250738585072014e-308, 5e-324,
                             -1e-323, 5.924e-321, 2.2250738585072009e-308, HUGE_VAL, -HUGE_VAL}) {
    char printed[40];
    std::snprintf(printed, sizeof printed, "%a", value);
    EXPECT_EQ(hex_float(value), printed);
  }
}

}  // namespace
}  // namespace hyrax
