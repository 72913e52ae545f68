// A card: what a core does to its process reaches neither it nor the program, and which core is the candidate
// and which the base wherever it names them.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "sim/card/compared_core.h"
#include "tests/unit/sim/result/described.h"
#include "tools/files/failure.h"
#include "tools/hyrax-compare/card_report.h"
#include "tools/hyrax-compare/core_file.h"

namespace hyrax {
namespace {

using Work = std::function<std::string(PlayWatch&)>;

// The exit code, and the card or the message.
std::pair<ExitCode, std::string> outcome_of(const Work& work) {
  try {
    return {ExitCode::agreed, in_core_process({"base.h", "new.h"}, 60, TemporaryFolder(), work)};
  } catch (const Failure& failure) {
    return {failure.exit_code(), failure.what()};
  }
}

TEST(CoreProcess, WhatACorePrintsIsNoPartOfTheCard) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const auto outcome = outcome_of([](PlayWatch&) {
    for (std::FILE* const stream : {stdout, stderr}) std::fputs("loud\n", stream);
    std::fflush(nullptr);
    return std::string("the card\n");
  });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(outcome.second, "the card\n");
}

TEST(CoreProcess, HowItEndsNamesTheCoreAndThePlace) {
  const auto playing = [](void (*end)()) {
    return outcome_of([end](PlayWatch& watch) {
      watch.core = 1;
      watch.set_place("fling 3");
      watch.begin_call(40, 10);
      watch.updates = 2;
      end();
      return std::string();
    });
  };
  using Ended = std::pair<ExitCode, std::string>;
  EXPECT_EQ(playing([] { std::abort(); }),
            Ended(ExitCode::bad_input, "new.h: refused: crashes in fling 3, step 42: SIGABRT"));
  EXPECT_EQ(playing([] { std::_Exit(0); }),
            Ended(ExitCode::bad_input, "new.h: refused: ends the process in fling 3, step 42"));
  EXPECT_EQ(playing([] { throw CoreRefused(0, "why"); }), Ended(ExitCode::bad_input, "base.h: refused: why"));
  EXPECT_EQ(playing([] { throw Failure(ExitCode::golden_missing, "none"); }),
            Ended(ExitCode::golden_missing, "none"));
  EXPECT_EQ(playing([] { throw std::runtime_error("oops"); }),
            Ended(ExitCode::program_fault, "hyrax-compare: internal error: oops"));
}

Result some_card() {
  const Table lines{"card", "a library of 2", {{"line", "", "", std::vector<std::string>{"library"}}}};
  return {.tables = {{"changes", "what changed", {}}},
          .figures = {{.title = "rest"}},
          .verdict = {.text = {lines}, .brief = "no bit differs"},
          .summary = {{"library", "", {{"same", "1", "", std::vector{2.0}}}, JsonShape::one}}};
}

TEST(CardReport, NamesTheCandidateFirst) {
  const BeforeAfter<std::string> headers{.before = "old/base.h", .after = "new/candidate.h"};
  expect_approved("tests/unit/tools/report/card.txt",
                  card_text(some_card(), headers) + card_json(some_card(), headers) +
                      to_text(result_json(shown_card(some_card(), headers)), 1) + "\n");
  EXPECT_EQ(shown_card(some_card(), {"old/physics.h", "new/physics.h"}).title,
            "physics.h: candidate against base");
}

}  // namespace
}  // namespace hyrax
