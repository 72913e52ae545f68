#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/hyrax-sim/commands.h"

int main(int argc, char** argv) {
  using namespace hyrax;
  // A file that may not grow further is an error like a full disk, and no end of the process.
  std::signal(SIGXFSZ, SIG_IGN);
  // Where a parent left it ignored, the outcome of a child process would be lost.
  std::signal(SIGCHLD, SIG_DFL);
  ExitCode exit_code = ExitCode::program_fault;
  try {
    exit_code =
        run_command_line(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc),
                         {run_command(), check_command(), bless_command(), diff_command(), drift_command(),
                          study_command(), validate_command(), schema_command(), info_command()});
  } catch (const Failure& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    exit_code = failure.exit_code();
  } catch (const std::filesystem::filesystem_error& error) {
    std::fprintf(stderr, "%s: cannot be accessed: %s\n", error.path1().c_str(),
                 error.code().message().c_str());
    exit_code = ExitCode::cannot_access;
  } catch (const std::bad_alloc&) {
    std::fputs("hyrax-sim: out of memory\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hyrax-sim: a fault of the program itself: %s\n", error.what());
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    std::fputs("hyrax-sim: standard output cannot be written\n", stderr);
    exit_code = more_serious(exit_code, ExitCode::cannot_access);
  }
  return static_cast<int>(exit_code);
}
