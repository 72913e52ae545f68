#include "sim/trace/host/limits.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "sim/trace/host/explorer.h"
#include "sim/trace/traced_step.h"
#include "tests/unit/sim/trace/host/cores.h"

namespace hyrax {
namespace {

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
  if (trace::kLimitsMemory) {
    EXPECT_EQ(why_incomplete<Allocates>(), "over its limits: more than 1 GB of memory");
  }
}

}  // namespace
}  // namespace hyrax
