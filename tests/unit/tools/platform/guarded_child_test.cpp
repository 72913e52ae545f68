// Work in a child process: its result, or how it ended.
#include "tools/platform/guarded_child.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include <unistd.h>

#include "tests/unit/tools/files/refusal.h"

namespace hyrax {
namespace {

// "result R", "signal N", "late", "exit".
std::string end_of(const std::function<std::string()>& work, const ChildLimits& limits = {}) {
  const WorkEnd end = in_child("here", limits, work);
  if (end.result) return "result " + *end.result;
  if (end.is_timed_out()) return "late";
  return end.signal == 0 ? "exit" : "signal " + std::to_string(end.signal);
}

TEST(GuardedChild, GivesItsResultHoweverLongOrEmpty) {
  int here = 1;
  EXPECT_EQ(end_of([&] { return std::to_string(++here); }), "result 2");
  EXPECT_EQ(here, 1);
  EXPECT_EQ(end_of([] { return std::string(); }), "result ");
  const std::string more_than_a_pipe_holds(300'000, 'a');
  EXPECT_EQ(end_of([&] { return more_than_a_pipe_holds; }), "result " + more_than_a_pipe_holds);
}

TEST(GuardedChild, TellsACrashAnExitAndAnExceptionApart) {
  EXPECT_EQ(end_of([]() -> std::string { std::raise(SIGSEGV), std::abort(); }), "signal 11");
  EXPECT_EQ(end_of([]() -> std::string { std::_Exit(0); }), "exit");
  EXPECT_EQ(end_of([]() -> std::string { throw std::logic_error("not caught"); }), "signal 6");
}

TEST(GuardedChild, IsEndedByItsLimits) {
  const auto wait = []() -> std::string {
    while (true) pause();
  };
  const auto work = []() -> std::string {
    while (true) static_cast<void>(getppid());
  };
  EXPECT_EQ(end_of(wait, {.wall_s = 0.01}), "late");
  EXPECT_EQ(end_of(work, {.wall_s = 2e-7}), "late") << "too short for the timer is not none";
  EXPECT_EQ(end_of(work, {.processor_s = 1}), "late");
}

// What a new process of this program does for the test below: disabled, as they are no tests by themselves
// and end their process.
TEST(GuardedChild, DISABLED_Prints) { std::printf("printed by %s", std::getenv("HYRAX_NEW_PROCESS")); }
TEST(GuardedChild, DISABLED_Exits) { std::_Exit(3); }
TEST(GuardedChild, DISABLED_Crashes) { std::raise(SIGKILL); }

TEST(GuardedChild, StartsThisProgramAgain) {
  setenv("HYRAX_NEW_PROCESS", "a new process", 1);
  const auto end_of_test = [](const std::string& name) {
    return in_new_process("here",
                          {"again", "--gtest_also_run_disabled_tests", "--gtest_filter=*DISABLED_" + name});
  };
  EXPECT_NE(end_of_test("Prints").result.value_or("").find("printed by a new process"), std::string::npos);
  EXPECT_FALSE(end_of_test("Exits").result);
  EXPECT_EQ(end_of_test("Exits").signal, 0);
  EXPECT_EQ(end_of_test("Crashes").signal, SIGKILL);
}

TEST(GuardedChild, MayBeginItsTimeAgain) {
  const auto twice = [] {
    for (int part = 0; part < 8; ++part) {
      limit_wall_time(0.4);
      usleep(100'000);
    }
    return std::string("done");
  };
  EXPECT_EQ(end_of(twice, {.wall_s = 0.4}), "result done");
}

}  // namespace
}  // namespace hyrax
