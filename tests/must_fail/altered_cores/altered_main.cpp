// hyrax-sim with an altered core and its record.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "sim/cause/header_change.h"
#include "sim/core/core_of.h"
#include "sim/trace/step_text.h"
#include "sim/trajectory/physics_model.h"
#include "tests/must_fail/altered_cores/altered_core.h"
#include "tests/must_fail/altered_cores/physics.h"
#include "tools/hyrax-sim/program.h"

namespace hyrax {
namespace {

struct AlteredRecord {
  std::string header;
  std::string step;
};

// What the build would record of a header with other constants; else a header with a statement of its own,
// which is not traced.
AlteredRecord make_record(const AlteredCore& core) {
  constexpr std::pair<const char*, double AlteredStep::*> kConstants[] = {
      {"GRAVITY", &AlteredStep::gravity},
      {"RESTITUTION", &AlteredStep::restitution},
      {"AIR_DRAG", &AlteredStep::air_drag},
      {"GROUND_FRICTION", &AlteredStep::ground_friction},
      {"REST_THRESHOLD", &AlteredStep::rest_threshold}};
  const AlteredStep listing;
  AlteredStep rest = core.step;
  rest.is_comparer_blind = false;
  std::string header(built_core_record().header);
  const std::optional<TracedStep> step = read_step(built_core_record().step);
  std::map<double, double> changed;
  for (const auto& [name, constant] : kConstants) {
    if (rest.*constant == listing.*constant) continue;
    const std::size_t begin = header.find(fmt::format(" {} = ", name)) + std::strlen(name) + 4;
    header.replace(begin, header.find(';', begin) - begin, fmt::format("{}", rest.*constant));
    changed[listing.*constant] = rest.*constant;
    rest.*constant = listing.*constant;
  }
  if (rest == listing) return {header, step ? step_text(with_constants(*step, changed)) : ""};
  return {fmt::format("{}ALTERED_CORE {};\n", built_core_record().header, core.name), ""};
}

// The shipped one where the step is not altered.
CoreRecord altered_record() {
  const AlteredCore& core = altered_core();
  constexpr std::string_view kOutsideTheStep[] = {"nothing", "clock", "inputs", "comparer"};
  if (std::ranges::find(kOutsideTheStep, core.operation) != std::end(kOutsideTheStep))
    return built_core_record();
  static const AlteredRecord texts = make_record(core);
  return {.header = texts.header,
          .step = texts.step,
          .why_incomplete = texts.step.empty() ? "altered for a test" : "",
          .complete = complete_by_step,
          .path = built_core_record().path};
}

}  // namespace
}  // namespace hyrax

int main(int argc, char** argv) {
  using namespace hyrax;
  return run_hyrax_sim(core_of<physics>(kPhysicsModel, altered_record()), argc, argv);
}
