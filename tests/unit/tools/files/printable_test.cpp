// Untrusted text made printable for a terminal, which bytes of a text are UTF-8, and the message for an
// unknown name: what is allowed, and a suggestion.
#include <gtest/gtest.h>

#include <string>

#include "tools/files/printable.h"
#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

void expect_character(const std::string& text, std::size_t bytes, std::int32_t code) {
  const Utf8Character character = utf8_character(text, 0);
  EXPECT_EQ(character.bytes, bytes) << text;
  EXPECT_EQ(character.code, code) << text;
}

TEST(Utf8, IsTheFirstAndLastCharacterOfEachLengthAndNothingElse) {
  expect_character(std::string("\0", 1), 1, 0);
  expect_character("\x7f", 1, 0x7f);
  expect_character("\xc2\x80", 2, 0x80);
  expect_character("\xdf\xbf", 2, 0x7ff);
  expect_character("\xe0\xa0\x80", 3, 0x800);
  expect_character("\xef\xbf\xbf", 3, 0xffff);
  expect_character("\xf0\x90\x80\x80", 4, 0x10000);
  expect_character("\xf4\x8f\xbf\xbf", 4, 0x10ffff);
  for (const char* text : {"\x80", "\xbf", "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xf0\x8f\xbf\xbf",
                           "\xed\xa0\x80", "\xed\xbf\xbf", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff",
                           "\xc2", "\xe2\x82", "\xf0\x90\x80", "\xc2x", "\xe2\x82x"})
    expect_character(text, 1, -1);
}

TEST(Printable, KeepsPlainTextAndUtf8) {
  for (const char* text :
       {"", "a b", "\\", "\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80", "\xc2\xa0", "\xf4\x8f\xbf\xbf"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, EscapesWhatATerminalObeysAndBytesThatAreNoUtf8) {
  for (const auto& [text, shown] :
       {std::pair{"\x1b[31m", "\\u001b[31m"},
        {"a\nb\tc\x7f", "a\\u000ab\\u0009c\\u007f"},
        {"\xc2\x9b", "\\u009b"},  // CSI as one character.
        {"\x9b", "\\x9b"},
        {"\xe2\x80\xaegpj.json", "\\u202egpj.json"},  // Right to left from here on.
        {"\xe2\x81\xa9\xd8\x9c\xe2\x80\xa8", "\\u2069\\u061c\\u2028"},
        {"\xc3(", "\\xc3("},
        {"\xe0\x82\x9b", "\\xe0\\x82\\x9b"}})  // Overlong.
    EXPECT_EQ(printable(text), shown);
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\u0000");
  EXPECT_EQ(printable_lines("a\n\tb\x1b\r"), "a\n\tb\\u001b\\u000d");
}

TEST(OwnName, IsThatOfTheProgramWhereAMessageNamesIt) {
  name_program("hyrax-sim", "pet-sim");
  EXPECT_EQ(with_own_name("hyrax-sim run: x; see `hyrax-sim run --help`, or: hyrax-sim info"),
            "pet-sim run: x; see `pet-sim run --help`, or: pet-sim info");
  EXPECT_EQ(with_own_name("hyrax-sim.json: in a/hyrax-sim folder"), "hyrax-sim.json: in a/hyrax-sim folder");
  name_program("", "");
}

TEST(Shortened, KeepsSixtyBytesAndCutsBetweenCharacters) {
  const std::string before(58, 'a');
  EXPECT_EQ(shortened(before + "aa"), before + "aa");
  EXPECT_EQ(shortened(before + "aab"), before + "aa...");
  EXPECT_EQ(shortened(before + "\xe2\x82\xac and more"), before + "...");
  EXPECT_EQ(shortened(before + "\xc3\xa9 and more"), before + "\xc3\xa9...");
}

TEST(SizeText, HasAUnitThatIsNeverZero) {
  EXPECT_EQ(size_text(0), "0 bytes");
  EXPECT_EQ(size_text(1023), "1023 bytes");
  EXPECT_EQ(size_text(1024), "1.0 KiB");
  EXPECT_EQ(size_text((std::uint64_t{1} << 40) - 1), "1023.9 GiB");
  EXPECT_EQ(size_text(std::uint64_t{0} - 1), "15.9 EiB");
}

TEST(UnknownWord, NamesKindWordAndAllowedOnes) {
  EXPECT_EQ(unknown_word("key", "y", {"x_px", "y_px"}),
            "unknown key (found y); allowed: x_px, y_px (did you mean y_px?)");
  EXPECT_EQ(unknown_word("command", "paint", {"run", "check"}),
            "unknown command (found paint); allowed: run, check");
  EXPECT_EQ(unknown_word("key", "x", {}), "unknown key (found x); allowed: none");
  EXPECT_EQ(unknown_word("key", std::string(59, 'a') + "\xc3\xa9z", {}),
            "unknown key (found " + std::string(59, 'a') + "...); allowed: none");
}

TEST(UnknownWord, SuggestsTheNearestWordIfItIsNear) {
  const std::vector<std::string_view> words = {"vx_px_per_s", "vy_px_per_s", "check",
                                               "--golden",    "steps",       "a"};
  for (const auto& [found, suggested] : {std::pair{"chekc", "check"},    // Two letters exchanged.
                                         {"vx_px_pers", "vx_px_per_s"},  // One left out.
                                         {"--golde", "--golden"},        // Cut short.
                                         {"Steps", "steps"},
                                         {"vy_px_per_s2", "vy_px_per_s"}})
    EXPECT_TRUE(
        unknown_word("key", found, words).ends_with(std::string(", a (did you mean ") + suggested + "?)"))
        << found;
  for (const std::string& far :
       {std::string("colour"), std::string("q"), std::string(), std::string(1'000'000, 'x')})
    EXPECT_TRUE(unknown_word("key", far, words).ends_with(", a")) << far.substr(0, 9);
}

}  // namespace
}  // namespace hyrax
