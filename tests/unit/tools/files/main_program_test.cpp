// What every program does with what its work throws.
#include "tools/files/main_program.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "tools/files/failure.h"

namespace hyrax {
namespace {

TEST(RunProgram, EndsByWhatItsWorkThrows) {
  const auto end_by = [](const auto& work) {
    char name[] = "program", word[] = "word";
    char* arguments[] = {name, word};
    testing::internal::CaptureStderr();
    const int code = run_program("hyrax-x", 2, arguments, [&](const std::vector<std::string>& words) {
      EXPECT_EQ(words, std::vector<std::string>{"word"});
      work();
      return ExitCode::disagreed;
    });
    return std::to_string(code) + " " + testing::internal::GetCapturedStderr();
  };
  EXPECT_EQ(end_by([] {}), "1 ");
  EXPECT_EQ(end_by([] { refuse_input("file: bad"); }), "2 file: bad\n");
  EXPECT_EQ(end_by([] { throw std::bad_alloc(); }), "70 hyrax-x: out of memory\n");
  EXPECT_EQ(end_by([] { throw std::logic_error("oops"); }), "70 hyrax-x: internal error: oops\n");
}

}  // namespace
}  // namespace hyrax
