// What the program says to whoever started it.
#pragma once

#include <string>
#include <string_view>

#include "tools/hyrax/playback.h"

namespace hyrax {

/// On standard output or the console that it was started from; a message box where there is neither.
void say(std::string_view text);

/// On standard error, the console, or in a message box.
void say_error(std::string_view text);

/// Good news as `say`, bad news as `say_error`.
void say(const Verdict& verdict);

[[nodiscard]] std::wstring to_wide(std::string_view utf8);
[[nodiscard]] std::string to_utf8(std::wstring_view wide);

}  // namespace hyrax
