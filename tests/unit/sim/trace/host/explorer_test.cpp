#include "sim/trace/host/explorer.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "sim/trace/host/limits.h"
#include "sim/trace/host/recorder.h"
#include "sim/trace/listing_step.h"
#include "sim/trace/step_text.h"
#include "sim/trace/traced_step.h"
#include "tests/unit/sim/trace/host/cores.h"

namespace hyrax {
namespace {

using namespace traced_cores;

class Explorer : public testing::Test {
 protected:
  Explorer() {
    trace::set_stop_handler([](const char* why) { throw std::runtime_error(why); });
  }
  ~Explorer() override { trace::set_stop_handler(nullptr); }

  template <class Core>
  static TracedStep step_of() {
    return canonical(trace::trace_core(trace::calls_of<Core, trace::Real, trace::Whole>()));
  }
  template <class Core>
  static std::string text_of() {
    return step_text(step_of<Core>());
  }
  template <class Core>
  static std::size_t paths_of() {
    return step_of<Core>().paths_of(CoreFunction::update).size();
  }
  template <class Core>
  static std::string why_incomplete() {
    try {
      return text_of<Core>();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }
};

TEST_F(Explorer, TellsWhatDiffersForNaNAndForNegativeZeroOnly) {
  EXPECT_NE(text_of<Plain>(), text_of<AddsZero>());
  EXPECT_EQ(paths_of<Plain>(), 1U);
  EXPECT_EQ(paths_of<MindsNaN>(), 2U);
}

TEST_F(Explorer, TakesMixedArgumentsOfTheStandardFunctions) {
  EXPECT_EQ(paths_of<traced_cores::Mixed>(), 24U);  // Two ways, three, two, two.
  EXPECT_NE(text_of<traced_cores::Mixed>().find("pow("), std::string::npos);
}

TEST_F(Explorer, KeepsTheArithmeticOfFloat) {
  const std::string text = text_of<Floats>();
  for (const char* const part : {"members: single single single single\n", ": single = to_single(dt)",
                                 ": real = to_real(x)"})  // Compared with a half, which is a double.
    EXPECT_NE(text.find(part), std::string::npos) << text;
  EXPECT_EQ(match_paper(step_of<Floats>()).difference, "x, y, vx and vy that are not double");
}

TEST_F(Explorer, KeepsTheArithmeticOfInt) {
  const std::string text = text_of<Integers>();
  for (const char* const part : {": whole = window_width / 2", ": whole = to_whole(x)", " % sprite_width"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST_F(Explorer, FoldsConstantsAsTheCompilerDoes) {
  const TracedStep step = step_of<Folds>();
  EXPECT_TRUE(step.comparisons.empty());
  EXPECT_NE(step_text(step).find("1.5{"), std::string::npos);
}

TEST_F(Explorer, FindsFurtherMembersInTheBody) {
  const TracedStep step = step_of<Counts>();
  EXPECT_EQ(step.members, (std::vector{NumberKind::real, NumberKind::real, NumberKind::real, NumberKind::real,
                                       NumberKind::whole, NumberKind::whole, NumberKind::real}));
  const std::string text = step_text(step);
  for (const char* const part : {"member_5 < 3", "member_6 == 0"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST_F(Explorer, GoesOnWhereACorePrints) { EXPECT_EQ(text_of<Prints>(), text_of<Plain>()); }

TEST_F(Explorer, SaysWhyAStepIsNotComplete) {
  EXPECT_EQ(why_incomplete<WhileTimeIsLeft>(), "more than 4,096 paths");
  EXPECT_EQ(why_incomplete<Remembers>(), "memory outside the body");
  EXPECT_EQ(why_incomplete<Chance>(), "memory outside the body");
  EXPECT_EQ(why_incomplete<OtherMember>(),
            "memory outside the body: a member that is not double, float, int or bool");
  EXPECT_EQ(why_incomplete<Grows>(), "memory outside the body: class physics is not trivially copyable");
  EXPECT_EQ(why_incomplete<NotAMember>(),
            "memory outside the body: x(), y(), vx() and vy() are not four members");
  EXPECT_EQ(why_incomplete<Indexes>(), "a number becomes an integer");
  EXPECT_EQ(why_incomplete<Large>(), "more than 32 members");
  EXPECT_EQ(why_incomplete<Divides>(), "over its limits: divides an integer by 0");
  EXPECT_EQ(why_incomplete<Calculates>(), "over its limits: more than 100,000 operations");
}

using namespace traced_cores;

// What a process that traces this core leaves as the reason.
template <class Core>
std::string why_incomplete() {
  const std::string file = testing::TempDir() + "why_incomplete." + std::to_string(getpid());
  const pid_t child = fork();
  if (child == 0) {
    trace::limit_process(file, 1);
    [&]() noexcept {  // No further than here, where GoogleTest would take it.
      static_cast<void>(trace::trace_core(trace::calls_of<Core, trace::Real, trace::Whole>()));
    }();
    _exit(1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  std::ifstream stream(file);
  std::string why(std::istreambuf_iterator<char>(stream), {});
  unlink(file.c_str());
  return why;
}

TEST(LimitProcess, SaysWhichLimitAHeaderMet) {
  EXPECT_EQ(why_incomplete<Loops>(), "over its limits: takes too long");
  EXPECT_EQ(why_incomplete<Recurses>(),
            "over its limits: recursion without end, or memory that is not its own");
  EXPECT_EQ(why_incomplete<Throws>(), "over its limits: throws an exception");
  EXPECT_EQ(why_incomplete<Exits>(), "over its limits: ends the program");
  EXPECT_EQ(why_incomplete<Indexes>(), "a number becomes an integer");
  if (trace::limits_memory()) {
    EXPECT_EQ(why_incomplete<Allocates>(), "over its limits: more than 1 GB of memory");
  }
}

}  // namespace
}  // namespace hyrax
