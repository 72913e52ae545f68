// What this program was built from and with.
#pragma once

#include <string_view>

namespace hyrax {

struct BuildInfo {
  std::string_view version;
  std::string_view compiler;
  std::string_view flags;
  std::string_view target;
};

[[nodiscard]] BuildInfo build_info();

}  // namespace hyrax
