#include "tools/store/golden_file.h"

#include <algorithm>
#include <cerrno>
#include <new>

#include "tools/store/attribute_list.h"
#include "tools/store/contact_table.h"
#include "tools/store/row_table.h"
#include "tools/store/trajectory_file.h"
#include "tools/store/trial_reading.h"

namespace hyrax {
namespace {

constexpr std::uint64_t kBytesOfMany = 64 << 20;  // Of a file with too many contacts to hold.

// The state at a block's first row stands in /trajectory; here is what else a replay needs.
struct KeyframeColumn {
  const char* name;
  double (*get)(const Keyframe&);
  void (*set)(Keyframe&, double);
};

// -1 for what no such count can be, as in a damaged file.
std::int64_t whole(double value, double max) {
  return value >= 0.0 && value <= max ? static_cast<std::int64_t>(value) : -1;
}

template <auto Member, auto Field>
constexpr KeyframeColumn size_column(const char* name) {
  return {name, [](const Keyframe& keyframe) { return static_cast<double>(keyframe.*Member.*Field); },
          [](Keyframe& keyframe, double value) {
            keyframe.*Member.*Field = static_cast<std::int32_t>(whole(value, 1e6));
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
     [](Keyframe& k, double v) { k.timeline.frames = whole(v, 1e12); }},
    size_column<&Keyframe::window, &Size::width_px>("window_width"),
    size_column<&Keyframe::window, &Size::height_px>("window_height"),
    size_column<&Keyframe::sprite, &Size::width_px>("sprite_width"),
    size_column<&Keyframe::sprite, &Size::height_px>("sprite_height"),
    {"is_held", [](const Keyframe& k) { return k.is_held ? 1.0 : 0.0; },
     [](Keyframe& k, double v) { k.is_held = v != 0.0; }},
};

bool write_whole(hid_t group, const char* name, hid_t type, hid_t memory_type, std::vector<hsize_t> shape,
                 const void* data) {
  const h5::Handle dataset = h5::create_dataset(group, name, type, std::move(shape));
  return dataset.is_open() && H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0;
}

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
  bool is_written =
      write_whole(group, "count", H5T_STD_I64LE, H5T_NATIVE_INT64, {counts.size()}, counts.data()) &&
      write_whole(group, "digest", H5T_STD_U8LE, H5T_NATIVE_UINT8, {digests.size() * sizeof(Digest)},
                  digests.data()) &&
      write_whole(group, "row_check", H5T_STD_U8LE, H5T_NATIVE_UINT8, {checks.size() * sizeof(RowCheck)},
                  checks.data());
  for (const KeyframeColumn& column : kKeyframeColumns) {
    std::vector<double> values;
    for (const StoredBlock& block : blocks) values.push_back(column.get(block.keyframe));
    is_written = is_written && write_whole(group, column.name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE,
                                           {values.size()}, values.data());
  }
  return is_written && h5::share_axis(group, "count");
}

// A long run's rows are those at which its blocks begin, and the last one.
Columns kept_rows(const StoredRun& run) {
  if (run.blocks.empty()) return run.rows;
  Columns rows;
  for (const StoredBlock& block : run.blocks) rows.append(block.keyframe.row);
  if (rows.step.back() != run.final.step) rows.append(run.final);
  return rows;
}

bool write_contacts(hid_t file, const StoredRun& run) {
  const h5::Handle group = h5::create_group(file, "contacts");
  ContactTable table(group);
  bool is_written = true;
  run.each_contact([&](const Contact& contact) { is_written = table.append(contact) && is_written; });
  is_written = table.finish() && is_written;
  h5::write_attribute(group, "total", run.contacts_total);
  return is_written;
}

bool write_rows(hid_t file, const Columns& rows) {
  const h5::Handle group = h5::create_group(file, "trajectory");
  RowTable table(group, static_cast<std::int64_t>(rows.size()));
  return table.append(rows) && table.finish();
}

bool write_run(hid_t file, const StoredRun& run) {
  return write_rows(file, kept_rows(run)) && write_contacts(file, run) &&
         (run.blocks.empty() || write_blocks(file, run.blocks)) &&
         write_head(file, {run.scenario, run.steps, run.physics, run.state_hash}, run.inputs);
}

// The attributes and names of objects do not depend on how many contacts there are.
std::vector<std::string> words_of(StoredRun run) {
  run.contacts.clear();
  const h5::Handle file = h5::create_file_in_memory();
  if (!file.is_open() || !write_run(file, run)) throw std::bad_alloc();
  return attribute_list(file);
}

void read_blocks(const TrajectoryFile& file, StoredRun& run) {
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
      file.refuse("/blocks: do not follow upon each other");
    next_row += block.count * static_cast<std::int64_t>(kBlockRows);
    const auto block_rows =
        static_cast<std::size_t>(std::min<std::int64_t>(kBlockRows, run.steps + 1 - block.keyframe.row.step));
    for (; index < kCheckedBlocksMax && block.checks.size() < block_rows; next_check += sizeof(RowCheck)) {
      if (next_check + sizeof(RowCheck) > checks.size()) file.refuse("/blocks/row_check: is too short");
      std::copy_n(checks.begin() + static_cast<std::ptrdiff_t>(next_check), sizeof(RowCheck),
                  block.checks.emplace_back().begin());
    }
    run.blocks.push_back(std::move(block));
  }
  if (next_check != checks.size()) file.refuse("/blocks/row_check: is too long");
  for (const KeyframeColumn& described : kKeyframeColumns) {
    const NumberColumn column =
        file.column(std::string("/blocks/") + described.name, H5T_FLOAT, sizeof(double));
    if (column.length() != blocks) file.refuse("/blocks: its datasets differ in length");
    const auto values = column.read<double>(H5T_NATIVE_DOUBLE, 0, blocks);
    for (std::size_t index = 0; index < values.size(); ++index) {
      described.set(run.blocks[index].keyframe, values[index]);
      if (!same_bits(described.get(run.blocks[index].keyframe), values[index]))
        file.refuse(std::string("/blocks/") + described.name + ": holds " + std::to_string(values[index]) +
                    ", which no replay comes to");
    }
  }
  if (run.steps >= next_row || run.steps < next_row - static_cast<std::int64_t>(kBlockRows))
    file.refuse("/blocks/count: its blocks do not end with the run's last row");
  const bool ends_with_a_block = run.blocks.back().keyframe.row.step == run.steps;
  if (file.row_count() != blocks + (ends_with_a_block ? 0 : 1) || rows.step.back() != run.steps)
    file.refuse("/trajectory: must hold the row at which each block begins, and the last one");
  run.final = rows.row(rows.size() - 1);
}

StoredRun read_run(const TrajectoryFile& file) {
  StoredRun run;
  run.scenario = file.head().scenario;
  run.physics = file.head().physics;
  run.steps = file.head().steps;
  run.state_hash = file.head().state_hash;
  run.contacts = file.contacts();
  run.contacts_total = file.contacts_total();
  run.inputs = file.inputs();
  if (file.has("blocks")) {
    read_blocks(file, run);
    return run;
  }
  if (file.row_count() != run.steps + 1)
    file.refuse("holds " + std::to_string(file.row_count()) + " rows of " + std::to_string(run.steps + 1) +
                " and no blocks; it was not written by bless");
  run.rows = file.rows(0, file.row_count());
  for (std::size_t row = 0; row < run.rows.size(); ++row)
    if (run.rows.step[row] != static_cast<std::int64_t>(row))
      file.refuse("/trajectory/step: must count 0, 1, 2, ..., has " + std::to_string(run.rows.step[row]) +
                  " at row " + std::to_string(row));
  run.final = run.rows.row(run.rows.size() - 1);
  return run;
}

}  // namespace

void write_golden(const AtomicFile& target, const std::string& path, const StoredRun& run) {
  const bool has_many_contacts = static_cast<bool>(run.replay_contacts);
  h5::Handle file = h5::create_file(target.part_path(), has_many_contacts ? kBytesOfMany : 0);
  const bool is_written = file.is_open() && write_run(file, run) && file.close() >= 0;
  if (!is_written) fail_to_write(path, errno == 0 ? EIO : errno);
}

StoredRun read_golden(const std::string& path) {
  return read_run(
      TrajectoryFile::open(path, [](const TrajectoryFile& file) { static_cast<void>(read_run(file)); }));
}

std::optional<std::string> golden_words_fault(const std::string& path) {
  const auto list = [&] { return attribute_list(h5::open_file(path)); };
  const std::vector<std::string> wanted = words_of(read_golden(path));
  read_on_trial(path, [&] { static_cast<void>(list()); });
  // Files of earlier versions describe less; what they say must be the same.
  auto next = wanted.begin();
  for (const std::string& line : list()) {
    next = std::find(next, wanted.end(), line);
    if (next == wanted.end()) return path + ": holds " + line + ", which bless does not write";
    ++next;
  }
  return std::nullopt;
}

}  // namespace hyrax
