// How a command ends: the exit codes, and the one exception that carries them.
#pragma once

#include <cerrno>
#include <cstring>
#include <new>
#include <optional>
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
  not_strict_ieee = 5,  ///< Arithmetic is not strict IEEE-754.
  program_fault = 70,   ///< Internal error.
};

/// The more serious of two outcomes: 5, 70, 3, 2, 4, 1, 0.
[[nodiscard]] constexpr ExitCode more_serious(ExitCode a, ExitCode b) {
  for (const ExitCode code : {ExitCode::not_strict_ieee, ExitCode::program_fault, ExitCode::cannot_access,
                              ExitCode::bad_input, ExitCode::golden_missing, ExitCode::disagreed})
    if (a == code || b == code) return code;
  return ExitCode::agreed;
}

/// The input or the machine is wrong. `what()` has a line for each error, with file, place, value, rule and
/// remedy. Caught in main, or for each scenario where one must not stop the others.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode exit_code, const std::string& sentences)
      : std::runtime_error(sentences), exit_code_(exit_code) {}
  [[nodiscard]] ExitCode exit_code() const { return exit_code_; }

 private:
  ExitCode exit_code_;
};

/// One whose sentence does not say where: failure_of does.
class UnplacedFailure : public Failure {
 public:
  using Failure::Failure;
};

/// What ends the work, as a failure: a fault of the program is one of `name`. Nothing: the work is done.
template <class Work>
[[nodiscard]] std::optional<Failure> failure_of(const std::string& name, const Work& work) {
  try {
    work();
    return std::nullopt;
  } catch (const UnplacedFailure& failure) {
    return Failure(failure.exit_code(), name + ": " + failure.what());
  } catch (const Failure& failure) {
    return failure;
  } catch (const std::bad_alloc&) {
    return Failure(ExitCode::program_fault, name + ": out of memory");
  } catch (const std::exception& error) {
    return Failure(ExitCode::program_fault, name + ": internal error: " + error.what());
  }
}

/// Throws Failure(bad_input).
[[noreturn]] inline void refuse_input(const std::string& sentences) {
  throw Failure(ExitCode::bad_input, sentences);
}

/// Throws Failure(cannot_access) "PATH: cannot be read: REASON" for the error number that the system gave.
[[noreturn]] inline void fail_to_read(const std::string& path, int error_number) {
  throw Failure(ExitCode::cannot_access, path + ": cannot be read: " + std::strerror(error_number));
}

/// As fail_to_read, "PATH: cannot be written: REASON".
[[noreturn]] inline void fail_to_write(const std::string& path, int error_number) {
  throw Failure(ExitCode::cannot_access, path + ": cannot be written: " + std::strerror(error_number));
}
/// Behind calls of which one may have failed to write.
inline void require_written(bool is_written, const std::string& path) {
  if (!is_written) fail_to_write(path, errno == 0 ? EIO : errno);
}

}  // namespace hyrax
