#include "tools/app/core/core_requirements.h"

#include <algorithm>
#include <vector>

#include "sim/cause/header_change.h"
#include "sim/study/reference_model.h"
#include "sim/trajectory/physics_model.h"
#include "tools/files/failure.h"

namespace hyrax {

Core with_header_names(Core core) {
  if (!core.paper_match.constants || core.constant_names != ConstantNames()) return core;
  std::vector<std::string_view> texts = {core.record.header};
  for (const CoreFile& file : core.record.files) texts.push_back(file.text);
  for (std::size_t place = 0; place < kConstantFields.size(); ++place) {
    const double value = *core.paper_match.constants.*kConstantFields[place];
    std::vector<std::string_view> names;  // As the texts have them, which outlive the core.
    for (const std::string_view text : texts) {
      for (const HeaderConstant& constant : header_constants(text)) {
        if (!same_bits(constant.value, value)) continue;
        const std::string declared = "double " + constant.name;
        const std::size_t at = text.find(declared);
        names.push_back(at == std::string_view::npos
                            ? ""
                            : text.substr(at, declared.size()).substr(declared.find(' ') + 1));
      }
      if (std::ranges::count(header_literals(text), value) > 0) names.emplace_back();
    }
    if (names.size() == 1) core.constant_names[place] = names.front();
  }
  return core;
}

void require_paper_core(const Core& core, const std::string& what) {
  if (!core.constants)
    refuse_input(what + ": needs the paper's step, with any constants (found in the core " +
                 std::string(core.name) + ": " + core.paper_match.difference + ")");
  if (const std::string why_not = why_not_measurable(reference_model(core)); !why_not.empty())
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
