// Plays scenario files and prints every row and contact, doubles as the hexadecimal digits of their
// bits, for another program to compare with.
#include <cinttypes>
#include <cstdio>
#include <exception>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "tests/unit/sim/replay/trace_sink.h"
#include "tools/files/scenario_reader.h"

namespace {

void print(std::initializer_list<double> values) {
  for (const double value : values) std::printf(" %016" PRIx64, std::bit_cast<std::uint64_t>(value));
}

void print(const hyrax::Row& row) {
  std::printf("row %" PRId64, row.step);
  print({row.t_s, row.dt_s, row.x_px, row.y_px, row.vx_px_per_s, row.vy_px_per_s});
  std::printf(" %d\n", row.contact);
}

void print(const hyrax::Contact& contact) {
  std::printf("contact %" PRId64 " %" PRId64 " %d", contact.step, contact.last_step,
              static_cast<int>(contact.wall));
  print({contact.t_s, contact.x_px, contact.y_px, contact.vx_before_px_per_s, contact.vy_before_px_per_s,
         contact.vx_after_px_per_s, contact.vy_after_px_per_s, contact.overshoot_px});
  std::printf("\n");
}

}  // namespace

int main(int argument_count, char** arguments) try {
  for (int argument = 1; argument < argument_count; ++argument) {
    const hyrax::Scenario scenario = hyrax::load_scenario(arguments[argument]);
    hyrax::TraceSink trace;
    const hyrax::RunSummary summary = hyrax::replay(hyrax::shipped_core(), scenario, trace);
    std::printf("scenario %s\n", arguments[argument]);
    for (const hyrax::Row& row : trace.rows()) print(row);
    for (const hyrax::Contact& contact : trace.contacts()) print(contact);
    std::printf("state_hash %s\n", hyrax::hex(summary.state_hash).c_str());
  }
} catch (const std::exception& failure) {
  std::fprintf(stderr, "%s\n", failure.what());
  return 2;
}
