#include "tools/app/command_line/overrides.h"

#include "tools/files/failure.h"

namespace hyrax {

std::vector<Override> overrides_of(const std::string& command, const std::vector<std::string>& texts) {
  std::vector<Override> overrides;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || !text.starts_with('/'))
      refuse_input(command + ": --set: not POINTER=VALUE (found " + text + "); as in /clock/rate_hz=144");
    overrides.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  return overrides;
}

}  // namespace hyrax
