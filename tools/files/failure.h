// How a command ends: the exit codes, and the one exception that carries them.
#pragma once

#include <stdexcept>
#include <string>

namespace hyrax {

/// The published exit codes. With several outcomes the most serious wins.
enum class ExitCode {
  agreed = 0,           ///< Or done.
  disagreed = 1,        ///< A comparison or an `expect` does not hold, or a state became non-finite.
  bad_input = 2,        ///< Or bad usage.
  cannot_access = 3,    ///< Cannot read or write.
  golden_missing = 4,   ///< Never a pass.
  not_strict_ieee = 5,  ///< This machine or build does not do strict IEEE-754 double arithmetic.
  program_fault = 70,   ///< A fault of the program itself.
};

/// The more serious of two outcomes: 5, 70, 3, 2, 4, 1, 0.
[[nodiscard]] ExitCode more_serious(ExitCode a, ExitCode b);

/// The input or the machine is wrong. `what()` is whole sentences that name file, place, value,
/// rule and remedy, one a line. Caught once, in main, or where each scenario stands alone.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode exit_code, const std::string& sentences)
      : std::runtime_error(sentences), exit_code_(exit_code) {}
  [[nodiscard]] ExitCode exit_code() const { return exit_code_; }

 private:
  ExitCode exit_code_;
};

}  // namespace hyrax
