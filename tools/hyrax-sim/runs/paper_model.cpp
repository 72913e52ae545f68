#include "tools/hyrax-sim/runs/paper_model.h"

#include "sim/replay/core_constants.h"
#include "sim/trajectory/physics_model.h"
#include "tools/files/failure.h"

namespace hyrax {

void require_paper_core(const std::string& what) {
  if (is_paper_model(core_model())) return;
  throw Failure(ExitCode::bad_input, what + ": needs the paper's model (found the core " +
                                         std::string(core_model()) +
                                         "); does not apply to a core of one's own");
}

void require_measurable(const std::string& path, const Scenario& scenario) {
  if (!scenario.expect) return;
  const Expect& expect = *scenario.expect;
  const auto require = [&](bool is_bounded, const char* key) {
    if (is_bounded) require_paper_core(path + ": /expect/" + key);
  };
  require(expect.implementation_px_max.has_value(), "implementation_px_max");
  require(expect.truncation_px_max.has_value(), "truncation_px_max");
  require(expect.energy_drift_rel_max.has_value(), "energy_drift_rel_max");
}

void require_paper_run(const TrajectoryFile& file, const std::string& what) {
  if (is_paper_model(file.head().physics)) return;
  file.refuse("attribute physics: " + what + " needs a run of the paper's model (found " +
              file.head().physics + ")");
}

}  // namespace hyrax
