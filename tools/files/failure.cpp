#include "tools/files/failure.h"

#include <algorithm>
#include <array>

namespace hyrax {

ExitCode more_serious(ExitCode a, ExitCode b) {
  constexpr std::array kBySeriousness = {
      ExitCode::agreed,        ExitCode::disagreed,     ExitCode::golden_missing, ExitCode::bad_input,
      ExitCode::cannot_access, ExitCode::program_fault, ExitCode::not_strict_ieee};
  const auto rank = [&](ExitCode code) {
    return std::find(kBySeriousness.begin(), kBySeriousness.end(), code);
  };
  return rank(a) < rank(b) ? b : a;
}

}  // namespace hyrax
