#include "tools/store/golden_file.h"

#include <algorithm>
#include <cerrno>
#include <new>

#include "sim/trajectory/physics_model.h"
#include "tools/store/golden_blocks.h"
#include "tools/store/isolated_read.h"
#include "tools/store/trajectory_file.h"
#include "tools/store/trajectory_parts.h"

namespace hyrax {
namespace {

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
  return table.append(rows) && table.finish();
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
