// Frame times and inputs that are wrong on purpose, and the record of an altered core. The linker passes each
// call from another source file through these (--wrap).
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "sim/cause/constant_change.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "sim/trace/core_record.h"
#include "sim/trace/step_text.h"
#include "sim/trajectory/columns.h"
#include "tests/must_fail/altered_cores/altered_core.h"

#define WRAPPED(symbol) asm("__wrap_" symbol)
#define ORIGINAL(symbol) asm("__real_" symbol)

namespace hyrax {

class RowTable;  // tools/store/trajectory_parts.h, which needs HDF5.

const CoreRecord& original_record() ORIGINAL("_ZN5hyrax11core_recordEv");
const CoreRecord& altered_record() WRAPPED("_ZN5hyrax11core_recordEv");

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
  std::string header(original_record().header);
  std::optional<TracedStep> step = read_step(original_record().step);
  for (const auto& [name, constant] : kConstants) {
    if (rest.*constant == listing.*constant) continue;
    const std::size_t begin = header.find(fmt::format(" {} = ", name)) + std::strlen(name) + 4;
    header.replace(begin, header.find(';', begin) - begin, fmt::format("{}", rest.*constant));
    if (step) step = with_constant(*step, listing.*constant, rest.*constant);
    rest.*constant = listing.*constant;
  }
  if (rest == listing) return {header, step ? step_text(*step) : ""};
  return {fmt::format("{}ALTERED_CORE {};\n", original_record().header, core.name), ""};
}

}  // namespace

// The shipped one where the step is not altered.
const CoreRecord& altered_record() {
  const AlteredCore& core = altered_core();
  constexpr std::string_view kOutsideTheStep[] = {"nothing", "clock", "inputs", "comparer", "writer"};
  if (std::ranges::find(kOutsideTheStep, core.operation) != std::end(kOutsideTheStep))
    return original_record();
  static const AlteredRecord texts = make_record(core);
  static const CoreRecord record = {.header = texts.header,
                                    .step = texts.step,
                                    .why_incomplete = texts.step.empty() ? "altered for a test" : ""};
  return record;
}

void original_clock(FrameClock* made, const Clock& clock) ORIGINAL("_ZN5hyrax10FrameClockC1ERKNS_5ClockE");
void altered_clock(FrameClock* made, const Clock& clock) WRAPPED("_ZN5hyrax10FrameClockC1ERKNS_5ClockE");
namespace {

// The jitter of a clock that has none.
constexpr Jitter kFirstFrame;

}  // namespace

// The base dt is the first member, the jitter the second.
void altered_clock(FrameClock* made, const Clock& clock) {
  original_clock(made, clock);
  double base_dt_s = 0.0;
  std::memcpy(&base_dt_s, made, sizeof base_dt_s);
  base_dt_s *= altered_step().frame_factor;
  std::memcpy(static_cast<void*>(made), &base_dt_s, sizeof base_dt_s);
  if (altered_step().first_frame_factor == 1.0 || !made->is_fixed()) return;
  const Jitter* const jitter = &kFirstFrame;
  std::memcpy(reinterpret_cast<std::byte*>(made) + sizeof base_dt_s, &jitter, sizeof jitter);
}

double original_jitter(double dt_s, const Jitter& jitter, std::int64_t frame)
    ORIGINAL("_ZN5hyrax13jittered_dt_sEdRKNS_6JitterEl");
double altered_jitter(double dt_s, const Jitter& jitter, std::int64_t frame)
    WRAPPED("_ZN5hyrax13jittered_dt_sEdRKNS_6JitterEl");
double altered_jitter(double dt_s, const Jitter& jitter, std::int64_t frame) {
  const AlteredStep& step = altered_step();
  if (&jitter == &kFirstFrame) return frame == 0 ? dt_s * step.first_frame_factor : dt_s;
  const double factor = frame == 0 ? step.first_jitter_factor : 1.0;
  return original_jitter(dt_s, jitter, frame + step.jitter_shift) * step.jitter_factor * factor;
}

namespace {

// No later than the last frame. Inputs stay in their order.
std::int64_t late(std::int64_t frame, std::int64_t steps, bool is_last) {
  const AlteredStep& step = altered_step();
  const std::int64_t frames = step.inputs_late + (is_last ? step.last_input_late : 0);
  return frame >= 0 && frame < steps ? std::min(frame + frames, steps - 1) : frame;
}

}  // namespace

Schedule original_schedule(const Scenario& scenario, std::int64_t steps, std::int64_t walked_frame_max)
    ORIGINAL("_ZN5hyrax15schedule_eventsERKNS_8ScenarioEll");
Schedule altered_schedule(const Scenario& scenario, std::int64_t steps, std::int64_t walked_frame_max)
    WRAPPED("_ZN5hyrax15schedule_eventsERKNS_8ScenarioEll");
Schedule altered_schedule(const Scenario& scenario, std::int64_t steps, std::int64_t walked_frame_max) {
  Schedule schedule = original_schedule(scenario, steps, walked_frame_max);
  for (std::int64_t& frame : schedule.frames) frame = late(frame, steps, &frame == &schedule.frames.back());
  return schedule;
}

bool original_append(RowTable* table, const Columns& rows)
    ORIGINAL("_ZN5hyrax8RowTable6appendERKNS_7ColumnsE");
bool altered_append(RowTable* table, const Columns& rows) WRAPPED("_ZN5hyrax8RowTable6appendERKNS_7ColumnsE");
bool altered_append(RowTable* table, const Columns& rows) {
  if (!altered_step().swaps_columns) return original_append(table, rows);
  Columns swapped = rows;
  std::swap(swapped.vx_px_per_s, swapped.vy_px_per_s);
  return original_append(table, swapped);
}

std::vector<Input> original_inputs(const Scenario& scenario, std::int64_t frames)
    ORIGINAL("_ZN5hyrax9inputs_ofERKNS_8ScenarioEl");
std::vector<Input> altered_inputs(const Scenario& scenario, std::int64_t frames)
    WRAPPED("_ZN5hyrax9inputs_ofERKNS_8ScenarioEl");
std::vector<Input> altered_inputs(const Scenario& scenario, std::int64_t frames) {
  std::vector<Input> inputs = original_inputs(scenario, frames);
  for (Input& input : inputs) input.frame = late(input.frame, step_count(scenario), &input == &inputs.back());
  return inputs;
}

}  // namespace hyrax
