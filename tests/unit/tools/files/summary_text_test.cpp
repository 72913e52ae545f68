#include "tools/files/summary_text.h"

#include <gtest/gtest.h>

#include <vector>

namespace hyrax {
namespace {

const std::string kSummaryHash = "c0ea1a610d86b14114d3cef7071362e5";

TEST(SummaryStateHash, IsThatOfItsLine) {
  EXPECT_EQ(summary_state_hash("scenario: a\nstate hash: " + kSummaryHash + "\nend: t 10 s\n"), kSummaryHash);
  EXPECT_EQ(summary_state_hash("scenario: a\nstate hash: " + kSummaryHash), kSummaryHash);
}

TEST(SummaryStateHash, IsEmptyWhereNoneIsStated) {
  const std::vector<std::string> lines = {"",
                                          "state hash: ",
                                          "state hash: " + kSummaryHash.substr(1),
                                          "state hash: " + kSummaryHash + "0",
                                          "state hash: " + kSummaryHash + "\r",
                                          "state hash: C" + kSummaryHash.substr(1),
                                          " state hash: " + kSummaryHash,
                                          "hash: " + kSummaryHash};
  for (const std::string& line : lines)
    EXPECT_EQ(summary_state_hash("scenario: a\n" + line + "\nend: t 10 s\n"), "") << line;
}

TEST(SummaryReason, IsOneLine) {
  EXPECT_EQ(summary_reason("scenario: a\nreason: a longer throw\nreason: b\n"), "a longer throw");
  EXPECT_EQ(summary_reason("scenario: a\n"), "");
}

}  // namespace
}  // namespace hyrax
