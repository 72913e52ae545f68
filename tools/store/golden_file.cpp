#include "tools/store/golden_file.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <new>

#include "sim/trajectory/physics_model.h"
#include "tools/files/failure.h"
#include "tools/store/isolated_read.h"
#include "tools/store/trajectory_file.h"
#include "tools/store/trajectory_parts.h"

namespace hyrax {
namespace {

// What a replay from a block needs besides the row that it begins with.
struct KeyframeColumn {
  const char* name;
  double (*get)(const Keyframe&);
  void (*set)(Keyframe&, double);
};

// 0 if it cannot be a count, as in a damaged file: it then differs from the stored value, which is refused.
std::int64_t count_of(double value, double max) {
  return value >= 0.0 && value <= max ? static_cast<std::int64_t>(value) : 0;
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

// The state at each block's first row is in /trajectory. False if the file could not be written.
bool write_blocks(hid_t file, const std::vector<StoredBlock>& blocks) {
  const h5::Handle group = h5::create_group(file, "blocks");
  Codes digests, checks;
  for (const StoredBlock& block : blocks) {
    digests.codes.insert(digests.codes.end(), block.digest.begin(), block.digest.end());
    for (const RowCheck& check : block.checks)
      checks.codes.insert(checks.codes.end(), check.begin(), check.end());
  }
  std::vector<Column> columns = {column_of("count", "", "", blocks, &StoredBlock::count),
                                 {"digest", "", "", std::move(digests)},
                                 {"row_check", "", "", std::move(checks)}};
  for (const KeyframeColumn& column : kKeyframeColumns)
    columns.push_back(column_of(column.name, "", "", blocks,
                                [&](const StoredBlock& block) { return column.get(block.keyframe); }));
  return std::ranges::all_of(columns,  // Of different lengths.
                             [&](const Column& column) {
                               return h5::ColumnWriter(group, {column}, length(column)).append({column});
                             }) &&
         h5::share_axis(group, "count");
}

// Reads the blocks and the final row. REQUIRES: the file has /blocks; `run.steps` is set.
// ERRORS: Failure(bad_input) if the blocks do not cover the run.
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

constexpr std::uint64_t kBytesOfMany = 64 << 20;  // Expected of a file with too many contacts for memory.

// Of a long run the first row of each block, and the last row.
Columns stored_rows(const StoredRun& run) {
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
  return table.write(rows) && table.finish();
}

bool write_run(hid_t file, const StoredRun& run) {
  return write_rows(file, stored_rows(run)) && write_contacts(file, run) &&
         (run.blocks.empty() || write_blocks(file, run.blocks)) &&
         write_head(file, {run.scenario, run.steps, run.physics, run.state_hash, run.constants}, run.inputs);
}

StoredRun read_run(const TrajectoryFile& file) {
  StoredRun run;
  run.scenario = file.head().scenario;
  run.physics = file.head().physics;
  run.constants = file.head().constants;
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
    file.refuse("not written by bless: has no blocks, and " + std::to_string(file.row_count()) + " rows of " +
                std::to_string(run.steps + 1));
  run.rows = file.rows(0, file.row_count());
  for (std::size_t row = 0; row < run.rows.size(); ++row)
    if (run.rows.step[row] != static_cast<std::int64_t>(row))
      file.refuse("/trajectory/step: row " + std::to_string(row) + " is missing or out of order (found " +
                  std::to_string(run.rows.step[row]) + ")");
  run.final = run.rows.row(run.rows.size() - 1);
  return run;
}

std::string attribute_text(hid_t object, const char* name) {
  if (const auto text = h5::read_text_attribute(object, name)) return '"' + *text + '"';
  if (const auto number = h5::read_integer_attribute(object, name)) return std::to_string(*number);
  return "a list";
}

struct Listing {
  std::string path;
  std::vector<std::string> lines;
};

herr_t list_attribute(hid_t object, const char* name, const H5A_info_t*, void* listing) {
  auto& [path, lines] = *static_cast<Listing*>(listing);
  lines.push_back(path + "@" + name + " = " + attribute_text(object, name));
  return 0;
}

herr_t list_object(hid_t file, const char* name, const H5O_info_t*, void* listing) {
  auto& [path, lines] = *static_cast<Listing*>(listing);
  path = std::string("/") + (std::string_view(name) == "." ? "" : name);
  if (path == "/provenance") return 0;
  lines.push_back(path);
  return H5Aiterate_by_name(file, name, H5_INDEX_NAME, H5_ITER_INC, nullptr, list_attribute, listing,
                            H5P_DEFAULT);
}

// A line for each object, "PATH", and for each of its attributes, "PATH@NAME = VALUE", in order of names.
// /provenance is left out, as no comparison includes it. Lists are named without their values: references
// between objects, which are addresses in the file, and codes.
std::vector<std::string> attribute_list(hid_t file) {
  Listing listing;
  if (H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, list_object, &listing, H5O_INFO_BASIC) < 0)
    listing.lines.emplace_back("unreadable");
  return listing.lines;
}

std::vector<std::string> stored_attributes(const std::string& path) {
  read_isolated(path, [&] { static_cast<void>(attribute_list(h5::open_file(path))); });
  return attribute_list(h5::open_file(path));
}

// Objects and attributes are the same for any number of contacts.
std::vector<std::string> expected_attributes(StoredRun run) {
  run.contacts.clear();
  if (is_paper_model(run.physics) && !run.constants) run.constants.emplace();
  const h5::Handle file = h5::create_file_in_memory();
  if (!file.is_open() || !write_run(file, run)) throw std::bad_alloc();
  return attribute_list(file);
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

void read_goldens_ahead(const std::vector<std::string>& paths) {
  read_isolated_together(paths, [](const std::string& path) {
    static_cast<void>(read_golden(path));
    static_cast<void>(attribute_list(h5::open_file(path)));
  });
}

std::optional<std::string> attribute_difference(const std::string& path, const StoredRun& run,
                                                bool may_have_fewer) {
  const std::vector<std::string> expected = expected_attributes(run);
  const auto lacks = [&](const std::string& line) {
    return path + ": lacks " + line + ", which bless writes";
  };
  auto next = expected.begin();
  for (const std::string& line : stored_attributes(path)) {
    const auto found = std::find(next, expected.end(), line);
    if (found == expected.end()) return path + ": holds " + line + ", which bless does not write";
    if (found != next && !may_have_fewer) return lacks(*next);
    next = found + 1;
  }
  if (next != expected.end() && !may_have_fewer) return lacks(*next);
  return std::nullopt;
}

}  // namespace hyrax
