// `bless` accepts the core with the library: planned before the first write.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/app/bless/blessing.h"
#include "tools/app/causes/core_check.h"
#include "tools/app/core/accepted_core.h"

namespace hyrax {

/// What becomes of the accepted core of one golden folder.
struct CoreAcceptance {
  std::string golden_folder;
  AcceptedCore core;        ///< This program's.
  std::string why_not;      ///< As "3 of 99 scenarios do not agree, the first is ..."; empty: it is accepted.
  CoreVerdict differences;  ///< From the one accepted before.
};

/// Of libraries_of(arguments). Plays each whole, unless its accepted core is this
/// program's already: then nothing is planned.
/// @param blessings of scenarios that will agree.
[[nodiscard]] std::vector<CoreAcceptance> plan_core_acceptances(const std::vector<std::string>& arguments,
                                                                const std::vector<Blessing>& blessings,
                                                                const BlessOptions& options);

/// Writes those that are accepted, unless a blessing has failed.
/// ERRORS: as write_accepted_core's.
void write_cores(const std::vector<CoreAcceptance>& cores, const std::vector<Blessing>& blessings);

/// "core: accepted in golden/core", or why not. Complete lines.
[[nodiscard]] std::string acceptances_text(const std::vector<CoreAcceptance>& cores, bool is_written);

}  // namespace hyrax
