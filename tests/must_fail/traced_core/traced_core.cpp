// Takes the place of this program's core: a header and the step that was recorded of it, given when the
// program runs.
//
// HYRAX_TRACED_HEADER is the path of the header, HYRAX_TRACED_STEP that of its step in canonical text, which
// is played. With HYRAX_TRACED_WHY the program's record says that the step is not complete, and why.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

#include "sim/cause/header_change.h"
#include "sim/replay/core_constants.h"
#include "sim/replay/core_contacts.h"
#include "sim/replay/kernel.h"
#include "sim/replay/traced_kernel.h"
#include "sim/trace/core_record.h"
#include "sim/trace/step_text.h"
#include "sim/trajectory/physics_model.h"

namespace hyrax {
namespace {

[[noreturn]] void refuse(const char* variable, const char* fault) {
  std::fprintf(stderr, "%s: %s\n", variable, fault);
  std::_Exit(2);
}

std::string text_of(const char* variable) {
  const char* const path = std::getenv(variable);
  if (path == nullptr) refuse(variable, "missing");
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(variable, "cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

struct GivenCore {
  std::string header = text_of("HYRAX_TRACED_HEADER");
  std::string step = text_of("HYRAX_TRACED_STEP");
  std::unique_ptr<const Kernel> kernel;
  CoreRecord record;

  GivenCore() {
    if (const auto traced = read_step(step)) kernel = make_traced_kernel(*traced);
    if (!kernel) refuse("HYRAX_TRACED_STEP", "not a step that can be played");
    const char* const why = std::getenv("HYRAX_TRACED_WHY");
    record.header = header;
    if (why == nullptr)
      record.step = step;
    else
      record.why_incomplete = why;
  }
};

const GivenCore& given() {
  static const GivenCore core;
  return core;
}

}  // namespace

const CoreRecord& core_record() { return given().record; }

const Kernel& compiled_kernel() { return *given().kernel; }

const Kernel& core_kernel() { return core_with_recorded_contacts(); }

std::string_view core_model() { return kPhysicsModel; }

// The paper's where the header has none of the name.
Constants core_constants() {
  Constants constants{1200.0, 0.6, 0.999, 0.8, 5.0};
  const std::array<std::pair<const char*, double*>, 5> names = {
      {{"GRAVITY", &constants.gravity_px_per_s2},
       {"RESTITUTION", &constants.restitution},
       {"AIR_DRAG", &constants.air_drag},
       {"GROUND_FRICTION", &constants.ground_friction},
       {"REST_THRESHOLD", &constants.rest_threshold_px_per_s}}};
  for (const HeaderConstant& constant : header_constants(given().header))
    for (const auto& [name, value] : names)
      if (constant.name == name) *value = constant.value;
  return constants;
}

}  // namespace hyrax
