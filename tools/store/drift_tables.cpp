#include "tools/store/drift_tables.h"

#include <hdf5_hl.h>

#include <limits>

#include "tools/store/trajectory_writer.h"

namespace hyrax {
namespace {

// A group with the columns; not open if it could not be written.
h5::Handle write_group(hid_t parent, const char* name, const std::vector<Column>& columns, const char* axis) {
  h5::Handle group = h5::create_group(parent, name);
  return h5::write_columns(group, columns, axis) ? std::move(group) : h5::Handle();
}

// One row; where there is no exact fling, the attribute that says why.
bool write_whole(hid_t drift, const WholeOutcome& whole) {
  if (whole.run) return write_group(drift, "whole", whole_table(whole).columns, "max_step").is_open();
  h5::write_attribute(drift, "whole_why", whole.why_not);
  return true;
}

constexpr std::size_t kBatch = 65536;

// As xarray (dimension scales) and silx (NXdata) expect the time axis.
bool describe(hid_t file, hid_t group, h5::ColumnWriter& rows, const std::vector<Column>& columns,
              const char* signal) {
  if (!rows.finish(columns, nullptr)) return false;
  const h5::Handle time(H5Dopen2(file, "/trajectory/t", H5P_DEFAULT), H5Dclose);
  for (const h5::Handle& dataset : rows.datasets())
    if (H5DSattach_scale(dataset, time, 0) < 0) return false;
  rows.close();
  h5::write_attribute(group, "NX_class", "NXdata");
  h5::write_attribute(group, "signal", signal);
  h5::write_attribute(group, "axes", "t");
  return H5Lcreate_hard(file, "/trajectory/t", group, "t", H5P_DEFAULT, H5P_DEFAULT) >= 0 &&
         H5Lcreate_hard(file, "/trajectory/step", group, "step", H5P_DEFAULT, H5P_DEFAULT) >= 0;
}

RowErrors no_errors() {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  return {0, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
}

}  // namespace

DriftRowTable::DriftRowTable(hid_t reference, hid_t drift, std::int64_t steps, std::int64_t rows_every)
    : reference_(reference),
      drift_(drift),
      steps_(steps),
      rows_every_(rows_every),
      rows_(TrajectoryWriter::row_count(steps, rows_every)),
      reference_columns_(columns_of(kReferenceRowColumns, pending_)),
      drift_columns_(columns_of(kDriftRowColumns, pending_)),
      of_reference_(reference, reference_columns_, static_cast<hsize_t>(rows_)),
      of_drift_(drift, drift_columns_, static_cast<hsize_t>(rows_)) {}

void DriftRowTable::row(const RowErrors& row) {
  const bool is_due = row.step % rows_every_ == 0;
  if (!is_due && row.step != steps_) return;
  const std::int64_t index = is_due ? row.step / rows_every_ : rows_ - 1;
  if (index < next_) return;  // It has the errors of the arc that it ended.
  fill_up_to(index);
  put(row);
}

bool DriftRowTable::finish(hid_t file) {
  fill_up_to(rows_);
  return flush() && describe(file, reference_, of_reference_, reference_columns_, "y") &&
         describe(file, drift_, of_drift_, drift_columns_, "truncation");
}

void DriftRowTable::put(const RowErrors& row) {
  pending_.push_back(row);
  ++next_;
  if (pending_.size() == kBatch) static_cast<void>(flush());
}

void DriftRowTable::fill_up_to(std::int64_t index) {
  while (next_ < index) put(no_errors());
}

bool DriftRowTable::flush() {
  set_columns(reference_columns_, kReferenceRowColumns, pending_);
  set_columns(drift_columns_, kDriftRowColumns, pending_);
  pending_.clear();
  return of_reference_.append(reference_columns_) && of_drift_.append(drift_columns_);
}

bool write_measured_arcs(hid_t reference, hid_t drift, const DriftRun& run) {
  h5::write_attribute(reference, "solution",
                      "closed form of v' = g - k v with k = -ln(AIR_DRAG) / dt of each frame");
  h5::write_attribute(reference, "checked_by", run.checked_by.empty() ? "nothing" : run.checked_by);
  h5::write_attribute(drift, "differing_steps", run.summary.differing_steps);
  h5::write_attribute(drift, "reference_faults", run.summary.reference_faults);

  std::vector<Column> solutions = columns_of(std::span(kArcColumns).first<2>(), run.arcs);
  for (Column& column : columns_of(kReferenceArcColumns, run.arcs)) solutions.push_back(std::move(column));
  const h5::Handle arcs = write_group(drift, "arcs", columns_of(kArcColumns, run.arcs), "first_step");
  const h5::Handle contacts =
      write_group(drift, "contacts", columns_of(kImpactColumns, run.contacts), "step");
  if (!arcs.is_open() || !contacts.is_open()) return false;
  h5::write_attribute(arcs, "total", run.summary.arcs);
  h5::write_attribute(arcs, "skipped", run.summary.skipped_arcs);
  h5::write_attribute(contacts, "total", run.summary.contacts);
  return write_group(reference, "arcs", solutions, "first_step").is_open() && write_whole(drift, run.whole);
}

}  // namespace hyrax
