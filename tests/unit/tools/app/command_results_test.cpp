#include "tools/app/command_line/command_results.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace hyrax {
namespace {

TEST(CommandResults, GoOnAfterAFailureOfAnyKind) {
  CommandResults results;
  results.attempt("a", [] { throw std::logic_error("oops"); });
  results.attempt("b", [] { refuse_input("b: bad"); });
  results.attempt("d", [] { throw UnplacedFailure(ExitCode::disagreed, "worse"); });
  results.attempt("c", [&] { results.add(Json::Object{{"scenario", "c"}, {"status", "good"}}); });
  results.attempt_after([] { throw std::logic_error("late"); });
  EXPECT_EQ(results.exit_code(), ExitCode::program_fault);
  EXPECT_EQ(to_text(results.take_json("results")),
            R"({ "results": [{ "scenario": "a", "status": "failed", "error": "a: internal error: oops" }, )"
            R"({ "scenario": "b", "status": "failed", "error": "b: bad" }, )"
            R"({ "scenario": "d", "status": "failed", "error": "d: worse" }, )"
            R"({ "scenario": "c", "status": "failed", "error": "hyrax-sim: internal error: late" }] })");
}

}  // namespace
}  // namespace hyrax
