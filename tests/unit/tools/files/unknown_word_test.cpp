// The message for an unknown name: what is allowed, and a suggestion.
#include "tools/files/unknown_word.h"

#include <gtest/gtest.h>

namespace hyrax {
namespace {

const std::vector<std::string_view> kKeys = {"x_px", "y_px", "vx_px_per_s", "vy_px_per_s"};

std::string suggested(std::string_view found, const std::vector<std::string_view>& allowed) {
  const std::string sentence = unknown_word("key", found, allowed);
  const std::string mark = " (did you mean ";
  const std::size_t begin = sentence.find(mark);
  if (begin == std::string::npos) return "";
  return sentence.substr(begin + mark.size(), sentence.size() - begin - mark.size() - 2);
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

TEST(UnknownWord, SuggestsTheNearestWord) {
  EXPECT_EQ(suggested("chekc", {"run", "check", "bless"}), "check");    // Two letters exchanged.
  EXPECT_EQ(suggested("vx_px_pers", kKeys), "vx_px_per_s");             // One left out.
  EXPECT_EQ(suggested("--golde", {"--json", "--golden"}), "--golden");  // Cut short.
  EXPECT_EQ(suggested("Steps", {"steps", "start"}), "steps");
  EXPECT_EQ(suggested("vy_px_per_s2", kKeys), "vy_px_per_s");
}

TEST(UnknownWord, SuggestsNothingThatIsNotNear) {
  EXPECT_EQ(suggested("colour", {"clock", "name", "start"}), "");
  EXPECT_EQ(suggested("q", {"a", "b"}), "");
  EXPECT_EQ(suggested("", kKeys), "");
  EXPECT_EQ(suggested(std::string(1'000'000, 'x'), kKeys), "");
}

}  // namespace
}  // namespace hyrax
