#include "tools/store/trajectory_parts.h"

#include <cassert>

#include "tools/files/scenario_writer.h"
#include "tools/store/build_facts.h"
#include "tools/store/trajectory_format.h"

namespace hyrax {
namespace {

std::string source_name(Wall wall) { return "source_" + std::string(name_of(wall)); }

std::vector<Column> row_columns() {
  std::vector<Column> columns = {{"step", "", "", std::vector<std::int64_t>()}};
  for (const RowColumn& each : kRowColumns) columns.push_back({each.name, "", "", std::vector<double>()});
  columns.push_back({"contact", "", "", Codes()});
  return columns;
}

// Gives the columns the vectors of the rows, or gives them back.
void swap_values(std::vector<Column>& columns, Columns& rows) {
  values_as<std::vector<std::int64_t>>(columns.front()).swap(rows.step);
  for (std::size_t each = 0; each < kRowColumns.size(); ++each)
    values_as<std::vector<double>>(columns[each + 1]).swap(rows.*kRowColumns[each].also);
  values_as<Codes>(columns.back()).codes.swap(rows.contact);
}

// The meaning and unit of a and b depend on the kind.
bool write_inputs(hid_t file, const std::vector<InputRecord>& inputs) {
  const ColumnOf<InputRecord> described[] = {
      {"frame", "", "frame to which the input was applied; it makes row frame + 1", &InputRecord::frame},
      {"kind", "", "kind of the input",
       ColumnOf<InputRecord>::Code{[](const InputRecord& input) { return input.kind; },
                                   {input_kind_names()}}},
      {"a", "", "vx of a fling or release, x of a place, width of a resize, dt of a hitch, or 0 (unused)",
       &InputRecord::a},
      {"b", "", "vy of a fling or release, y of a place, height of a resize, or 0 (unused)", &InputRecord::b},
  };
  const h5::Handle group = h5::create_group(file, "events");
  const std::vector<Column> columns = columns_of(described, inputs);
  h5::ColumnWriter writer(group, columns, inputs.size());
  if (!writer.append(columns)) return false;
  h5::write_attribute(writer.datasets()[2], "units_by_kind", "px/s px 1 px px s 1 px/s");
  h5::write_attribute(writer.datasets()[3], "units_by_kind", "px/s px 1 px px 1 1 px/s");
  return writer.finish(columns, "frame");
}

}  // namespace

RowTable::RowTable(hid_t group, std::int64_t rows)
    : group_(group),
      rows_(rows),
      columns_(row_columns()),
      writer_(group, columns_, static_cast<hsize_t>(rows)) {}

bool RowTable::append(const Row& row) {
  pending_.append(row);
  return pending_.size() < kBatch || write();
}

// Units, names and the time axis, as xarray (dimension scales) and silx (NXdata) expect them.
bool RowTable::finish() {
  const bool is_written = write();
  const std::vector<h5::Handle>& datasets = writer_.datasets();
  for (std::size_t column = 0; column < kRowColumns.size(); ++column) {
    h5::write_attribute(datasets[column + 1], "units", kRowColumns[column].unit);
    h5::write_attribute(datasets[column + 1], "long_name", kRowColumns[column].long_name);
  }
  h5::write_attribute(datasets.front(), "long_name", "row number");
  h5::write_attribute(
      datasets.back(), "long_name",
      "clamps in the step that made the row: 1 left, 2 right, 4 top, 8 ground, 16 put to rest");
  h5::write_flags(datasets.back(), "flag_masks", kContactFlags, kContactFlagNames);
  h5::write_attribute(group_, "NX_class", "NXdata");
  h5::write_attribute(group_, "signal", "y");
  h5::write_attribute(group_, "axes", "t");
  return h5::share_axis(group_, "t") && is_written && written_ == rows_;
}

bool RowTable::write() {
  written_ += static_cast<std::int64_t>(pending_.size());
  swap_values(columns_, pending_);
  const bool is_written = writer_.append(columns_);
  swap_values(columns_, pending_);
  pending_.clear();
  return is_written;
}

bool ContactTable::append(const Contact& contact) {
  batch_.push_back(contact);
  return batch_.size() < kBatch || flush();
}

bool ContactTable::set_last_step(std::int64_t index, std::int64_t last_step) {
  assert(index >= 0 && index < flushed_ + static_cast<std::int64_t>(batch_.size()));
  if (index >= flushed_) {
    batch_[static_cast<std::size_t>(index - flushed_)].last_step = last_step;
    return true;
  }
  return writer_->set(1, static_cast<hsize_t>(index), last_step);
}

bool ContactTable::finish() {
  set_columns(columns_, kContactColumns, batch_);
  if (!writer_) writer_.emplace(group_, columns_, batch_.size());
  return writer_->append(columns_) && writer_->finish(columns_, "step");
}

bool ContactTable::flush() {
  set_columns(columns_, kContactColumns, batch_);
  if (!writer_) writer_.emplace(group_, columns_, 0, kBatch);
  flushed_ += static_cast<std::int64_t>(batch_.size());
  batch_.clear();
  return writer_->append(columns_);
}

void write_sources(hid_t contacts, std::uint8_t walls_of_rows) {
  if (walls_of_rows == 0) return;
  for (const Wall wall : kWalls)
    h5::write_attribute(contacts, source_name(wall).c_str(), touches(walls_of_rows, wall) ? "rows" : "step");
}

std::uint8_t read_sources(hid_t contacts) {
  int walls = 0;
  for (const Wall wall : kWalls)
    if (h5::read_text_attribute(contacts, source_name(wall).c_str()) == "rows")
      walls |= static_cast<int>(wall);
  return static_cast<std::uint8_t>(walls);
}

void write_root(hid_t file, const RunHead& head, const std::string& name, const std::string& scenario) {
  h5::write_attribute(file, "format", kTrajectoryFormat);
  h5::write_attribute(file, "name", name);
  h5::write_attribute(file, "scenario", scenario);
  h5::write_attribute(file, "steps", head.steps);
  h5::write_attribute(file, "physics", head.physics);
  h5::write_attribute(file, "state_hash", head.state_hash);
  if (head.constants) h5::write_attribute(file, "constants", numbers_of(*head.constants));
  write_core_name(file, head.core);
  h5::write_attribute(file, "NX_class", "NXroot");
  h5::write_attribute(file, "default", "trajectory");
  write_provenance(file);
}

bool write_head(hid_t file, const FileHead& head, const std::vector<Input>& inputs) {
  write_root(file, head, head.scenario.name, to_text(to_json(head.scenario)));
  std::vector<InputRecord> records;
  for (const Input& input : inputs) records.push_back(record_of(input));
  return write_inputs(file, records);
}

}  // namespace hyrax
