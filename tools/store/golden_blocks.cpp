#include "tools/store/golden_blocks.h"

#include <algorithm>
#include <cassert>

namespace hyrax {
namespace {

// What a replay from a block needs besides the row that it begins with.
struct KeyframeColumn {
  const char* name;
  double (*get)(const Keyframe&);
  void (*set)(Keyframe&, double);
};

// -1 if it cannot be a count, as in a damaged file.
std::int64_t count_of(double value, double max) {
  return value >= 0.0 && value <= max ? static_cast<std::int64_t>(value) : -1;
}

template <auto Member, auto Field>
constexpr KeyframeColumn size_column(const char* name) {
  return {name, [](const Keyframe& keyframe) { return static_cast<double>(keyframe.*Member.*Field); },
          [](Keyframe& keyframe, double value) {
            keyframe.*Member.*Field = static_cast<std::int32_t>(count_of(value, 1e6));
          }};
}

constexpr KeyframeColumn kKeyframeColumns[] = {
    {"time_base", [](const Keyframe& k) { return k.timeline.base_s; },
     [](Keyframe& k, double v) { k.timeline.base_s = v; }},
    {"time_comp", [](const Keyframe& k) { return k.timeline.comp_s; },
     [](Keyframe& k, double v) { k.timeline.comp_s = v; }},
    {"time_dt", [](const Keyframe& k) { return k.timeline.dt_s; },
     [](Keyframe& k, double v) { k.timeline.dt_s = v; }},
    {"time_frames", [](const Keyframe& k) { return static_cast<double>(k.timeline.frames); },
     [](Keyframe& k, double v) { k.timeline.frames = count_of(v, 1e12); }},
    size_column<&Keyframe::window, &Size::width_px>("window_width"),
    size_column<&Keyframe::window, &Size::height_px>("window_height"),
    size_column<&Keyframe::sprite, &Size::width_px>("sprite_width"),
    size_column<&Keyframe::sprite, &Size::height_px>("sprite_height"),
    {"is_held", [](const Keyframe& k) { return k.is_held ? 1.0 : 0.0; },
     [](Keyframe& k, double v) { k.is_held = v != 0.0; }},
};

void read_keyframes(const TrajectoryFile& file, StoredRun& run) {
  const auto blocks = static_cast<std::int64_t>(run.blocks.size());
  for (const KeyframeColumn& described : kKeyframeColumns) {
    const std::string place = std::string("/blocks/") + described.name;
    const NumberColumn column = file.column(place, H5T_FLOAT, sizeof(double));
    if (column.length() != blocks) file.refuse("/blocks: its datasets differ in length");
    const auto values = column.read<double>(H5T_NATIVE_DOUBLE, 0, blocks);
    for (std::size_t index = 0; index < values.size(); ++index) {
      described.set(run.blocks[index].keyframe, values[index]);
      if (!same_bits(described.get(run.blocks[index].keyframe), values[index]))
        file.refuse(place + ": not a state of a replay (found " + std::to_string(values[index]) + ")");
    }
  }
}

// Takes the row checks of a block from `checks`, of which `next` were taken before.
void read_checks(const TrajectoryFile& file, const std::vector<std::uint8_t>& checks, std::int64_t steps,
                 StoredBlock& block, std::size_t& next) {
  const auto rows =
      static_cast<std::size_t>(std::min<std::int64_t>(kBlockRows, steps + 1 - block.keyframe.row.step));
  for (; block.checks.size() < rows; next += sizeof(RowCheck)) {
    if (next + sizeof(RowCheck) > checks.size()) file.refuse("/blocks/row_check: is too short");
    std::copy_n(checks.begin() + static_cast<std::ptrdiff_t>(next), sizeof(RowCheck),
                block.checks.emplace_back().begin());
  }
}

}  // namespace

bool write_blocks(hid_t file, const std::vector<StoredBlock>& blocks) {
  const h5::Handle group = h5::create_group(file, "blocks");
  std::vector<std::int64_t> counts;
  std::vector<Digest> digests;
  std::vector<RowCheck> checks;
  for (const StoredBlock& block : blocks) {
    counts.push_back(block.count);
    digests.push_back(block.digest);
    checks.insert(checks.end(), block.checks.begin(), block.checks.end());
  }
  const auto write = [&](const char* name, hid_t type, hid_t memory_type, std::size_t length,
                         const void* data) {
    return h5::write_dataset(group, name, type, memory_type, length, data).is_open();
  };
  bool is_written =
      write("count", H5T_STD_I64LE, H5T_NATIVE_INT64, counts.size(), counts.data()) &&
      write("digest", H5T_STD_U8LE, H5T_NATIVE_UINT8, digests.size() * sizeof(Digest), digests.data()) &&
      write("row_check", H5T_STD_U8LE, H5T_NATIVE_UINT8, checks.size() * sizeof(RowCheck), checks.data());
  for (const KeyframeColumn& column : kKeyframeColumns) {
    std::vector<double> values;
    for (const StoredBlock& block : blocks) values.push_back(column.get(block.keyframe));
    is_written =
        is_written && write(column.name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.size(), values.data());
  }
  return is_written && h5::share_axis(group, "count");
}

void read_blocks(const TrajectoryFile& file, StoredRun& run) {
  assert(file.has("blocks"));
  const NumberColumn count = file.column("/blocks/count", H5T_INTEGER, sizeof(std::int64_t));
  const NumberColumn digest = file.column("/blocks/digest", H5T_INTEGER, 1);
  const NumberColumn check = file.column("/blocks/row_check", H5T_INTEGER, 1);
  const std::int64_t blocks = count.length();
  if (blocks == 0 || blocks > file.row_count() ||
      digest.length() != blocks * static_cast<std::int64_t>(sizeof(Digest)))
    file.refuse("/blocks: its datasets differ in length");
  const auto counts = count.read<std::int64_t>(H5T_NATIVE_INT64, 0, blocks);
  const auto digests = digest.read<std::uint8_t>(H5T_NATIVE_UINT8, 0, digest.length());
  const auto checks = check.read<std::uint8_t>(H5T_NATIVE_UINT8, 0, check.length());
  const Columns rows = file.rows(0, file.row_count());
  std::size_t next_check = 0;
  std::int64_t next_row = 0;
  for (std::size_t index = 0; index < counts.size(); ++index) {
    StoredBlock block;
    block.count = counts[index];
    std::copy_n(digests.begin() + static_cast<std::ptrdiff_t>(index * sizeof(Digest)), sizeof(Digest),
                block.digest.begin());
    block.keyframe.row = rows.row(index);
    if (block.count < 1 || block.count > kStepsMax || block.keyframe.row.step != next_row ||
        next_row > run.steps)
      file.refuse("/blocks: are not consecutive");
    next_row += block.count * static_cast<std::int64_t>(kBlockRows);
    if (index < kCheckedBlocksMax) read_checks(file, checks, run.steps, block, next_check);
    run.blocks.push_back(std::move(block));
  }
  if (next_check != checks.size()) file.refuse("/blocks/row_check: is too long");
  read_keyframes(file, run);
  if (run.steps >= next_row || run.steps < next_row - static_cast<std::int64_t>(kBlockRows))
    file.refuse("/blocks/count: its blocks do not end with the run's last row");
  const bool ends_with_a_block = run.blocks.back().keyframe.row.step == run.steps;
  if (file.row_count() != blocks + (ends_with_a_block ? 0 : 1) || rows.step.back() != run.steps)
    file.refuse("/trajectory: must hold the first row of each block, and the last row of the run");
  run.final = rows.row(rows.size() - 1);
}

}  // namespace hyrax
