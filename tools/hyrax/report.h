// Messages to the user.
#pragma once

#include <string_view>

#include "tools/hyrax/playback.h"

namespace hyrax {

/// On standard output or the console that the program was started from; in a message box if there is neither.
void report(std::string_view text);

/// On standard error, the console, or in a message box.
void report_error(std::string_view text);

/// As `report` if it agreed, else as `report_error`.
void report(const PlaybackVerdict& verdict);

}  // namespace hyrax
