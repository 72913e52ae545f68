// What needs the paper's model, which a core of one's own is not.
#pragma once

#include <string>

#include "sim/scenario/scenario.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {

/// ERRORS: Failure(bad_input) "WHAT: needs the paper's model ..." if this program's core is another.
void require_paper_core(const std::string& what);

/// As require_paper_core, for the bounds of errors in `expect`: they are measured against the paper's model.
/// @param path of the scenario, for the message.
void require_measurable(const std::string& path, const Scenario& scenario);

/// ERRORS: Failure(bad_input) if the file's run is of another model than the paper's, whose `what` would be
/// wrong for it.
void require_paper_run(const TrajectoryFile& file, const std::string& what);

}  // namespace hyrax
