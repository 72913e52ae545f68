// A core from a header: compiled, traced, and loaded into a process of its own, where it can end only itself.
#pragma once

#include <functional>
#include <string>

#include "sim/card/card.h"
#include "sim/card/compared_core.h"
#include "tools/app/core/accepted_core.h"
#include "tools/files/temporary_folder.h"

namespace hyrax {

struct CoreFile {
  std::string library;
  AcceptedCore core;  ///< Its header and its step.
};

/// Compiles a header that defines `class physics`, with the flags of this build, into a library in the
/// folder, and traces its step meanwhile. Several may be made at the same time, each with another `name`.
/// ERRORS: Failure(bad_input) with the compiler's first error; Failure(cannot_access) if the header cannot be
/// read or the compiler not be started.
[[nodiscard]] CoreFile make_core(const std::string& header, const TemporaryFolder& folder,
                                 const std::string& name);

/// The project's sim/physics/physics.h, whose record is `shipped`; it was compiled and traced with this
/// program, unless it has changed since. ERRORS: as make_core's.
[[nodiscard]] CoreFile core_of_project(const CoreRecord& shipped, const TemporaryFolder& folder,
                                       const std::string& name);

/// The accepted core of a golden folder. ERRORS: as read_accepted_core's, and make_core's;
/// Failure(golden_missing) if there is none; Failure(bad_input) if its header, compiled now, takes another
/// step.
[[nodiscard]] CoreFile core_of_golden(const CoreRecord& shipped, const std::string& golden_folder,
                                      const TemporaryFolder& folder, const std::string& name);

/// Loads a core's library into a core process, for as long as it runs.
/// ERRORS: Failure(cannot_access); CoreRefused.
[[nodiscard]] LibraryCore& load_library(const std::string& library, int number, PlayWatch& watch);
[[nodiscard]] ComparedCore load_core(const CoreFile& file, int number, PlayWatch& watch);

/// Returns what `work` does, done in a process of its own. Cores may be loaded there alone.
/// @param headers of the cores 0 and 1 (ComparedCore::number): they name a core in messages.
/// @param folder for the text on its way back.
/// ERRORS: what work throws, as a Failure; Failure(bad_input) "HEADER: refused: ...", with the place, if a
/// core ends the process, is refused or takes longer than the limit. REQUIRES: no other thread runs.
[[nodiscard]] std::string in_core_process(const BeforeAfter<std::string>& headers, unsigned limit_s,
                                          const TemporaryFolder& folder,
                                          const std::function<std::string(PlayWatch&)>& work);

}  // namespace hyrax
