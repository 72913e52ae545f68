#include "tools/platform/standard_streams.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace hyrax {

// Otherwise the first file that is opened would get the number of a closed stream, and be printed into.
// Writing to a stream that is open for reading only fails, as writing to a closed one does.
void prepare_standard_streams() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(number, F_GETFD) < 0) static_cast<void>(open("/dev/null", O_RDONLY));
}

std::FILE* open_standard_output() { return fdopen(dup(STDOUT_FILENO), "wb"); }

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) == 1; }

std::optional<std::size_t> terminal_columns() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::nullopt;
  return size.ws_col;
}

}  // namespace hyrax
