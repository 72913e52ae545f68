// The program of a core that describes itself: its commands, and what it refuses.
#include <gtest/gtest.h>

#include <cfenv>
#include <filesystem>
#include <fstream>
#include <limits>

#include "tests/unit/sim/described/core_for_test.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/described/program.h"
#include "tools/files/text_file.h"
#include "tools/own_core/new_core.h.in"

namespace hyrax {
namespace {

struct Outcome {
  int exit_code = 0;
  std::string out = {};
  std::string err = {};
};

template <class Core>
DescribedCore core_of() {
  return described_core_of<Core>("toy", {});
}

// In a folder of its own.
class DescribedProgram : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::current_path(folder_.at("")); }
  void TearDown() override { std::filesystem::current_path(before_); }

  template <class Core = hyrax_core>
  static Outcome run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "toy-sim");
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Outcome outcome;
    outcome.exit_code = run_described_program(core_of<Core>, static_cast<int>(words.size()), words.data());
    outcome.out = testing::internal::GetCapturedStdout();
    outcome.err = testing::internal::GetCapturedStderr();
    return outcome;
  }

 private:
  const std::filesystem::path before_ = std::filesystem::current_path();
  const TempFolder folder_;
};

TEST_F(DescribedProgram, NewWritesAScenarioWithTheCoresValues) {
  EXPECT_EQ(run({"new", "first"}).exit_code, 0);
  EXPECT_EQ(read_text_file("first.json"), R"({
  "$schema": "scenario.schema.json",
  "format": "hyrax-scenario/1",
  "name": "first",
  "description": "What happens, and why it is worth testing.",
  "core": "toy",
  "inputs": { "width_px": 800, "height_px": 600 },
  "start": { "x_px": 100, "y_px": 100, "vx_px_per_s": 300, "vy_px_per_s": 0 },
  "clock": { "rate_hz": 60 },
  "steps": 600,
  "record": { "every": 1 },
  "expect": { "finite": true }
}
)");
  const Outcome validated = run({"validate", "first.json"});
  EXPECT_EQ(validated.out, "first.json: good, 600 steps\n");
  const Outcome again = run({"new", "first"});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_EQ(again.err, "first.json: exists; `--force` replaces it\n");
  EXPECT_EQ(run({"new", "first", "--force"}).exit_code, 0);
}

TEST_F(DescribedProgram, InfoPrintsEveryListAndWhatTheCheckFinds) {
  const std::string out = run({"info"}).out;
  EXPECT_EQ(out.substr(out.find("state: ")),
            R"(state: x_px (px), y_px (px), vx_px_per_s (px/s), vy_px_per_s (px/s)
inputs: width_px (px), height_px (px)
parameters: gravity_px_per_s2 (px/s^2)
outputs: none
actions: fling(vx_px_per_s, vy_px_per_s)
contacts: floor
properties: always "no ball on the floor is below it"
undeclared: none
positions: x_px with y_px
check of 600 frames at 60 Hz: complete, as far as they show
)");
  EXPECT_NE(run({"info", "--json"}).out.find(R"("parameters": [)"), std::string::npos);
}

struct Forgetful {  // Of what goes on it declares a part.
  double angle = 0.0, speed = 1.0;
  void step(double dt_s) { angle += speed * dt_s, speed *= 0.9; }
  template <class See>
  void state(See&& see) {
    see("angle_rad", angle);
  }
};
struct Explosive : OnePlace {
  Explosive() { x = 1.0; }
  void step(double /*dt_s*/) { x *= 1e300; }
};
struct Low {
  double y = 0.0;
  void step(double dt_s) { y += dt_s; }
  template <class See>
  void state(See&& see) {
    see("y_px", y, {0.0, 1.0});
  }
  template <class See>
  void properties(See&& see) const {
    see.always("y stays below 2 px", y < 2.0);
  }
};
struct Fussy : OnePlace {
  static void step(double dt_s) {
    if (dt_s > 0.02) throw std::runtime_error("a frame is too long");
  }
};

TEST_F(DescribedProgram, InfoSaysWhatIsWrong) {
  const std::string forgetful = run<Forgetful>({"info"}).out;
  EXPECT_NE(forgetful.find("inputs: none\n"), std::string::npos);
  EXPECT_NE(forgetful.find("positions: nothing in px"), std::string::npos);
  EXPECT_NE(forgetful.find("60 Hz: the state is not complete: set from row 1, angle_rad differs at row 2"),
            std::string::npos)
      << forgetful;
  EXPECT_NE(run<Explosive>({"info"}).out.find("60 Hz: ends at row 2: x_px is not finite"), std::string::npos);
}

TEST_F(DescribedProgram, FuzzFindsEachKindOfFault) {
  EXPECT_EQ(run({"fuzz", "--runs", "100"}).out.substr(0, 18), "seed 1\n100 runs in");
  const auto found = [](const Outcome& fuzzed) {
    EXPECT_EQ(fuzzed.exit_code, 1) << fuzzed.out;
    const std::size_t at = fuzzed.out.find("breaks a rule: ");
    return at == std::string::npos ? fuzzed.out : fuzzed.out.substr(at + 15, 40);
  };
  EXPECT_TRUE(found(run<Forgetful>({"fuzz", "--runs", "20"})).starts_with("complete: the state is not"));
  EXPECT_TRUE(found(run<Explosive>({"fuzz", "--runs", "20"})).starts_with("finite: x_px is not finite"));
  EXPECT_TRUE(found(run<Low>({"fuzz", "--runs", "20"})).starts_with("always: \"y stays below 2 px\""));
  EXPECT_TRUE(found(run<Fussy>({"fuzz", "--runs", "20"})).starts_with("throws: a frame is too long"));
  const Outcome allowed = run<Fussy>({"fuzz", "--runs", "20", "--without", "throws"});
  EXPECT_EQ(allowed.exit_code, 0) << allowed.out;
}

// Nothing has limits: few drawn starts are in its box.
struct Boxed {
  double x[6] = {10, 20, 30, 40, 50, 60}, width = 100.0, push = 0.0;
  bool is_open = false;
  void step(double dt_s) {
    if (!is_open) return;
    for (double& each : x) each += push * dt_s;
  }
  template <class See>
  void state(See&& see) {
    see("x_px", x);
    see("open", is_open);
  }
  template <class See>
  void parameters(See&& see) {
    see("push", push);
  }
  template <class See>
  void properties(See&& see) const {
    see.always("all are in the box",
               std::ranges::all_of(x, [this](double each) { return each >= 0.0 && each <= width; }));
  }
};
struct Shut : Boxed {
  void step(double /*dt_s*/) {}
};
struct Overfull : Shut {
  Overfull() { width = 50.0; }
};

TEST_F(DescribedProgram, FuzzDrawsStartsAgainThatAreNoneOfTheCores) {
  const Outcome good = run<Shut>({"fuzz", "--runs", "200"});
  EXPECT_EQ(good.exit_code, 0) << good.out;
  EXPECT_NE(good.out.find(" starts drawn again: \"all are in the box\" does not hold at row 0\n"),
            std::string::npos)
      << good.out;
  EXPECT_NE(run<Shut>({"fuzz", "--runs", "20", "--json"}).out.find("\"drawn_again\": ["), std::string::npos);
  // What is broken later is found, and what is written breaks it later, too.
  const Outcome later = run<Boxed>({"fuzz", "--runs", "200"});
  EXPECT_EQ(later.exit_code, 1) << later.out;
  const std::size_t at = later.out.find("written: ") + 9;
  const std::string path = later.out.substr(at, later.out.find('\n', at) - at);
  EXPECT_EQ(read_text_file(path).find("\"steps\": 0"), std::string::npos) << read_text_file(path);
  // Defaults that break it are a fault of the core.
  const Outcome broken = run<Overfull>({"fuzz", "--runs", "20"});
  EXPECT_EQ(broken.exit_code, 1) << broken.out;
  EXPECT_NE(broken.out.find("breaks a rule: always: \"all are in the box\" at step 0"), std::string::npos)
      << broken.out;
}

struct Rounding : OnePlace {
  void step(double dt_s) {
    x += dt_s;
    if (x > 0.1) std::fesetround(FE_UPWARD);
  }
};

TEST_F(DescribedProgram, ACoreThatChangesHowTheProcessorRoundsIsExitCode5) {
  const Outcome info = run<Rounding>({"info"});
  EXPECT_EQ(info.exit_code, 5);
  EXPECT_NE(info.out.find("60 Hz: ends at row 7: the core changes how the processor calculates (rounding or "
                          "flush-to-zero); remove what sets it from the core\n"),
            std::string::npos)
      << info.out;
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  write_text_file("sweep.json", R"({"format": "hyrax-sweep/1", "vary": {"/start/x_px": {"grid": [0, 1, 2]}},
      "base": {"format": "hyrax-scenario/1", "clock": {"rate_hz": 60}, "steps": 9}})");
  const Outcome swept = run<Rounding>({"sweep", "sweep.json"});
  EXPECT_EQ(swept.exit_code, 5);
  EXPECT_TRUE(
      swept.err.starts_with("sweep.json: 2 members ended early; member 0: row 7: the core changes how"))
      << swept.err;
}

TEST_F(DescribedProgram, WhatFuzzWritesIsGoodAndFailsAgain) {
  const Outcome found = run<Low>({"fuzz", "--runs", "20", "-o", "found"});
  const std::size_t at = found.out.find("written: ");
  ASSERT_NE(at, std::string::npos);
  const std::string path = found.out.substr(at + 9, found.out.find('\n', at) - at - 9);
  EXPECT_EQ(run<Low>({"validate", path}).exit_code, 0);
  // Runs of a part are those of the whole.
  const bool is_odd = (path.at(path.size() - 6) - '0') % 2 == 1;
  EXPECT_EQ(run<Low>({"fuzz", "--runs", "20", "--part", is_odd ? "1/2" : "0/2", "-o", "again"}).exit_code, 1);
  EXPECT_TRUE(std::filesystem::exists("again/" + path.substr(6)));
  EXPECT_NE(read_text_file(path).find("breaks always: \\\"y stays below 2 px\\\""), std::string::npos);
}

TEST_F(DescribedProgram, CommandsThatItHasNotSayWhatToUse) {
  EXPECT_EQ(run({"drift", "first.json"}).err,
            "toy-sim drift: needs the paper's step; toy describes itself: use study frame-rate, diff\n");
  for (const char* const command : {"drift", "study", "report"})
    EXPECT_EQ(run({command}).exit_code, 2) << command;
  EXPECT_EQ(
      run({"study", "needs"}).err,
      "toy-sim study needs: needs the paper's step; toy describes itself: use study frame-rate, diff\n");
  EXPECT_EQ(run({"study", "frame-rates"}).err,
            "toy-sim study: unknown study (found frame-rates); allowed: frame-rate, hard-cases (did you mean "
            "frame-rate?)\n");
}

TEST_F(DescribedProgram, TheStudyOfFrameRatesPlaysTheLibraryOrTheDefaults) {
  const Outcome defaults = run({"study", "frame-rate", "--quick", "--no-figures", "--gate"});
  EXPECT_EQ(defaults.exit_code, 0) << defaults.err;
  EXPECT_TRUE(defaults.out.starts_with("From the run at its own clock, 144 Hz is up to ")) << defaults.out;
  EXPECT_NE(defaults.out.find("\nFrom 2000 Hz, 60 Hz is up to "), std::string::npos) << defaults.out;
  EXPECT_NE(defaults.out.find("\n  defaults "), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists("frame-rate.h5"));
  std::filesystem::create_directory("scenarios");
  EXPECT_EQ(run({"new", "slow"}).exit_code, 0);
  std::filesystem::rename("slow.json", "scenarios/slow.json");
  const Outcome library = run({"study", "frame-rate", "--quick", "--no-figures", "--json"});
  EXPECT_NE(library.out.find("\"scenario\": \"slow\""), std::string::npos) << library.out;
  // A rule that holds at some rates only.
  const Outcome low = run<Low>({"study", "frame-rate", "--quick", "--no-figures", "--gate"});
  EXPECT_EQ(low.exit_code, 2);  // The scenario is not of this core.
  std::filesystem::remove_all("scenarios");
  const Outcome early = run<Explosive>({"study", "frame-rate", "--quick", "--no-figures"});
  EXPECT_TRUE(
      early.out.starts_with("From the run at its own clock, 144 Hz is an unknown distance away, 240 Hz an "))
      << early.out;
  EXPECT_NE(early.out.find("\ndefaults: whether it converges is not known, as a run ends early.\n"),
            std::string::npos)
      << early.out;
  const Outcome broken = run<Low>({"study", "frame-rate", "--quick", "--no-figures", "--gate"});
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_NE(broken.err.find("defaults at 24 Hz: property \"y stays below 2 px\""), std::string::npos)
      << broken.err;
}

TEST_F(DescribedProgram, TheStudyOfHardCasesSaysWhichCasesBreakWhichRule) {
  std::filesystem::create_directory("scenarios");  // Without any.
  const Outcome good = run({"study", "hard-cases", "--no-figures", "--gate"});
  EXPECT_EQ(good.exit_code, 0) << good.out << good.err;
  EXPECT_TRUE(good.out.starts_with("25 hard cases: none is broken.\n")) << good.out;
  const auto broken = [](const Outcome& outcome) {
    EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
    return outcome.err;
  };
  const std::string low = broken(run<Low>({"study", "hard-cases", "--quick", "--no-figures", "--gate"}));
  EXPECT_NE(low.find("defaults: always: \"y stays below 2 px\" at step 121"), std::string::npos) << low;
  EXPECT_NE(low.find("defaults/dt-10: always: "), std::string::npos) << low;
  EXPECT_NE(low.find("defaults/highest-y_px: always: \"y stays below 2 px\" at step 61"), std::string::npos);
  EXPECT_EQ(low.find("defaults/dt-1e-09"), std::string::npos) << low;
  const std::string fussy = broken(run<Fussy>({"study", "hard-cases", "--quick", "--no-figures", "--gate"}));
  EXPECT_NE(fussy.find("defaults/hitch-0.5-s: throws: a frame is too long at step 201"), std::string::npos)
      << fussy;
  EXPECT_NE(fussy.find("defaults/jitter-missed-0.5: throws: "), std::string::npos) << fussy;
  EXPECT_EQ(fussy.find("defaults: "), std::string::npos) << fussy;
}

// Wind has no highest value; each frame's wind is within its limits.
struct Windy : OnePlace {
  double wind = 1.0;
  void step(double dt) { x += wind * dt; }
  template <class See>
  void inputs(See&& see) {
    see("wind", wind, {-4.0, std::numeric_limits<double>::infinity()});
  }
  template <class See>
  void properties(See&& see) const {
    see.always("no wind from the right", wind >= 0.0);
  }
};

TEST_F(DescribedProgram, AHardCaseHasAValueAtALimitThatIsFinite) {
  write_text_file("windy.json",
                  R"({"format": "hyrax-scenario/1", "name": "windy", "clock": {"rate_hz": 60}, "steps": 3,
      "inputs": {"wind": [1, 2, 3]}})");
  const Outcome outcome =
      run<Windy>({"study", "hard-cases", "windy.json", "--quick", "--no-figures", "--gate"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            "toy-sim study hard-cases: windy/lowest-wind: always: \"no wind from the right\" at step 0\n");
}

TEST_F(DescribedProgram, ShrinkKeepsWhatARunSays) {
  const std::string start = R"({"format": "hyrax-scenario/1", "clock": {"rate_hz": 60}, "steps": 600,
      "start": {"x_px": 5, "vx_px_per_s": 7}, "parameters": {"gravity_px_per_s2": 900},
      "events": [{"step": 3, "fling": {"vx_px_per_s": 1, "vy_px_per_s": 2}}],
      "expect": {)";
  write_text_file("high.json", start + R"("final": {"x_px": [0, 10]}}})");
  const Outcome outcome = run({"shrink", "high.json", "-o", "small.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("kept: expect: final/x_px above\n"), std::string::npos) << outcome.out;
  const Outcome small = run({"run", "small.json", "-o", "small.h5"});
  EXPECT_EQ(small.exit_code, 1);
  EXPECT_NE(small.out.find("final/x_px: wanted 0 .. 10, measured "), std::string::npos) << small.out;
  const std::string text = read_text_file("small.json");
  for (const char* const left_out : {"events", "fling", "gravity"})
    EXPECT_EQ(text.find(left_out), std::string::npos) << text;
  write_text_file("good.json", start + R"("finite": true}})");
  const Outcome nothing = run({"shrink", "good.json", "-o", "none.json"});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_TRUE(nothing.err.starts_with("good.json: nothing to keep: the run ends, ")) << nothing.err;
}

struct Moody {
  double x = 0.0;
  int mood = 0;
  void step(double dt_s) { x += dt_s, mood = x > 0.5 ? 1 : 0; }
  template <class See>
  void state(See&& see) {
    see("x_px", x);
    see("mood", mood, {"calm", "wild"});
  }
  template <class See>
  void contacts(See&& see) const {
    see("far", x > 0.25);
  }
};

TEST_F(DescribedProgram, ReportShowsTheNumbersOfASweepsMembers) {
  write_text_file("moods.json", R"({"format": "hyrax-sweep/1", "vary": {"/start/x_px": {"grid": [0, 0.5, 4]}},
      "base": {"format": "hyrax-scenario/1", "clock": {"rate_hz": 60}, "steps": 9}})");
  EXPECT_EQ(run<Moody>({"sweep", "moods.json"}).exit_code, 0);
  const Outcome outcome = run<Moody>({"report", "moods.h5", "-o", "moods.html"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string page = read_text_file("moods.html");
  for (const char* const text :
       {"4 runs that differ in /start/x_px", "final x_px", "contacts far", ">calm<", ">wild<"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
  EXPECT_EQ(run<Moody>({"report", "moods.h5", "--against", "moods.h5", "-o", "a.html"}).err,
            "toy-sim report: --against: allowed for trajectories only (found moods.h5)\n");
  EXPECT_EQ(run<Low>({"report", "moods.h5", "-o", "a.html"}).exit_code, 2);
}

struct Uncapped : OnePlace {
  double cap = std::numeric_limits<double>::infinity();
  void step(double dt_s) { x = std::min(x + dt_s, cap); }
  template <class See>
  void inputs(See&& see) {
    see("cap_px", cap);
  }
};

TEST_F(DescribedProgram, AnInputWithoutABoundIsLeftOutOfANewScenario) {
  EXPECT_EQ(run<Uncapped>({"new", "first"}).err, "");
  EXPECT_EQ(read_text_file("first.json").find("cap_px"), std::string::npos);
}

struct Fatal {
  double x = 0.0;
  bool is_endless = false;
  void step(double dt_s) {
    x += dt_s;
    while (is_endless && x > 0.5) [[maybe_unused]] const volatile double unused = x;
    if (x > 0.5) std::abort();
  }
  template <class See>
  void state(See&& see) {
    see("x_m", x);
  }
  template <class See>
  void parameters(See&& see) {
    see("endless", is_endless);
  }
};

TEST_F(DescribedProgram, ShrinkKeepsHowARunEndsTheProgram) {
  const std::string start = R"({"format": "hyrax-scenario/1", "clock": {"rate_hz": 4}, "steps": 60,
      "events": [{"step": 30, "hitch": {"dt_s": 1}}], "parameters": {"endless": )";
  write_text_file("ends.json", start + "false}}");
  Outcome outcome = run<Fatal>({"shrink", "ends.json", "-o", "small.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("kept: signal 6 (SIGABRT)\n"), std::string::npos) << outcome.out;
  EXPECT_NE(read_text_file("small.json").find("\"steps\": 3\n"), std::string::npos);
  write_text_file("endless.json", start + "true}}");
  outcome = run<Fatal>({"shrink", "endless.json", "-o", "endless-small.json", "--run-limit", "0.1s"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("kept: no end within 0.1 s\n"), std::string::npos) << outcome.out;
  EXPECT_NE(read_text_file("endless-small.json").find("\"endless\": true"), std::string::npos);
}

TEST_F(DescribedProgram, ShrinkLeavesOutHoldsInputsByTheFrameAndJitter) {
  std::string widths = "800";
  for (int frame = 1; frame < 90; ++frame) widths += ", 800";
  write_text_file("high.json", R"({"format": "hyrax-scenario/1", "clock": {"rate_hz": 60,
      "jitter": {"kind": "uniform", "fraction": 0.1, "seed": 1}}, "steps": 90,
      "inputs": {"width_px": [)" + widths +
                                   R"(]},
      "events": [{"step": 3, "hold": {}}, {"step": 13, "go": {}}, {"step": 20, "hold": {}}],
      "expect": {"final": {"x_px": [0, 101]}}})");
  EXPECT_EQ(run({"shrink", "high.json", "-o", "small.json"}).exit_code, 0);
  const std::string text = read_text_file("small.json");
  EXPECT_NE(text.find("\"steps\": 1,\n"), std::string::npos) << text;
  for (const char* const left_out : {"events", "hold", "inputs", "jitter"})
    EXPECT_EQ(text.find(left_out), std::string::npos) << text;
}

TEST_F(DescribedProgram, TwoFilesOfWhichOneGoesOnLongerContradictNothing) {
  for (const char* const steps : {"20", "30"}) {
    write_text_file(
        "a.json",
        std::string(R"({"format": "hyrax-scenario/1", "clock": {"rate_hz": 60}, "steps": )") + steps + "}");
    EXPECT_EQ(run({"run", "a.json", "-o", std::string(steps) + ".h5"}).exit_code, 0);
  }
  const Outcome outcome = run({"diff", "20.h5", "30.h5"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("the scenarios differ: /steps 20 -> 30\n"), std::string::npos) << outcome.out;
}

TEST_F(DescribedProgram, AScenarioWhoseInputsChangeByTheFrameHasOneRate) {
  write_text_file("pushed.json", R"({"format": "hyrax-scenario/1", "clock": {"rate_hz": 60}, "steps": 3,
                                     "inputs": {"width_px": [800, 700, 600]}})");
  const Outcome outcome = run({"study", "frame-rate", "pushed.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err,
            "toy-sim study frame-rate: pushed: left out, as an input has a value for each frame.\n");
}

struct Misnamed {
  double x = 0.0, y = 0.0;
  void step(double /*dt_s*/) {}
  template <class See>
  void state(See&& see) {
    see("X", x);
    see("dt", y);
  }
};
struct Unmade : OnePlace {
  Unmade() { throw std::runtime_error("no table"); }
  void step(double /*dt_s*/) {}
};

TEST_F(DescribedProgram, ACoreThatCannotBeUsedRunsNoCommand) {
  const Outcome misnamed = run<Misnamed>({"validate", "first.json"});
  EXPECT_EQ(misnamed.exit_code, 2);
  EXPECT_EQ(misnamed.err,
            "toy-sim: the core toy: state 'X': a name is parts [a-z][a-z0-9_]* joined by dots\n"
            "toy-sim: the core toy: state 'dt': the name is reserved\n");
  EXPECT_EQ(run<Misnamed>({"info"}).exit_code, 2);
  EXPECT_EQ(run<Misnamed>({"--help"}).exit_code, 0);
  EXPECT_EQ(run<Misnamed>({"--version"}).exit_code, 0);
  const Outcome unmade = run<Unmade>({"info"});
  EXPECT_EQ(unmade.exit_code, 2);
  EXPECT_EQ(unmade.err, "toy-sim: the core throws while it is made: no table\n");
}

}  // namespace
}  // namespace hyrax
