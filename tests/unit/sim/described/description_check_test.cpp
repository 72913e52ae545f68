// The check of the description: it finds each fault, and finds none in the same core without it.
#include <gtest/gtest.h>
#include <cmath>

#include "tests/unit/sim/described/core_for_test.h"

namespace hyrax {
namespace {

template <class Core>
std::string fault(const DescribedScenario& scenario = scenario_for_test(600)) {
  return description_fault(core_for_test<Core>(), scenario).value_or("");
}

// A timer fires after 300 rows.
template <bool kIsDeclared>
struct Timer {
  double x = 0.0;
  int timer = 0;
  void step(double dt_s) {
    if (++timer > 300) x += 100.0 * dt_s;
  }
  void state(auto&& see) {
    see("x_px", x);
    if (kIsDeclared) see("timer", timer);
  }
};
TEST(DescriptionCheck, FindsAMemberThatIsNotDeclared) {
  EXPECT_EQ(fault<Timer<true>>(), "");
  EXPECT_EQ(
      fault<Timer<false>>(),
      "the state is not complete: set from row 256, x_px differs at row 301; a member that changes is not "
      "declared");
  EXPECT_EQ(fault<Timer<false>>(scenario_for_test(300)), "");
}

// Forgotten, and of weight in rows 20 and 21 only: at none at which a fresh core is set.
template <bool kIsDeclared>
struct Pulse {
  double x = 0.0;
  int row = 0;
  double pulse = 0.0;
  void step(double /*dt_s*/) {
    x += pulse;
    pulse = ++row == 20 ? 1.0 : 0.0;
  }
  void state(auto&& see) {
    see("x_px", x);
    see("row", row);
    if (kIsDeclared) see("pulse", pulse);
  }
};
TEST(DescriptionCheck, ARunThatIsStoppedAndResumedGoesOnAsWithoutAStop) {
  EXPECT_EQ(fault<Pulse<false>>(scenario_for_test(60)), "");
  EXPECT_EQ(resumed_fault(core_for_test<Pulse<false>>(), scenario_for_test(60), 60),
            "stopped at row 20 and resumed, x_px differs at row 21");
  EXPECT_EQ(resumed_fault(core_for_test<Pulse<true>>(), scenario_for_test(60), 60), std::nullopt);
  EXPECT_EQ(resumed_fault(core_for_test<Pulse<false>>(), scenario_for_test(63), 63), std::nullopt);
  // A run that ended at row 20 is not held to what would follow.
  EXPECT_EQ(resumed_fault(core_for_test<Pulse<false>>(), scenario_for_test(60), 20), std::nullopt);
  DescribedScenario scenario = scenario_for_test(300);
  EXPECT_EQ(resumed_fault(core_for_test<Pulse<false>>(), scenario, 300), std::nullopt);
  scenario.events = {event_for_test(20, Hitch{0.5})};
  EXPECT_EQ(resumed_fault(core_for_test<Pulse<false>>(), scenario, 300),
            "stopped at row 20 and resumed, x_px differs at row 21");
}

// It follows an action, and is forgotten.
template <bool kIsDeclared>
struct Boost {
  double x = 0.0;
  double boost = 0.0;
  void step(double dt_s) { x += boost * dt_s; }
  void state(auto&& see) {
    see("x_px", x);
    if (kIsDeclared) see("boost", boost);
  }
  void actions(auto&& see) {
    see("boost", [&] { boost += 1.0; });
  }
};
TEST(DescriptionCheck, FindsAMemberThatAnActionChanges) {
  DescribedScenario scenario = scenario_for_test(20);
  for (const std::int64_t frame : {9, 10}) scenario.events.push_back(event_for_test(frame, Act{0, {}}));
  EXPECT_EQ(fault<Boost<true>>(scenario), "");
  EXPECT_EQ(
      fault<Boost<false>>(scenario),
      "the state is not complete: set from row 10, x_px differs at row 11; a member that changes is not "
      "declared");
}

template <bool kIsStatic>
struct Counting {
  double x = 0.0;
  int own = 0;
  void step(double dt_s) {
    static int shared = 0;
    x += (kIsStatic ? ++shared : ++own) % 7 * dt_s;
  }
  void state(auto&& see) {
    see("x_px", x);
    see("own", own);
  }
};
TEST(DescriptionCheck, FindsStaticState) {
  EXPECT_EQ(fault<Counting<false>>(), "");
  EXPECT_EQ(fault<Counting<true>>(),
            "a second run is not the same: x_px differs at row 1; has the core static state?");
  EXPECT_EQ(resumed_fault(core_for_test<Counting<true>>(), scenario_for_test(60), 60), std::nullopt);
}

// Only the first run of a program is another.
struct FirstRun : OnePlace {
  void step(double dt_s) {
    static int calls = 0;
    x += ++calls <= 100 ? dt_s : 2.0 * dt_s;
  }
};
TEST(DescriptionCheck, FindsStaticStateThatOnlyTheFirstRunShows) {
  const DescribedCore core = core_for_test<FirstRun>();
  const DescribedScenario scenario = scenario_for_test(100);
  const DescribedSummary first = play(core, scenario, {});
  EXPECT_EQ(description_fault(core, scenario, kCheckedRowsMax, &first),
            "a second run is not the same: its state hash differs; has the core static state?");
  const DescribedSummary second = play(core, scenario, {});
  EXPECT_EQ(description_fault(core, scenario, kCheckedRowsMax, &second), std::nullopt);
}

// Not finite in row 5; a parameter changes behind it.
struct EndsEarly {
  double x = 1.0;
  double gravity = 1.0;
  int row = 0;
  void step(double /*dt_s*/) {
    if (++row == 5) x /= 0.0;
    if (row == 8) gravity += 1.0;
  }
  void state(auto&& see) {
    see("x_px", x);
    see("row", row);
  }
  void parameters(auto&& see) { see("gravity", gravity); }
};
TEST(DescriptionCheck, LooksAtNothingBehindTheEndOfTheRun) {
  const DescribedCore core = core_for_test<EndsEarly>();
  const DescribedSummary run = play(core, scenario_for_test(60), {});
  ASSERT_TRUE(run.early_end);
  EXPECT_EQ(description_fault(core, scenario_for_test(60), kCheckedRowsMax, &run), std::nullopt);
}

template <bool kIsPointer>
struct SelfPointer {
  std::vector<double> xs{0.0, 0.0};
  double* chosen = xs.data();
  void step(double dt_s) { (kIsPointer ? chosen : xs.data())[0] += 100.0 * dt_s; }
  void state(auto&& see) { see("x_px", xs); }
};
TEST(DescriptionCheck, FindsAMemberThatPointsIntoTheCore) {
  EXPECT_EQ(fault<SelfPointer<false>>(), "");
  EXPECT_EQ(
      fault<SelfPointer<true>>(),
      "a copy does not go on as its original: copied at row 0, x_px.0 differs at row 1; does a member point "
      "into the core?");
}

template <bool kRounds>
struct Rounding {
  double spin = 0.0;
  void step(double dt_s) { spin += dt_s; }
  void state(auto&& see) {
    see(
        "spin", [&] { return spin; }, [&](double given) { spin = kRounds ? std::round(given) : given; });
  }
};
TEST(DescriptionCheck, NamesASetterThatDoesNotGiveBackWhatItsGetterGave) {
  EXPECT_EQ(fault<Rounding<false>>(), "");
  EXPECT_EQ(fault<Rounding<true>>(), "the setter of spin does not give back what its getter gave at row 1");
  DescribedScenario scenario = scenario_for_test(3);
  scenario.start = {{0, word_of(0.5)}};
  EXPECT_EQ(fault<Rounding<true>>(scenario),
            "the core does not hold the value of spin that is set before row 0: its getter gives another");
  scenario.start.clear();
  scenario.events = {event_for_test(2, SetValues{{}, {{0, word_of(0.5)}}})};
  EXPECT_EQ(fault<Rounding<true>>(scenario),
            "the core does not hold the value of spin that is set in frame 2: its getter gives another");
}

// The setter of turns sets the member of another list or place, too.
template <bool kIsInput>
struct Meddling {
  double x = 1.0, turns = 0.0, push = 1.0;
  void step(double dt_s) { x += push * dt_s, turns += dt_s; }
  void state(auto&& see) {
    see("x_px", x);
    see(
        "turns", [&] { return turns; },
        [&](double given) {
          turns = given;
          (kIsInput ? push : x) += 1.0;
        });
  }
  void inputs(auto&& see) { see("push", push); }
};
TEST(DescriptionCheck, NamesTheSetterThatChangesAnotherValue) {
  EXPECT_EQ(fault<Meddling<false>>(), "the setter of turns changes x_px, which is set before it, at row 0");
  EXPECT_EQ(fault<Meddling<true>>(), "the setter of turns changes push, which is set before it, at row 0");
}

struct Swapping {
  double x = 1.0, y = 2.0;
  bool is_turned = false;
  void step(double /*dt_s*/) { is_turned = !is_turned; }
  void state(auto&& see) {
    see(is_turned ? "y" : "x", is_turned ? y : x);
    see(is_turned ? "x" : "y", is_turned ? x : y);
    see("turned", is_turned);
  }
};
TEST(DescriptionCheck, FindsAListWhoseNamesChange) {
  EXPECT_EQ(fault<Swapping>(),
            "the lists are not the same in every call: value y has another place in its list, at row 1");
}

template <bool kChanges>
struct Drifting : OnePlace {
  double gravity = 1.0;
  void step(double dt_s) {
    x += gravity * dt_s;
    if (kChanges && x > 0.05) gravity += 1.0;
  }
  void parameters(auto&& see) { see("gravity", gravity); }
};
TEST(DescriptionCheck, FindsAParameterThatChanges) {
  EXPECT_EQ(fault<Drifting<false>>(), "");
  EXPECT_EQ(fault<Drifting<true>>(),
            "the parameter gravity changes at row 4; what changes in a run is state");
}

// A contact is in the row's bits.
struct HiddenContact : OnePlace {
  int frame = 0;
  void step(double /*dt_s*/) { ++frame; }
  void contacts(auto&& see) const { see("late", frame > 10); }
};
TEST(DescriptionCheck, ComparesContacts) {
  EXPECT_EQ(fault<HiddenContact>(),
            "the state is not complete: set from row 8, the contact late differs at row 11; a member that "
            "changes is "
            "not declared");
}

// What cannot be declared is left to copies.
struct Undeclared {
  double x = 0.0;
  unsigned seed = 1;
  void step(double /*dt_s*/) { x += (seed = seed * 1664525U + 1013904223U) % 3U; }
  void state(auto&& see) {
    see("x_px", x);
    see.undeclared("seed");
  }
};
TEST(DescriptionCheck, LeavesOutWhatIsSaidToBeUndeclared) { EXPECT_EQ(fault<Undeclared>(), ""); }

// An input that the step takes back, one press, is given to a fresh core as the run holds it.
struct OneShot {
  double y = 0.0;
  bool jump = false;
  void step(double /*dt_s*/) {
    if (jump) y += 10.0;
    jump = false;
  }
  void state(auto&& see) { see("y_px", y); }
  void inputs(auto&& see) { see("jump", jump); }
};
TEST(DescriptionCheck, HoldsWithInputsThatTheCoreChangesAndWhileHeld) {
  DescribedScenario scenario = scenario_for_test(50);
  scenario.events = {event_for_test(3, SetValues{{{0, 1}}, {}}), event_for_test(7, Hold{}),
                     event_for_test(9, SetValues{{{0, 1}}, {}}), event_for_test(12, Go{})};
  EXPECT_EQ(fault<OneShot>(scenario), "");
  RowsForTest rows;
  const DescribedSummary summary = play_for_test(core_for_test<OneShot>(), scenario, rows);
  EXPECT_EQ(summary.final, std::vector<Word>{word_of(20.0)});
}

}  // namespace
}  // namespace hyrax
