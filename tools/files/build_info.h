// Version, compiler and flags of this build.
#pragma once

#include <string_view>

namespace hyrax {

/// The result of the self-test of arithmetic. Programs whose self-test has another one refuse to compute.
inline constexpr std::string_view kStrictArithmetic = "strict IEEE-754 double arithmetic";

struct BuildInfo {
  std::string_view version;
  std::string_view compiler;
  std::string_view flags;
  std::string_view target;
  std::string_view instruction_set;  ///< Of the build; this machine may have more.
};

[[nodiscard]] BuildInfo build_info();

}  // namespace hyrax
