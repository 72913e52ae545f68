#include "sim/trace/host/described_explorer.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "sim/described/traced_description.h"
#include "sim/trace/host/number_functions.h"
#include "sim/trace/host/recorder.h"
#include "sim/trace/step_difference.h"
#include "sim/trace/step_text.h"

namespace hyrax {
namespace {

using trace::Real;
using trace::Truth;
using trace::Whole;

class DescribedExplorer : public testing::Test {
 protected:
  DescribedExplorer() {
    trace::set_stop_handler([](const char* why) { throw std::runtime_error(why); });
  }
  ~DescribedExplorer() override { trace::set_stop_handler(nullptr); }

  template <class Core>
  static TracedStep step_of() {
    return canonical(trace::trace_described(see::traced_calls_of<Core>()));
  }
  template <class Core>
  static std::string why_incomplete() {
    try {
      return step_text(step_of<Core>());
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }
};

enum class Mood : std::uint8_t { calm, wild, tired };

enum Gear { reverse, neutral, forward };
enum Wide : unsigned { narrow, wide };
template <class Lever>
struct Geared {
  Real x = 0.0;
  Lever lever = {};
  void step(const Real& dt) { x += dt * (lever - Real(1.0)) + (dt > lever ? lever * 2 : lever); }
  void state(auto&& see) {
    see("x_px", x);
    see("lever", lever, {"low", "high"});
  }
};

// A step over what most cores have; `Change` makes it another one.
template <class Change>
struct Core {
  Real x = 10.0, v = 3.0, gravity = 900.0, wind = 0.0;
  Whole hits = 0;
  Mood mood = Mood::calm;
  Truth floor = false;  // Every step sets it before it reads it: it need not be declared.
  Change change = {};

  void step(const Real& dt) {
    v += change.fall(gravity, dt);
    x += v * dt + wind * dt;
    floor = x > 300;
    if (floor) v = -v * change.bounce(), ++hits;
    mood = floor ? Mood::wild : mood;
    change.end(*this);
  }
  void state(auto&& see) {
    see("x_px", x);
    see("v_px_per_s", v);
    see("hits", hits);
    see("mood", mood, {"calm", "wild", "tired"});
    change.declare(see);
  }
  void inputs(auto&& see) { see("wind_px_per_s", wind, {-10.0, 10.0}); }
  void parameters(auto&& see) { see("gravity_px_per_s2", gravity); }
  void actions(auto&& see) {
    see("kick", [&](Real up, Truth hard) { v = hard ? -up * 2 : -up; }, {"up_px_per_s", "hard"});
    see("rest", [&] { v = 0, change.rest(); });
  }
  void contacts(auto&& see) const { see("floor", floor); }
};
struct Nothing {
  static Real fall(const Real& gravity, const Real& dt) { return gravity * dt; }
  static Real bounce() { return 0.5; }
  void end(auto& /*core*/) {}
  void rest() {}
  void declare(auto&& /*see*/) {}
};

TEST_F(DescribedExplorer, RecordsTheStepAndEveryActionByTheirNames) {
  const TracedStep step = step_of<Core<Nothing>>();
  EXPECT_EQ(step.member_names, (std::vector<std::string>{"gravity_px_per_s2", "wind_px_per_s", "x_px",
                                                         "v_px_per_s", "hits", "mood", "floor"}));
  EXPECT_EQ(step.function_names, (std::vector<std::string>{"step", "kick(up_px_per_s, hard)", "rest()"}));
  EXPECT_EQ(step.paths[0].size(), 4U);  // On the floor, and else by each mood.
  EXPECT_EQ(step.paths[1].size(), 6U);
  EXPECT_EQ(step.paths[2].size(), 3U);
}

TEST_F(DescribedExplorer, WritesATextThatIsReadAgain) {
  const TracedStep step = step_of<Core<Nothing>>();
  const std::string text = step_text(step);
  EXPECT_EQ(read_step(text), step);
  std::string damaged = text;
  damaged.replace(damaged.find("$x_px"), 5, "$y_px");
  EXPECT_FALSE(read_step(damaged));
}

struct OtherOrder : Nothing {
  static Real fall(const Real& gravity, const Real& dt) { return dt * gravity; }
};
struct OtherBounce : Nothing {
  static Real bounce() { return 0.625; }
};
struct OtherFall : Nothing {
  static Real fall(const Real& gravity, const Real& dt) { return gravity * dt * 1.5; }
};

TEST_F(DescribedExplorer, ProvesAnEqualRewriteAndNamesADifferenceWithItsValues) {
  const TracedStep accepted = step_of<Core<Nothing>>();
  EXPECT_EQ(step_of<Core<OtherOrder>>(), accepted);
  const auto changed = value_differences(accepted, step_of<Core<OtherBounce>>(), {{0.5, "BOUNCE"}});
  ASSERT_EQ(changed.size(), 1U);
  EXPECT_EQ(changed[0].function, "step");
  EXPECT_EQ(changed[0].values, std::vector<std::string>{"v_px_per_s"});
  EXPECT_EQ(changed[0].before, std::vector<std::string>{"(v_px_per_s + dt * gravity_px_per_s2) * BOUNCE"});
  EXPECT_EQ(changed[0].after, std::vector<std::string>{"(v_px_per_s + dt * gravity_px_per_s2) * 0.625"});
  const auto faster = value_differences(accepted, step_of<Core<OtherFall>>(), {});
  ASSERT_FALSE(faster.empty());
  EXPECT_EQ(faster.back().after, std::vector<std::string>{"dt * gravity_px_per_s2 * 1.5"});
  EXPECT_EQ(faster.back().values, (std::vector<std::string>{"x_px", "v_px_per_s"}));
}

struct HiddenTimer : Nothing {
  Whole frame = 0;
  void end(auto& core) {
    if (++frame > 300) core.x = 0;
  }
};
struct DeclaredTimer : HiddenTimer {
  void declare(auto&& see) { see("frame", frame); }
};
struct HiddenByAction : Nothing {
  Truth rests = false;
  void end(auto& core) {
    if (rests) core.x = 0;
  }
  void rest() { rests = true; }
};
struct HiddenBySetter : Nothing {
  Truth is_set = false;
  void end(auto& core) {
    if (is_set) core.x = 0;
    is_set = false;
  }
  void declare(auto&& see) {
    see(
        "extra", [&] { return extra; },
        [&](const Real& value) {
          extra = value;
          is_set = true;
        });
  }
  Real extra = 1.0;
};
struct NativeCounter : Nothing {
  unsigned frame = 0;
  void end(auto& /*core*/) { ++frame; }
};
struct SaysUndeclared : Nothing {
  void declare(auto&& see) { see.undeclared("generator"); }
};
struct PointsIntoItself : Nothing {
  Real extra = 1.0;
  Real* chosen = &extra;
};
struct HasAVector : Nothing {
  std::vector<Real> extra = {1.0};
  void declare(auto&& see) { see("extra", extra); }
};
struct Rounds : Nothing {
  Real extra = 1.0;
  void declare(auto&& see) {
    see(
        "extra", [&] { return extra; }, [&](const Real& value) { extra = trace::round(value); });
  }
};
struct ChangesAParameter : Nothing {
  void end(auto& core) { core.gravity += 1; }
};
struct LeavesItsLimits : Nothing {
  std::uint8_t count = 0;
  void end(auto& /*core*/) { ++count; }
  void declare(auto&& see) { see("count", count, {0, 5}); }
};
struct HasNoLimits : Nothing {
  std::uint8_t count = 0;
  void declare(auto&& see) { see("count", count); }
};
struct HasManyCases : HasNoLimits {
  void declare(auto&& see) { see("count", count, {0, 16}); }
};
struct IsWide : Nothing {
  std::array<Real, 27> cells = {};  // With the six others 33.
  void declare(auto&& see) { see("cells", cells); }
};

TEST_F(DescribedExplorer, SaysWhyAStepIsNotComplete) {
  constexpr auto kDecides = "a member that is not declared changes, and decides what the step does";
  constexpr auto kNoNumber =
      "count is no double, float, int or bool, and has no limits or names of at most 16 values";
  EXPECT_EQ(why_incomplete<Core<HiddenTimer>>(), kDecides);
  EXPECT_EQ(why_incomplete<Core<HiddenByAction>>(), kDecides);
  EXPECT_EQ(why_incomplete<Core<HiddenBySetter>>(), "extra: its setter does not set one member alone");
  EXPECT_EQ(why_incomplete<Core<NativeCounter>>(),
            "a member that is not declared changes, and is no recorded number");
  EXPECT_EQ(why_incomplete<Core<SaysUndeclared>>(), "generator is not declared");
  EXPECT_EQ(why_incomplete<Core<PointsIntoItself>>(),
            "memory outside the body: a pointer, or a member without a value");
  EXPECT_EQ(why_incomplete<Core<HasAVector>>(),
            "memory outside the body: struct hyrax_core is not trivially copyable");
  EXPECT_EQ(why_incomplete<Core<Rounds>>(), "extra: its setter does not set one member alone");
  EXPECT_EQ(why_incomplete<Core<ChangesAParameter>>(), "the parameter gravity_px_per_s2 changes");
  EXPECT_EQ(why_incomplete<Core<LeavesItsLimits>>(), "count leaves its limits");
  EXPECT_EQ(why_incomplete<Core<HasNoLimits>>(), kNoNumber);
  EXPECT_EQ(why_incomplete<Core<HasManyCases>>(), kNoNumber);
  EXPECT_EQ(why_incomplete<Core<IsWide>>(), "more than 32 values");
}

TEST_F(DescribedExplorer, CalculatesWithAnUnscopedEnumAsWithItsNumber) {
  EXPECT_EQ(step_text(step_of<Geared<Gear>>()), step_text(step_of<Geared<std::int32_t>>()));
  EXPECT_EQ(why_incomplete<Geared<Wide>>(), why_incomplete<Geared<std::uint32_t>>());
}

struct CastsToNext : Nothing {
  void end(auto& core) { core.mood = static_cast<Mood>((static_cast<Whole>(core.mood) + 1) % 3); }
};
struct ChoosesNext : Nothing {
  void end(auto& core) {
    core.mood = core.mood == Mood::calm ? Mood::wild : core.mood == Mood::wild ? Mood::tired : Mood::calm;
  }
};

TEST_F(DescribedExplorer, CastsAScopedEnumToItsNumberAndBack) {
  EXPECT_EQ(step_text(step_of<Core<CastsToNext>>()), step_text(step_of<Core<ChoosesNext>>()));
}

TEST_F(DescribedExplorer, TakesWhatIsDeclared) {
  EXPECT_EQ(step_of<Core<DeclaredTimer>>().paths[0].size(), 8U);
  EXPECT_NE(why_incomplete<Core<DeclaredTimer>>(), why_incomplete<Core<Nothing>>());
}

struct Rolls {
  Real x = 0.0;
  void step(const Real& dt) { x += dt; }
  void state(auto&& see) { see("x", x); }
};
struct ReadsAndChanges : Rolls {
  void outputs(auto&& see) { see("more", x += 1); }
};
struct TakesAKind : Rolls {
  void actions(auto&& see) {
    see("turn", [](Mood) {}, {"mood"});
  }
};

TEST_F(DescribedExplorer, RefusesListsThatChangeTheCoreAndArgumentsOfOtherTypes) {
  EXPECT_EQ(why_incomplete<ReadsAndChanges>(),
            "contacts, outputs or properties may change the core: they are not const");
  EXPECT_EQ(why_incomplete<TakesAKind>(), "mood: an argument that is no double, float, int or bool");
}

}  // namespace
}  // namespace hyrax
