// Reads golden files and their attributes, and compares with what it read: the input is an HDF5 file.
#include "sim/core/shipped_core.h"
#include "sim/scenario/frame_clock.h"
#include "tests/robustness/fuzz/fuzz_target.h"
#include "tests/robustness/fuzz/input_file.h"
#include "tools/app/play/play.h"
#include "tools/store/golden_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hyrax;
  const InputFile file(text_of(data, size));
  StoredRun run;
  if (!accepts([&] { run = read_golden(file.path()); })) return 0;
  hold(run.rows.size() != 0 || !run.blocks.empty(), "a golden file holds rows or blocks");
  constexpr std::int64_t kStepsPlayed = 20'000;
  if (step_count(run.scenario) <= kStepsPlayed)
    static_cast<void>(compare_with(shipped_core(), run, run.scenario));
  static_cast<void>(accepts([&] { static_cast<void>(attribute_difference(file.path(), run, false)); }));
  return 0;
}
