#include "tools/store/golden_file.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <new>
#include <span>
#include <type_traits>

#include "sim/trajectory/physics_model.h"
#include "tools/files/failure.h"
#include "tools/store/isolated_read.h"
#include "tools/store/trajectory_file.h"
#include "tools/store/trajectory_parts.h"

namespace hyrax {
namespace {

// The number that a value in a file stands for. Of a damaged file it may be another one.
template <class Number>
Number number_of(double value) {
  if constexpr (std::is_same_v<Number, double>) return value;
  constexpr double kMax = std::is_same_v<Number, std::int64_t> ? 1e12 : 1e6;  // Frames; px.
  return static_cast<Number>(value >= 0.0 && value <= kMax ? value : 0.0);
}

void read_keyframes(const TrajectoryFile& file, std::vector<StoredBlock>& blocks) {
  std::vector<std::vector<double>> columns;
  visit_numbers(blocks.front().keyframe, [&](const char* name, const auto&) {
    columns.push_back(file.column<double>(std::string("/blocks/") + name));
    if (columns.back().size() != blocks.size()) file.refuse("/blocks: its datasets differ in length");
  });
  for (std::size_t index = 0; index < blocks.size(); ++index) {
    auto column = columns.begin();
    visit_numbers(blocks[index].keyframe, [&](const char* name, auto& number) {
      const double value = (*column++)[index];
      number = number_of<std::decay_t<decltype(number)>>(value);
      if (!same_bits(static_cast<double>(number), value))
        file.refuse(std::string("/blocks/") + name + ": not a state of a replay (found " +
                    std::to_string(value) + ")");
    });
  }
}

// Takes the row checks of a block off the front of `checks`.
void take_checks(const TrajectoryFile& file, std::int64_t steps, StoredBlock& block,
                 std::span<const std::uint8_t>& checks) {
  const auto rows =
      static_cast<std::size_t>(std::min<std::int64_t>(kBlockRows, steps + 1 - block.keyframe.row.step));
  if (checks.size() < rows * sizeof(RowCheck)) file.refuse("/blocks/row_check: is too short");
  block.checks.resize(rows);
  std::memcpy(block.checks.data(), checks.data(), rows * sizeof(RowCheck));
  checks = checks.subspan(rows * sizeof(RowCheck));
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
  const std::size_t first_number = columns.size();
  for (const StoredBlock& block : blocks) {
    std::size_t column = first_number;
    visit_numbers(block.keyframe, [&](const char* name, const auto& number) {
      if (column == columns.size()) columns.push_back({.name = name, .values = std::vector<double>()});
      std::get<std::vector<double>>(columns[column++].values).push_back(static_cast<double>(number));
    });
  }
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
  const auto counts = file.column<std::int64_t>("/blocks/count");
  const auto digests = file.column<std::uint8_t>("/blocks/digest");
  const auto all_checks = file.column<std::uint8_t>("/blocks/row_check");
  const auto blocks = static_cast<std::int64_t>(counts.size());
  if (blocks == 0 || blocks > file.row_count() || digests.size() != counts.size() * sizeof(Digest))
    file.refuse("/blocks: its datasets differ in length");
  const Columns rows = file.rows(0, file.row_count());
  std::span<const std::uint8_t> checks = all_checks;
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
    if (index < kCheckedBlocksMax) take_checks(file, run.steps, block, checks);
    run.blocks.push_back(std::move(block));
  }
  if (!checks.empty()) file.refuse("/blocks/row_check: is too long");
  read_keyframes(file, run.blocks);
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
  write_sources(group, run.walls_of_rows);
  return is_written;
}

bool write_rows(hid_t file, const Columns& rows) {
  const h5::Handle group = h5::create_group(file, "trajectory");
  RowTable table(group, static_cast<std::int64_t>(rows.size()));
  bool is_written = true;
  for (std::size_t row = 0; row < rows.size(); ++row) is_written = table.append(rows.row(row)) && is_written;
  return is_written && table.finish();
}

bool write_run(hid_t file, const StoredRun& run) {
  return write_rows(file, stored_rows(run)) && write_contacts(file, run) &&
         (run.blocks.empty() || write_blocks(file, run.blocks)) && write_head(file, run, run.inputs);
}

StoredRun read_run(const TrajectoryFile& file) {
  StoredRun run;
  static_cast<FileHead&>(run) = file.head();
  run.contacts = file.contacts();
  run.contacts_total = file.contacts_total();
  run.walls_of_rows = file.walls_of_rows();
  run.inputs = file.inputs();
  if (file.has("blocks")) {
    read_blocks(file, run);
    return run;
  }
  if (!file.holds_every_row())
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

struct AttributeLines {
  std::string path;
  std::vector<std::string> lines;
};

herr_t list_attribute(hid_t object, const char* name, const H5A_info_t*, void* list) {
  auto& [path, lines] = *static_cast<AttributeLines*>(list);
  if (path == "/" && std::string_view(name) == kCoreAttribute) return 0;
  lines.push_back(path + "@" + name + " = " + attribute_text(object, name));
  return 0;
}

herr_t list_object(hid_t file, const char* name, const H5O_info_t*, void* list) {
  auto& [path, lines] = *static_cast<AttributeLines*>(list);
  path = std::string("/") + (std::string_view(name) == "." ? "" : name);
  if (path == "/provenance") return 0;
  lines.push_back(path);
  return H5Aiterate_by_name(file, name, H5_INDEX_NAME, H5_ITER_INC, nullptr, list_attribute, list,
                            H5P_DEFAULT);
}

// A line for each object, "PATH", and for each of its attributes, "PATH@NAME = VALUE", in order of names.
// /provenance and the core's name are left out, as no comparison includes them. Lists are named without their
// values: references between objects, which are addresses in the file, and codes.
std::vector<std::string> attribute_list(hid_t file) {
  AttributeLines list;
  if (H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, list_object, &list, H5O_INFO_BASIC) < 0)
    list.lines.emplace_back("unreadable");
  return list.lines;
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

void write_golden(AtomicFile& target, const std::string& path, const StoredRun& run) {
  const bool has_many_contacts = static_cast<bool>(run.replay_contacts);
  h5::Handle file = h5::create_file(target.part_path(), has_many_contacts ? kBytesOfMany : 0);
  require_written(file.is_open() && write_run(file, run) && file.close() >= 0, path);
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
