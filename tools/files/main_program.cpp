#include "tools/files/main_program.h"

#include <exception>
#include <new>

#include "tools/files/printable.h"

namespace hyrax {

int run_program(const std::string& name, int argument_count, char** arguments,
                const std::function<ExitCode(const std::vector<std::string>&)>& work) {
  ExitCode exit_code = ExitCode::program_fault;
  try {
    exit_code =
        work(std::vector<std::string>(arguments + (argument_count > 0 ? 1 : 0), arguments + argument_count));
  } catch (const Failure& failure) {
    print_error(failure.what());
    exit_code = failure.exit_code();
  } catch (const std::bad_alloc&) {
    print_error(name + ": out of memory");
  } catch (const std::exception& error) {
    print_error(name + ": internal error: " + error.what());
  }
  if (!is_all_printed()) {
    print_error(name + ": standard output cannot be written");
    exit_code = more_serious(exit_code, ExitCode::cannot_access);
  }
  return static_cast<int>(exit_code);
}

}  // namespace hyrax
