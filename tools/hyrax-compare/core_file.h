// A core from a header: compiled, loaded, and refused where its results cannot be compared.
#pragma once

#include <string>

#include "sim/card/core_functions.h"
#include "tools/files/temporary_folder.h"

namespace hyrax {

/// Compiles a header that defines `class physics`, with the flags of this build, into a library in the
/// folder; returns the library's path. Several may compile at the same time, each with another `name`.
/// ERRORS: Failure(bad_input) with the compiler's messages; Failure(cannot_access) if the header cannot be
/// read or the compiler not be started.
[[nodiscard]] std::string compile_core(const std::string& header, const TemporaryFolder& folder,
                                       const std::string& name);

/// The library of the shipped core, built with this program.
[[nodiscard]] std::string shipped_core_library();

/// Loads a core's library, for as long as the program runs. ERRORS: Failure(cannot_access).
[[nodiscard]] const CoreFunctions& load_core(const std::string& library);

/// The core of the library, after it has been played in a process of its own, where it may crash or hang, and
/// has given the same rows there and here. @param header names it in messages.
/// ERRORS: Failure(bad_input) "HEADER: refused: REASON".
[[nodiscard]] const CoreFunctions& checked_core(const std::string& library, const std::string& header);

/// Ends the program with exit code 2 and "HEADER: refused: ..." if it receives a signal of a crash, or has
/// not ended after so many seconds: a core may crash or hang in states that checked_core does not reach.
/// Called once.
void refuse_on_crash(const std::string& header, unsigned limit_s);

/// The option with which the program starts itself for checked_core: plays the core of the library, and
/// prints a digest of its rows.
inline constexpr char kProbeOption[] = "--probe-library";
[[nodiscard]] std::string probe_text(const CoreFunctions& core);

}  // namespace hyrax
