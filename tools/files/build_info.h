// What this program was built from and with.
#pragma once

#include <string_view>

namespace hyrax {

/// What the self-test of arithmetic comes to in every program that computes: the others refuse to.
inline constexpr std::string_view kStrictArithmetic = "strict IEEE-754 double arithmetic";

struct BuildInfo {
  std::string_view version;
  std::string_view compiler;
  std::string_view flags;
  std::string_view target;
  std::string_view instruction_set;  ///< That it was built for; this machine may have more.
};

[[nodiscard]] BuildInfo build_info();

}  // namespace hyrax
