#include <csignal>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "tools/files/printable.h"
#include "tools/hyrax-sim/commands.h"

namespace {

// Else the first file that is opened would be in the place of a closed stream, and be printed into. Writing
// to what is open for reading only fails as writing to a closed stream does.
void hold_closed_streams() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(number, F_GETFD) < 0) static_cast<void>(open("/dev/null", O_RDONLY));
}

}  // namespace

int main(int argc, char** argv) {
  using namespace hyrax;
  hold_closed_streams();
  // A file that may not grow further is an error like a full disk, and no end of the process.
  std::signal(SIGXFSZ, SIG_IGN);
  // Where a parent left it ignored, the outcome of a child process would be lost.
  std::signal(SIGCHLD, SIG_DFL);
  ExitCode exit_code = ExitCode::program_fault;
  try {
    exit_code = run_command_line(
        std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc),
        {run_command(), check_command(), bless_command(), diff_command(), drift_command(), study_command(),
         new_command(), validate_command(), schema_command(), info_command()});
  } catch (const Failure& failure) {
    print_error(failure.what());
    exit_code = failure.exit_code();
  } catch (const std::filesystem::filesystem_error& error) {
    print_error(error.path1().string() + ": cannot be accessed: " + error.code().message());
    exit_code = ExitCode::cannot_access;
  } catch (const std::bad_alloc&) {
    print_error("hyrax-sim: out of memory");
  } catch (const std::exception& error) {
    print_error(std::string("hyrax-sim: internal error: ") + error.what());
  }
  if (!is_all_printed()) {
    print_error("hyrax-sim: standard output cannot be written");
    exit_code = more_serious(exit_code, ExitCode::cannot_access);
  }
  return static_cast<int>(exit_code);
}
