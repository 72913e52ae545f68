// The program of a core that describes itself: its commands, and what it refuses.
#include <gtest/gtest.h>

#include <cfenv>
#include <filesystem>
#include <iterator>
#include <limits>
#include <sstream>

#include "tests/unit/sim/described/core_for_test.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/described/broken_rule.h"
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

  template <class Core = hyrax_core>
  void say(const std::string& command) {
    std::istringstream words(command);
    const Outcome outcome = run<Core>({std::istream_iterator<std::string>(words), {}});
    // Above the lists of `info` is what the machine is.
    const std::size_t lists = command == "info" ? outcome.out.find("state: ") : 0;
    said_ += "$ toy-sim " + command + "\n" + outcome.out.substr(std::min(lists, outcome.out.size())) +
             outcome.err + "exit code " + std::to_string(outcome.exit_code) + "\n";
  }

  std::string said_ = {};

 private:
  const std::filesystem::path before_ = std::filesystem::current_path();
  const TempFolder folder_;
};

struct Forgetful {  // Of what goes on it declares a part.
  double angle = 0.0, speed = 1.0;
  void step(double dt_s) { angle += speed * dt_s, speed *= 0.9; }
  void state(auto&& see) { see("angle_rad", angle); }
};
struct Explosive : OnePlace {
  Explosive() { x = 1.0; }
  void step(double /*dt_s*/) { x *= 1e300; }
};
struct Low {
  double y = 0.0;
  void step(double dt_s) { y += dt_s; }
  void state(auto&& see) { see("y_px", y, {0.0, 1.0}); }
  void properties(auto&& see) const { see.always("y stays below 2 px", y < 2.0); }
};
struct Fussy : OnePlace {
  static void step(double dt_s) {
    if (dt_s > 0.02) throw std::runtime_error("a frame is too long");
  }
};

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
  void state(auto&& see) {
    see("x_px", x);
    see("open", is_open);
  }
  void parameters(auto&& see) { see("push", push); }
  void properties(auto&& see) const {
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
  const Outcome good = run<Shut>({"fuzz", "--runs", "50"});
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
  EXPECT_EQ(run<Rounding>({"info"}).exit_code, 5);
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
  void state(auto&& see) {
    see("x_px", x);
    see("mood", mood, {"calm", "wild"});
  }
  void contacts(auto&& see) const { see("far", x > 0.25); }
};

TEST_F(DescribedProgram, ReportShowsTheNumbersOfASweepsMembers) {
  write_text_file("moods.json", R"({"format": "hyrax-sweep/1", "vary": {"/start/x_px": {"grid": [0, 0.5, 4]}},
      "base": {"format": "hyrax-scenario/1", "clock": {"rate_hz": 60}, "steps": 9}})");
  EXPECT_EQ(run<Moody>({"sweep", "moods.json"}).exit_code, 0);
  const Outcome outcome = run<Moody>({"report", "moods.h5", "-o", "moods.html"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string page = read_text_file("moods.html");
  for (const char* const text :
       {"4 runs, varied in /start/x_px", "final x_px", "contacts far", ">calm<", ">wild<"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
  EXPECT_EQ(run<Moody>({"report", "moods.h5", "--against", "moods.h5", "-o", "a.html"}).err,
            "toy-sim report: --against: allowed for trajectories only (found moods.h5)\n");
  EXPECT_EQ(run<Low>({"report", "moods.h5", "-o", "a.html"}).exit_code, 2);
}

struct Uncapped : OnePlace {
  double cap = std::numeric_limits<double>::infinity();
  void step(double dt_s) { x = std::min(x + dt_s, cap); }
  void inputs(auto&& see) { see("cap_px", cap); }
};

struct Fatal {
  double x = 0.0;
  bool is_endless = false;
  void step(double dt_s) {
    x += dt_s;
    while (is_endless && x > 0.5) [[maybe_unused]] const volatile double unused = x;
    if (x > 0.5) std::abort();
  }
  void state(auto&& see) { see("x_m", x); }
  void parameters(auto&& see) { see("endless", is_endless); }
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

// The state that is not finite ends the run before what it forgets has a weight.
struct EndsFirst {
  double x = 0.0, y = 0.0, forgotten = 0.0;
  int row = 0;
  void step(double /*dt_s*/) {
    y += forgotten;
    forgotten = ++row == 20 ? 1.0 : 0.0;
    if (row == 10) x = std::numeric_limits<double>::infinity();
  }
  template <class See>
  void state(See&& see) {
    see("x_px", x);
    see("y_px", y);
    see("row", row);
  }
};

TEST_F(DescribedProgram, ARunThatEndedIsNotHeldToWhatWouldFollow) {
  const auto rules =
      broken_rules(core_of<EndsFirst>(), scenario_for_test(60), [](std::string_view) { return true; });
  ASSERT_EQ(rules.size(), 1U);
  EXPECT_EQ(rules.front().rule, "finite");
}

// What it throws tells a number.
struct Loud {
  double x = 0.0;
  int row = 0;
  void step(double dt_s) {
    x += dt_s;
    if (++row == 3) throw std::runtime_error("too long, at " + std::to_string(x));
  }
  template <class See>
  void state(See&& see) {
    see("x_px", x);
    see("row", row);
  }
};

TEST_F(DescribedProgram, ShrinkLeavesOutWhatOnlyChangesANumberOfATextThatIsThrown) {
  write_text_file("loud.json", R"({"format": "hyrax-scenario/1", "clock": {"rate_hz": 4}, "steps": 9,
      "start": {"x_px": 0.3}, "events": [{"step": 0, "hitch": {"dt_s": 1}}]})");
  const Outcome outcome = run<Loud>({"shrink", "loud.json", "-o", "small.json"});
  EXPECT_NE(outcome.out.find("kept: too long, at 0.750000\n"), std::string::npos) << outcome.out;
  const std::string text = read_text_file("small.json");
  for (const char* const left_out : {"start", "hitch"})
    EXPECT_EQ(text.find(left_out), std::string::npos) << text;
}

TEST_F(DescribedProgram, ShrinkOfAFaultAtRow0LeavesNoFrame) {
  for (const std::string inputs : {"", R"(, "inputs": {"width_px": [800, 800, 800, 800]})"}) {
    write_text_file("high.json", R"({"format": "hyrax-scenario/1", "clock": {"rate_hz": 60}, "steps": 4)" +
                                     inputs + R"(, "expect": {"final": {"vx_px_per_s": [0, 1]}}})");
    EXPECT_EQ(run({"shrink", "high.json", "-o", "small.json", "--force"}).exit_code, 0);
    const std::string text = read_text_file("small.json");
    EXPECT_NE(text.find("\"steps\": 0,\n"), std::string::npos) << text;
  }
}

// Wind has no highest value; each frame's wind is within its limits.
struct Windy : OnePlace {
  double wind = 1.0;
  void step(double dt) { x += wind * dt; }
  void inputs(auto&& see) { see("wind", wind, {-4.0, std::numeric_limits<double>::infinity()}); }
  void properties(auto&& see) const { see.always("no wind from the right", wind >= 0.0); }
};

struct Misnamed {
  double x = 0.0, y = 0.0;
  void step(double /*dt_s*/) {}
  void state(auto&& see) {
    see("X", x);
    see("dt", y);
  }
};
struct Unmade : OnePlace {
  Unmade() { throw std::runtime_error("no table"); }
  void step(double /*dt_s*/) {}
};

// Each command as it is typed, all that it prints, and its exit code.
TEST_F(DescribedProgram, SaysWhatIsApproved) {
  say("new first");
  said_ += read_text_file("first.json");
  for (const char* const command : {"validate first.json", "new first", "new first --force", "info"})
    say(command);
  said_ += "A core that forgets its speed, one that explodes, and one that changes the rounding\n";
  say<Forgetful>("info");
  say<Explosive>("info");
  say<Rounding>("info");
  said_ += "An input without a bound is left out of a new scenario\n";
  say<Uncapped>("new uncapped");
  said_ += read_text_file("uncapped.json");
  said_ += "Commands of the paper's step alone\n";
  for (const char* const command :
       {"drift first.json", "study", "report", "study needs", "study frame-rates"})
    say(command);
  said_ += "A file that goes on longer\n";
  for (const std::string& steps : {std::string("20"), std::string("30")}) {
    write_text_file("a.json",
                    R"({"format": "hyrax-scenario/1", "clock": {"rate_hz": 60}, "steps": )" + steps + "}");
    say("run a.json -o " + steps + ".h5");
  }
  say("diff 20.h5 30.h5");
  said_ += "A scenario whose inputs change by the frame\n";
  write_text_file("pushed.json", R"({"format": "hyrax-scenario/1", "clock": {"rate_hz": 60}, "steps": 3,
                                     "inputs": {"width_px": [800, 700, 600]}})");
  say("study frame-rate pushed.json");
  said_ += "Cores of which hard cases break a rule\n";
  write_text_file("windy.json",
                  R"({"format": "hyrax-scenario/1", "name": "windy", "clock": {"rate_hz": 60}, "steps": 3,
      "inputs": {"wind": [1, 2, 3]}})");
  say<Windy>("study hard-cases windy.json --quick --no-figures --gate");
  std::filesystem::create_directory("scenarios");  // Without any.
  say("study hard-cases --no-figures --gate");
  say<Low>("study hard-cases --quick --no-figures --gate");
  say<Fussy>("study hard-cases --quick --no-figures --gate");
  said_ += "Cores that cannot be used\n";
  for (const char* const command : {"validate first.json", "info"}) say<Misnamed>(command);
  say<Unmade>("info");
  expect_approved("tests/unit/tools/described/described_program.txt", said_);
  for (const char* const command : {"--help", "--version"})
    EXPECT_EQ(run<Misnamed>({command}).exit_code, 0) << command;
  EXPECT_NE(run({"info", "--json"}).out.find(R"("parameters": [)"), std::string::npos);
}

}  // namespace
}  // namespace hyrax
