// Which bytes of a text are UTF-8.
#include "tools/files/printable.h"

#include <gtest/gtest.h>

#include <string>

namespace hyrax {
namespace {

void expect_character(const std::string& text, std::size_t bytes, std::int32_t code) {
  const Utf8Character character = utf8_character(text, 0);
  EXPECT_EQ(character.bytes, bytes) << text;
  EXPECT_EQ(character.code, code) << text;
}

TEST(Utf8, AcceptsTheFirstAndLastCharacterOfEachLength) {
  expect_character(std::string("\0", 1), 1, 0);
  expect_character("\x7f", 1, 0x7f);
  expect_character("\xc2\x80", 2, 0x80);
  expect_character("\xdf\xbf", 2, 0x7ff);
  expect_character("\xe0\xa0\x80", 3, 0x800);
  expect_character("\xef\xbf\xbf", 3, 0xffff);
  expect_character("\xf0\x90\x80\x80", 4, 0x10000);
  expect_character("\xf4\x8f\xbf\xbf", 4, 0x10ffff);
}

TEST(Utf8, RefusesWhatIsNone) {
  for (const char* text : {"\x80", "\xbf", "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xf0\x8f\xbf\xbf",
                           "\xed\xa0\x80", "\xed\xbf\xbf", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff",
                           "\xc2", "\xe2\x82", "\xf0\x90\x80", "\xc2x", "\xe2\x82x"})
    expect_character(text, 1, -1);
}

TEST(Utf8, ReadsTheCharacterAtAPlace) {
  const Utf8Character character = utf8_character(
      "a\xe2\x82\xac"
      "b",
      1);
  EXPECT_EQ(character.bytes, 3u);
  EXPECT_EQ(character.code, 0x20ac);
}

}  // namespace
}  // namespace hyrax
