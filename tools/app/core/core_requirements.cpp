#include "tools/app/core/core_requirements.h"

#include "sim/study/reference_model.h"
#include "sim/trajectory/physics_model.h"
#include "tools/files/failure.h"

namespace hyrax {

void require_paper_core(const Core& core, const std::string& what) {
  const std::optional<Constants> constants = core.constants;
  if (!constants)
    refuse_input(what + ": needs the paper's step, with any constants (found in the core " +
                 std::string(core.name) + ": " + core.paper_match.difference + ")");
  if (is_paper_model(core.name)) return;
  if (const std::string why_not = why_not_measurable(*constants); !why_not.empty())
    refuse_input(what + ": the core " + std::string(core.name) + ": " + why_not);
}

void require_measurable(const Core& core, const std::string& path, const Scenario& scenario) {
  if (!scenario.expect) return;
  const Expect& expect = *scenario.expect;
  const auto require = [&](bool is_bounded, const char* key) {
    if (is_bounded) require_paper_core(core, path + ": /expect/" + key);
  };
  require(expect.implementation_px_max.has_value(), "implementation_px_max");
  require(expect.truncation_px_max.has_value(), "truncation_px_max");
  require(expect.energy_drift_rel_max.has_value(), "energy_drift_rel_max");
}

void require_own_core(const Core& core, const std::string& path, const std::string& physics) {
  if (is_same_model(physics, core.name)) return;
  refuse_input(path + ": attribute physics: is of another core (found " + physics +
               "); this program's core is " + std::string(core.name));
}

}  // namespace hyrax
