#include "tools/platform/standard_streams.h"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

namespace hyrax {

// Without a console a stream has no number.
void prepare_standard_streams() {
  for (std::FILE* const stream : {stdin, stdout, stderr})
    if (_fileno(stream) >= 0) _setmode(_fileno(stream), _O_BINARY);
  SetConsoleOutputCP(CP_UTF8);
  for (const DWORD number :
       {STD_OUTPUT_HANDLE, STD_ERROR_HANDLE}) {  // Colours, and lines that are written again.
    DWORD mode = 0;
    if (GetConsoleMode(GetStdHandle(number), &mode) != 0)
      SetConsoleMode(GetStdHandle(number), mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
  }
}

std::FILE* open_standard_output() { return _fdopen(_dup(_fileno(stdout)), "wb"); }

// The null device counts as one for _isatty.
bool is_terminal(std::FILE* stream) {
  DWORD mode = 0;
  return _fileno(stream) >= 0 &&
         GetConsoleMode(reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(stream))), &mode) != 0;
}

std::optional<std::size_t> terminal_columns() {
  CONSOLE_SCREEN_BUFFER_INFO screen{};
  if (GetConsoleScreenBufferInfo(GetStdHandle(STD_OUTPUT_HANDLE), &screen) == 0) return std::nullopt;
  return static_cast<std::size_t>(screen.srWindow.Right - screen.srWindow.Left + 1);
}

}  // namespace hyrax
