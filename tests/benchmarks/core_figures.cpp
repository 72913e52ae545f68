#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <limits>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "tests/benchmarks/figure.h"
#include "tests/benchmarks/naive_step.h"
#include "tools/store/trajectory_parts.h"

namespace hyrax::bench {
namespace {

constexpr int kRounds = 15;

std::vector<State> random_throws(std::size_t count) {
  std::vector<State> throws;
  for (std::size_t index = 0; index < count; ++index) throws.push_back(random_throw(index));
  return throws;
}

// The longest chain of dependent operations of a step in flight: one add, one multiply on vy.
double bare_recurrence(std::int64_t steps) {
  double vy = 1.0;
  const double gain = physics::GRAVITY * kDt_s;
  for (std::int64_t step = 0; step < steps; ++step) {
    vy = (vy + gain) * physics::AIR_DRAG;
    asm volatile("" : "+x"(vy));
  }
  return vy;
}

constexpr int kWide_px = 1'000'000;

void fly(std::int64_t flights, int steps) {
  for (std::int64_t flight = 0; flight < flights; ++flight) {
    physics body(1000.0, 1000.0, 10.0, -100.0);
    for (int step = 0; step < steps; ++step) body.update(kDt_s, kWide_px, kWide_px, 128, 128);
    keep(body);
  }
}

Figure flight_figure() {
  const auto timings =
      time_side_by_side({[] { keep(bare_recurrence(2'000'000)); }, [] { fly(1000, 2000); }}, kRounds);
  return ratio("one body in flight, part of the bound (add + multiply on vy)", timings[0], timings[1],
               Goal::at_least, 88.0, 100.0);
}

Figure fling_figure() {
  const std::vector<State> throws = random_throws(2000);
  const auto step = [&] {
    for (const State& start : throws) {
      physics body = body_at(start);
      for (int frame = 0; frame < 600; ++frame) body.update(kDt_s, 1920, 1080, 128, 128);
      keep(body);
    }
  };
  const auto timings = time_side_by_side({[&] { step_all_naively(throws, 600); }, step}, kRounds);
#ifdef __clang__
  constexpr double kGoal = 3.1;
#else
  constexpr double kGoal = 2.1;
#endif
  return ratio("random flings, times faster than naive", timings[0], timings[1], Goal::at_least, kGoal);
}

// vx of a fling on the floor ends at two units of the last place, with which some processors compute slowly.
Figure floor_figure() {
  const auto lie = [](double vx_px_per_s) {
    for (int fling = 0; fling < 100; ++fling) {
      physics body(700.0, 952.0, vx_px_per_s, 0.0);
      for (int step = 0; step < 1000; ++step) body.update(kDt_s, 1920, 1080, 128, 128);
      keep(body);
    }
  };
  const auto timings = time_side_by_side(
      {[&] { lie(2.0 * std::numeric_limits<double>::denorm_min()); }, [&] { lie(0.0); }}, kRounds);
  return ratio("a step on the floor with a subnormal vx, times one without", timings[0], timings[1],
               Goal::at_most, 100.0);
}

constexpr State kThrown{100.0, 100.0, 900.0, -1200.0};

Figure soak_figure() {
  constexpr std::int64_t kSteps = 10'000'000;
  const Scenario scenario = desktop_fling(kThrown, kSteps);
  const auto timings = time_side_by_side(
      {[&] { step_naively(kThrown, kSteps); }, [&] { keep(replay(shipped_core(), scenario)); }}, 5);
  return ratio("a soak of 1e7 steps, hash included, times faster than naive", timings[0], timings[1],
               Goal::at_least, 1000.0);
}

// The sprite is thrown again every ten seconds, so that it keeps flying and bouncing.
Figure hash_figure() {
  constexpr std::int64_t kThrows = 1000;
  Scenario scenario = desktop_fling(kThrown, 600 * kThrows);
  const std::vector<State> throws = random_throws(kThrows);
  for (std::int64_t index = 0; index < kThrows; ++index) {
    const State& start = throws[static_cast<std::size_t>(index)];
    scenario.events.push_back({600 * index, Place{{start.x_px, start.y_px}}});
    scenario.events.push_back({600 * index, Fling{velocity_of(start)}});
  }
  const auto timings =
      time_side_by_side({[&] { keep(replay(shipped_core(), scenario, {}, {.skips_repetition = false})); },
                         [&] { step_all_naively(throws, 600); }},
                        kRounds);
  return ratio("replay with the state hash of every row, of naive stepping", timings[0], timings[1],
               Goal::at_most, 140.0, 100.0);
}

constexpr std::size_t kBatchRows = RowTable::kBatch;
constexpr std::int64_t kBatches = 153;  // 1e7 rows.

Columns some_rows() {
  Columns rows;
  for (std::size_t row = 0; row < kBatchRows; ++row) {
    const auto number = static_cast<double>(row);
    rows.append(
        {static_cast<std::int64_t>(row), number * kDt_s, kDt_s, number, 0.5 * number, -number, number, 0});
  }
  return rows;
}

void write_plainly(const std::string& path, const Columns& rows) {
  const int file = open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
  bool is_written = true;
  const auto put = [&](const auto& column) {
    const auto bytes = column.size() * sizeof(column[0]);
    is_written = write(file, column.data(), bytes) == static_cast<ssize_t>(bytes) && is_written;
  };
  for (std::int64_t batch = 0; batch < kBatches; ++batch) {
    put(rows.step);
    for (const auto* column :
         {&rows.t_s, &rows.dt_s, &rows.x_px, &rows.y_px, &rows.vx_px_per_s, &rows.vy_px_per_s})
      put(*column);
    put(rows.contact);
  }
  close(file);
  keep(is_written);
}

void write_hdf5(const std::string& path, const Columns& rows) {
  h5::Handle file = h5::create_file(path, 1u << 30);
  const h5::Handle group = h5::create_group(file, "trajectory");
  RowTable table(group, kBatches * static_cast<std::int64_t>(kBatchRows));
  bool is_written = true;
  for (std::int64_t batch = 0; batch < kBatches; ++batch)
    for (std::size_t index = 0; index < rows.size(); ++index)
      is_written = table.append(rows.row(index)) && is_written;
  keep(table.finish() && is_written);
}

Figure writer_figure() {
  const std::string folder = "/dev/shm/hyrax-figures-" + std::to_string(getpid());
  std::filesystem::create_directory(folder);
  const Columns rows = some_rows();
  const auto timings = time_side_by_side({[&] {
                                            write_plainly(folder + "/plain", rows);
                                            std::filesystem::remove(folder + "/plain");
                                          },
                                          [&] {
                                            write_hdf5(folder + "/rows.h5", rows);
                                            std::filesystem::remove(folder + "/rows.h5");
                                          }},
                                         5);
  std::filesystem::remove_all(folder);
  return ratio("1e7 rows to HDF5 on tmpfs, part of the speed of write(2)", timings[0], timings[1],
               Goal::at_least, 90.0, 100.0);
}

}  // namespace

std::vector<Figure> core_figures() {
  return {flight_figure(), fling_figure(), floor_figure(), soak_figure(), hash_figure(), writer_figure()};
}

}  // namespace hyrax::bench
