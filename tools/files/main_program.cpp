#include "tools/files/main_program.h"

#include "tools/files/printable.h"

namespace hyrax {

int run_program(const std::string& name, int argument_count, char** arguments,
                const std::function<ExitCode(const std::vector<std::string>&)>& work) {
  ExitCode exit_code = ExitCode::agreed;
  const auto failure = failure_of(name, [&] {
    exit_code =
        work(std::vector<std::string>(arguments + (argument_count > 0 ? 1 : 0), arguments + argument_count));
  });
  if (failure) {
    print_error(failure->what());
    exit_code = failure->exit_code();
  }
  if (!is_all_printed()) {
    print_error(name + ": standard output cannot be written");
    exit_code = more_serious(exit_code, ExitCode::cannot_access);
  }
  return static_cast<int>(exit_code);
}

}  // namespace hyrax
