// A core from a header: compiled and loaded.
#pragma once

#include <string>

#include "sim/card/core_functions.h"
#include "sim/card/play_watch.h"
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

/// Loads a core's library into a core process (core_process.h), for as long as it runs.
/// ERRORS: Failure(cannot_access); CoreRefused.
[[nodiscard]] const CoreFunctions& load_core(const std::string& library, int number, PlayWatch& watch);

}  // namespace hyrax
