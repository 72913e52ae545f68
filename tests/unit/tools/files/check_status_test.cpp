// The words and exit codes of `check`.
#include "tools/files/check_status.h"

#include <gtest/gtest.h>

namespace hyrax {
namespace {

using enum CheckStatus;

TEST(CheckStatus, HasItsExitCode) {
  EXPECT_EQ(exit_code_of(agreed), ExitCode::agreed);
  EXPECT_EQ(exit_code_of(disagreed), ExitCode::disagreed);
  EXPECT_EQ(exit_code_of(missing), ExitCode::golden_missing);
  EXPECT_EQ(exit_code_of(unreferenced), ExitCode::disagreed);
}

TEST(CountsSentence, CountsEachStatus) {
  EXPECT_EQ(counts_sentence({}), "0 checked: 0 agreed, 0 disagreed, 0 without golden file, 0 failed");
  EXPECT_EQ(counts_sentence({agreed, failed, disagreed, agreed, missing, agreed, disagreed}),
            "7 checked: 3 agreed, 2 disagreed, 1 without golden file, 1 failed");
}

TEST(CountsSentence, DoesNotCountUnreferencedGoldenFilesAsScenarios) {
  EXPECT_EQ(counts_sentence({agreed, unreferenced, unreferenced}),
            "1 checked: 1 agreed, 0 disagreed, 0 without golden file, 0 failed; 2 unreferenced");
  EXPECT_EQ(counts_sentence({}, 2),
            "0 checked: 0 agreed, 0 disagreed, 0 without golden file, 0 failed; 2 folders failed");
}

}  // namespace
}  // namespace hyrax
