// A harmful file harms a child process only.
#include "tools/store/isolated_read.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <vector>

#include <sys/resource.h>
#include <unistd.h>

#include "tests/unit/tools/store/stored_flings.h"

namespace hyrax {
namespace {

class IsolatedRead : public testing::Test {
 protected:
  IsolatedRead() {
    write_bytes(path_, "a file");
    write_bytes(other_, "another");
  }

  // The sentence, without the path.
  std::string message_of(const auto& read) const {
    const std::string message = refusal_of([&] { read_isolated(path_, read); });
    return message.empty() ? message : message.substr(path_.size());
  }

  const TempFolder folder_;
  const std::string path_ = folder_.at("run.h5"), other_ = folder_.at("other.h5");
};

TEST_F(IsolatedRead, ChangesNothingHereAndLeavesARefusalToTheReadingThatFollows) {
  int value = 1;
  const auto refuse = [&] {
    value = 2;
    throw Failure(ExitCode::bad_input, "refused");
  };
  EXPECT_EQ(message_of(refuse), "");
  EXPECT_EQ(value, 1);
}

TEST_F(IsolatedRead, ReportsACrashAnyOtherFaultAndNoEnd) {
  const auto damaged = [](const std::string& how) {
    return ": is damaged: " + how + "; copy it again, or write it again";
  };
  EXPECT_EQ(message_of([] { std::raise(SIGSEGV); }), damaged("the HDF5 library crashes on it"));
  EXPECT_EQ(message_of([] { throw std::logic_error("of our own"); }), damaged("reading it fails"));
  const auto end_late = [] {  // The system ends it when its second is over, or the alarm does.
    rlimit time{};
    getrlimit(RLIMIT_CPU, &time);
    if (time.rlim_cur == 1 && alarm(0) > 0) std::raise(SIGXCPU);
  };
  EXPECT_EQ(message_of(end_late), damaged("reading it does not end"));
}

// A parent may ignore or block the signals by which the limits end the child.
TEST_F(IsolatedRead, IsUnderLimitsRegardlessOfInheritedSignals) {
  sigset_t blocked;
  sigset_t before;
  sigemptyset(&blocked);
  for (const int number : {SIGALRM, SIGXCPU}) {
    sigaddset(&blocked, number);
    std::signal(number, SIG_IGN);
  }
  sigprocmask(SIG_BLOCK, &blocked, &before);
  const auto look = [] {
    sigset_t in_child;
    sigprocmask(SIG_BLOCK, nullptr, &in_child);
    for (const int number : {SIGALRM, SIGXCPU}) {
      struct sigaction action {};
      sigaction(number, nullptr, &action);
      if (sigismember(&in_child, number) != 0 || action.sa_handler != SIG_DFL)
        throw std::logic_error("a limit would not end this process");
    }
  };
  EXPECT_EQ(message_of(look), "");
  sigprocmask(SIG_SETMASK, &before, nullptr);
  for (const int number : {SIGALRM, SIGXCPU}) std::signal(number, SIG_DFL);
}

TEST_F(IsolatedRead, WithoutAnOutcomeIsNoSuccess) {
  std::signal(SIGCHLD, SIG_IGN);  // The system then discards how a child ended.
  const std::string said =
      refusal_of([&] { read_isolated(path_, [] { std::raise(SIGSEGV); }); }, ExitCode::cannot_access);
  EXPECT_NE(said.find("the exit status of its child process is unknown"), std::string::npos) << said;
  std::signal(SIGCHLD, SIG_DFL);
}

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kHasOwnAllocator = true;
#elif defined(__has_feature)
constexpr bool kHasOwnAllocator = __has_feature(address_sanitizer);
#else
constexpr bool kHasOwnAllocator = false;
#endif

TEST_F(IsolatedRead, ReportsTooMuchMemory) {
  if (kHasOwnAllocator) GTEST_SKIP() << "a sanitizer's allocator ends the process instead";
  const char* const sentence =
      ": is damaged: reading it takes too much memory for its size; copy it again, or write it again";
  EXPECT_EQ(message_of([] {
              std::vector<std::vector<char>> all;
              while (true) all.emplace_back().reserve(1 << 26);  // Not written: that takes time.
            }),
            sentence);
  EXPECT_EQ(message_of([] { std::vector<double>(static_cast<std::size_t>(-1)); }), sentence);
}

TEST_F(IsolatedRead, TogetherIsNotRepeatedForTheSameFileUnderAnotherNameButForAChangedOne) {
  const auto read_both = [&] { read_isolated_together({path_, other_}, [](const std::string&) {}); };
  for (const char* const changed : {"a changed file", "a file changed again"}) {
    read_both();
    EXPECT_EQ(message_of([] { std::raise(SIGSEGV); }), "");
    write_bytes(path_, changed);
    EXPECT_NE(message_of([] { std::raise(SIGSEGV); }), "");
  }
  read_both();
  std::filesystem::rename(other_, path_);
  EXPECT_EQ(message_of([] { std::raise(SIGSEGV); }), "");
  const auto written = std::filesystem::last_write_time(path_);
  std::filesystem::last_write_time(path_, written + std::chrono::seconds(1));
  EXPECT_NE(message_of([] { std::raise(SIGSEGV); }), "");
  std::filesystem::last_write_time(path_, written);
  EXPECT_EQ(message_of([] { std::raise(SIGSEGV); }), "");
  write_bytes(other_, "another");
  std::filesystem::last_write_time(other_, written);
  std::filesystem::rename(other_, path_);
  EXPECT_NE(message_of([] { std::raise(SIGSEGV); }), "");
}

TEST_F(IsolatedRead, TogetherWithOneThatCrashesEachIsReadByItselfUnlessThatIsIsolatedInTheChild) {
  const auto crash = [] { std::raise(SIGSEGV); };
  read_isolated_together({path_, other_}, [&](const std::string& path) {
    if (path == other_) crash();
  });
  EXPECT_NE(message_of(crash), "");
  read_isolated_together({path_, other_}, [&](const std::string& path) { read_isolated(path, crash); });
  EXPECT_EQ(message_of(crash), "");
}

}  // namespace
}  // namespace hyrax
