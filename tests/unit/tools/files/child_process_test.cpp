// A program that is started: what it reads and prints, and how it ends.
#include "tools/files/child_process.h"

#include <gtest/gtest.h>

#include <cerrno>

#include "tests/unit/tools/files/refusal.h"
#include "tools/files/main_program.h"

namespace hyrax {
namespace {

ChildEnd end_of(const std::string& script, std::string_view input = "",
                std::optional<double> limit_s = std::nullopt, std::size_t out_bytes_max = 1000) {
  return run_child({"sh", "-c", script}, input, limit_s, out_bytes_max);
}

TEST(ChildProcess, GivesItsExitCodeAndWhatItPrinted) {
  const ChildEnd end = end_of("cat; echo error >&2; exit 3", "input\n", 60.0);
  EXPECT_EQ(end.exit_code, 3);
  EXPECT_FALSE(end.is_timed_out);
  EXPECT_EQ(end.out, "input\n");
  EXPECT_EQ(end.err, "error\n");
}

TEST(ChildProcess, MayPrintMoreThanIsKept) {
  const std::string print = "head -c 300000 /dev/zero | tr '\\0' ";
  const ChildEnd end = end_of(print + "a; " + print + "b >&2");
  EXPECT_EQ(end.out, std::string(1000, 'a'));
  EXPECT_EQ(end.err, std::string(64 << 10, 'b'));
}

TEST(ChildProcess, MayEndByASignalOrTooLate) {
  EXPECT_EQ(end_text(end_of("kill -TERM $$"), 9.0), "signal 15 (exit code 143)");
  EXPECT_EQ(end_text(end_of("exit 128"), 9.0), "exit code 128");
  ChildEnd late;
  // On a busy machine a short time ends before the child has printed.
  for (double limit_s = 0.2; late.out.empty() && limit_s < 60.0; limit_s *= 2.0) {
    late = end_of("echo first; sleep 600", "", limit_s);
    EXPECT_EQ(end_text(late, 2.5), "no end within 2.5 s");
  }
  EXPECT_EQ(late.out, "first\n");
}

TEST(ChildProcess, ThatCannotBeStartedIsNamed) {
  EXPECT_EQ(
      refusal_of([] { static_cast<void>(run_child({"/etc/passwd"}, "", 1.0)); }, ExitCode::cannot_access),
      "/etc/passwd: cannot be started: Permission denied");
}

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
