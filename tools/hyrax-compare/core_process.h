// A process of its own for cores, where they can end only themselves.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/card/play_watch.h"
#include "tools/files/temporary_folder.h"

namespace hyrax {

/// Returns what `work` does, done in a process of its own. Cores may be loaded there alone.
/// @param headers by ComparedCore::number: they name a core in messages.
/// @param folder for the text on its way back.
/// ERRORS: what work throws, as a Failure; Failure(bad_input) "HEADER: refused: ...", with the place, if a
/// core ends the process, is refused or takes longer than the limit. REQUIRES: no other thread runs.
[[nodiscard]] std::string in_core_process(const std::vector<std::string>& headers, unsigned limit_s,
                                          const TemporaryFolder& folder,
                                          const std::function<std::string(PlayWatch&)>& work);

}  // namespace hyrax
