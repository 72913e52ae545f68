// Untrusted text made printable for a terminal.
#include "tools/files/printable.h"

#include <gtest/gtest.h>

namespace hyrax {
namespace {

TEST(Printable, KeepsPlainTextAndUtf8) {
  for (const char* text :
       {"", "a b", "\\", "\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80", "\xc2\xa0", "\xf4\x8f\xbf\xbf"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, EscapesWhatATerminalObeys) {
  EXPECT_EQ(printable("\x1b[31m"), "\\u001b[31m");
  EXPECT_EQ(printable("a\nb\tc\x7f"), "a\\u000ab\\u0009c\\u007f");
  EXPECT_EQ(printable("\xc2\x9b"), "\\u009b");  // CSI as one character.
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\u0000");
}

TEST(Printable, EscapesBytesThatAreNoUtf8) {
  EXPECT_EQ(printable("\x9b"), "\\x9b");
  EXPECT_EQ(printable("\xc3("), "\\xc3(");
  EXPECT_EQ(printable("\xe0\x82\x9b"), "\\xe0\\x82\\x9b");  // Overlong.
}

TEST(Printable, KeepsLines) { EXPECT_EQ(printable_lines("a\n\tb\x1b\r"), "a\n\tb\\u001b\\u000d"); }

TEST(Shortened, KeepsSixtyBytes) {
  const std::string sixty(60, 'a');
  EXPECT_EQ(shortened(sixty), sixty);
  EXPECT_EQ(shortened(sixty + "b"), sixty + "...");
}

TEST(Shortened, CutsBetweenCharacters) {
  const std::string before(58, 'a');
  EXPECT_EQ(shortened(before + "\xe2\x82\xac and more"), before + "...");
  EXPECT_EQ(shortened(before + "\xc3\xa9 and more"), before + "\xc3\xa9...");
}

TEST(SizeText, HasAUnitThatIsNeverZero) {
  EXPECT_EQ(size_text(0), "0 bytes");
  EXPECT_EQ(size_text(1023), "1023 bytes");
  EXPECT_EQ(size_text(1024), "1.0 KiB");
  EXPECT_EQ(size_text(58'000), "56.6 KiB");
  EXPECT_EQ(size_text(1 << 20), "1.0 MiB");
  EXPECT_EQ(size_text((std::uint64_t{1} << 40) - 1), "1023.9 GiB");
  EXPECT_EQ(size_text(std::uint64_t{0} - 1), "15.9 EiB");
}

}  // namespace
}  // namespace hyrax
