// A child process takes the harm.
#include "tools/store/trial_reading.h"

#include <gtest/gtest.h>

#include <csignal>
#include <vector>

#include "tests/unit/tools/store/stored_flings.h"

namespace hyrax {
namespace {

class TrialReading : public testing::Test {
 protected:
  void SetUp() override { write_bytes(path_, "a file"); }

  // The sentence, without the path.
  std::string told_of(const std::function<void()>& read) const {
    const std::string told = refusal([&] { read_on_trial(path_, read); });
    return told.empty() ? told : told.substr(path_.size());
  }

  const TempFolder folder_;
  const std::string path_ = folder_.at("run.h5");
};

TEST_F(TrialReading, OfAWholeFileSaysNothing) {
  EXPECT_EQ(told_of([] {}), "");
}

TEST_F(TrialReading, LeavesARefusalToTheReadingThatFollows) {
  EXPECT_EQ(told_of([] { throw Failure(ExitCode::bad_input, "refused"); }), "");
}

TEST_F(TrialReading, ChangesNothingHere) {
  int value = 1;
  EXPECT_EQ(told_of([&] { value = 2; }), "");
  EXPECT_EQ(value, 1);
}

TEST_F(TrialReading, TellsOfACrash) {
  EXPECT_EQ(told_of([] { std::raise(SIGSEGV); }),
            ": is damaged: the HDF5 library crashes on it; write or copy it anew");
}

TEST_F(TrialReading, TellsOfAReadingThatDoesNotEnd) {
  EXPECT_EQ(told_of([] {
              for (volatile int turn = 0;;) turn = turn ^ 1;
            }),
            ": is damaged: reading it does not come to an end; write or copy it anew");
}

// A parent may ignore or block the signals by which the limits end the child.
TEST_F(TrialReading, IsUnderLimitsWhateverThisProcessInherited) {
  sigset_t blocked;
  sigset_t before;
  sigemptyset(&blocked);
  for (const int number : {SIGALRM, SIGXCPU}) {
    sigaddset(&blocked, number);
    std::signal(number, SIG_IGN);
  }
  sigprocmask(SIG_BLOCK, &blocked, &before);
  EXPECT_EQ(told_of([] {
              sigset_t in_child;
              sigprocmask(SIG_BLOCK, nullptr, &in_child);
              for (const int number : {SIGALRM, SIGXCPU}) {
                struct sigaction action {};
                sigaction(number, nullptr, &action);
                if (sigismember(&in_child, number) != 0 || action.sa_handler != SIG_DFL)
                  throw std::logic_error("a limit would not end this process");
              }
            }),
            "");
  sigprocmask(SIG_SETMASK, &before, nullptr);
  for (const int number : {SIGALRM, SIGXCPU}) std::signal(number, SIG_DFL);
}

TEST_F(TrialReading, WithoutAnOutcomeIsNoSuccess) {
  std::signal(SIGCHLD, SIG_IGN);  // The system then forgets how a child ended.
  try {
    read_on_trial(path_, [] { std::raise(SIGSEGV); });
    ADD_FAILURE() << "should have refused";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit_code(), ExitCode::cannot_access);
    EXPECT_NE(std::string(failure.what()).find("the outcome of reading it in a child process is not known"),
              std::string::npos)
        << failure.what();
  }
  std::signal(SIGCHLD, SIG_DFL);
}

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kHasOwnAllocator = true;
#elif defined(__has_feature)
constexpr bool kHasOwnAllocator = __has_feature(address_sanitizer);
#else
constexpr bool kHasOwnAllocator = false;
#endif

TEST_F(TrialReading, TellsOfTooMuchMemory) {
  if (kHasOwnAllocator) GTEST_SKIP() << "a sanitizer's allocator ends the process instead";
  const char* const sentence =
      ": is damaged: reading it takes memory out of all proportion; write or copy it anew";
  EXPECT_EQ(told_of([] {
              std::vector<std::vector<char>> all;
              while (true) all.emplace_back(1 << 20, 'x');
            }),
            sentence);
  EXPECT_EQ(told_of([] { std::vector<double>(static_cast<std::size_t>(-1)); }), sentence);
}

TEST_F(TrialReading, TellsOfAnyOtherFault) {
  EXPECT_EQ(told_of([] { throw std::logic_error("of our own"); }),
            ": is damaged: reading it goes wrong; write or copy it anew");
}

}  // namespace
}  // namespace hyrax
