// The sentence on what changed in a core that describes itself.
#include "tools/described/core_verdict.h"

#include <gtest/gtest.h>

namespace hyrax {
namespace {

TEST(DescribedCoreVerdict, NamesAChangedDefaultAndTheLinesOfAChangedStep) {
  const auto change = [](const char* detail, std::int64_t line) {
    DescribedChange made;
    made.detail = detail;
    made.line = line;
    return made;
  };
  DescribedCoreVerdict verdict;
  EXPECT_EQ(verdict.sentence(), "");
  verdict.changes = {change("gravity = 1000;", 7), change("vy *= -0.6;", 18)};
  EXPECT_EQ(verdict.sentence(), "the core changed at lines 7 and 18");
  verdict.changes.push_back(change("gravity 980 -> 1000", 0));
  EXPECT_EQ(verdict.sentence(), "gravity 980 -> 1000") << "the step is the same";
  verdict.differences.resize(1);
  EXPECT_EQ(verdict.sentence(), "gravity 980 -> 1000; the core changed at lines 7 and 18");
}

}  // namespace
}  // namespace hyrax
