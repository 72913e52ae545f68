#include "sim/card/core_in_use.h"

#include <cfenv>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/replay/core.h"

namespace hyrax {
namespace {

std::string refusal_of(State (*steps)(State, double, const Bounds&, std::int64_t)) {
  const CoreFunctions core{.number = 1, .steps = steps};
  const CoreInUse in_use(core, "a fling");
  try {
    static_cast<void>(core_steps({}, 0.0, {}, 3));
  } catch (const CoreRefused& refusal) {
    EXPECT_EQ(refusal.core, 1);
    return refusal.what();
  }
  return "";
}

TEST(CoreInUse, RefusesACoreThatThrows) {
  EXPECT_EQ(
      refusal_of([](State, double, const Bounds&, std::int64_t) -> State { throw std::runtime_error(""); }),
      "throws an exception in a fling");
}

TEST(CoreInUse, RefusesACoreThatChangesTheRounding) {
  EXPECT_EQ(refusal_of([](State body, double, const Bounds&, std::int64_t) { return body; }), "");
  const std::string reason = refusal_of([](State body, double, const Bounds&, std::int64_t) {
    std::fesetround(FE_UPWARD);
    return body;
  });
  std::fesetround(FE_TONEAREST);
  EXPECT_TRUE(reason.starts_with("changes how the processor computes")) << reason;
}

// Exceptions that have occurred change nothing.
TEST(CoreInUse, AllowsInexactResults) {
  EXPECT_EQ(refusal_of([](State body, double, const Bounds&, std::int64_t) {
              std::feraiseexcept(FE_INEXACT | FE_UNDERFLOW);
              return body;
            }),
            "");
}

TEST(PlayWatch, NamesTheStepThatWasBegun) {
  PlayWatch watch{};
  watch.set_place("scenario a.json");
  EXPECT_EQ(watch.where(), "scenario a.json");
  watch.begin_call(40, 5);
  EXPECT_EQ(watch.where(), "scenario a.json");
  watch.updates = 2;
  EXPECT_EQ(watch.where(), "scenario a.json, step 42");
  watch.updates = 6;  // Not only those of the run.
  EXPECT_EQ(watch.where(), "scenario a.json");
  watch.set_place(std::string(500, 'a'));
  EXPECT_EQ(watch.where(), std::string(watch.place.size() - 1, 'a'));
}

}  // namespace
}  // namespace hyrax
