// A child process takes the harm.
#include "tools/store/trial_reading.h"

#include <gtest/gtest.h>

#include <csignal>
#include <vector>

#include "tests/tools/store/stored_flings.h"

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
