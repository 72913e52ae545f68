// hyrax-sim with a core that is given: a header and the step that was recorded of it, given when the
// program runs.
//
// HYRAX_TRACED_HEADER is the path of the header, HYRAX_TRACED_STEP that of its step in canonical text, which
// is played. With HYRAX_TRACED_WHY the program's record says that the step is not complete, and why.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "sim/cause/header_change.h"
#include "sim/core/core_of.h"
#include "sim/core/traced_stepper.h"
#include "sim/trace/step_text.h"
#include "tools/hyrax-sim/program.h"

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

// The paper's where the header has none of the name.
Constants constants_in(const std::string& header) {
  std::map<std::string, double> values{{"GRAVITY", 1200.0},
                                       {"RESTITUTION", 0.6},
                                       {"AIR_DRAG", 0.999},
                                       {"GROUND_FRICTION", 0.8},
                                       {"REST_THRESHOLD", 5.0}};
  for (const HeaderConstant& constant : header_constants(header)) values[constant.name] = constant.value;
  return {values["GRAVITY"], values["RESTITUTION"], values["AIR_DRAG"], values["GROUND_FRICTION"],
          values["REST_THRESHOLD"]};
}

// Refers to the texts.
Core given_core(const std::string& header, const std::string& step) {
  const std::optional<TracedStep> read = read_step(step);
  std::optional<Core> core = read ? traced_core(*read) : std::nullopt;
  if (!core) refuse("HYRAX_TRACED_STEP", "not a step that can be played");
  const char* const why = std::getenv("HYRAX_TRACED_WHY");
  core->constants = constants_in(header);
  core->record.header = header;
  if (why == nullptr)
    core->record.step = step;
  else
    core->record.why_incomplete = why;
  complete_by_step(*core);
  return *core;
}

}  // namespace
}  // namespace hyrax

int main(int argc, char** argv) {
  using namespace hyrax;
  const std::string header = text_of("HYRAX_TRACED_HEADER"), step = text_of("HYRAX_TRACED_STEP");
  return run_hyrax_sim(given_core(header, step), argc, argv);
}
