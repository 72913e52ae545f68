#include "tools/store/drift_tables.h"

#include <hdf5_hl.h>

#include <limits>

#include "tools/store/trajectory_format.h"
#include "tools/store/trajectory_writer.h"

namespace hyrax {
namespace {

double or_nan(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

using Arc = const ArcErrors&;
constexpr std::array<DriftColumn<ArcErrors>, 3> kReferenceArcColumns = {{
    {"energy_largest", "px2/s2", "largest specific energy of the matched ODE",
     [](Arc a) { return a.energy_largest_px2_per_s2; }},
    {"coordinate_largest", "px", "largest coordinate of run and matched ODE",
     [](Arc a) { return a.coordinate_largest_px; }},
    {"gsl_vs_closed", "px", "largest distance between GSL's solution and the closed form",
     [](Arc a) { return or_nan(a.gsl_vs_closed_px); }},
}};

constexpr std::array<DriftColumn<ArcErrors>, 16> kDriftArcColumns = {{
    {"duration", "s", "time from the first row to the last", [](Arc a) { return a.duration_s; }},
    {"implementation", "px", "largest distance from the discrete closed form",
     [](Arc a) { return a.implementation_px; }},
    {"truncation", "px", "largest distance from the matched ODE", [](Arc a) { return a.truncation_px; }},
    {"model", "px", "largest distance from the ODE with the drag rate of 60 Hz",
     [](Arc a) { return a.model_px; }},
    {"implementation_speed", "px/s", "largest difference of velocity from the discrete closed form",
     [](Arc a) { return a.implementation_px_per_s; }},
    {"truncation_speed", "px/s", "largest difference of velocity from the matched ODE",
     [](Arc a) { return a.truncation_px_per_s; }},
    {"exact_law", "px", "largest distance from the flow of the step's exact law",
     [](Arc a) { return a.exact_law_px; }},
    {"exact_law_speed", "px/s", "largest difference of velocity from the flow of the step's exact law",
     [](Arc a) { return a.exact_law_px_per_s; }},
    {"energy_drift_rel_max", "1",
     "energy_drift_max / largest energy of the matched ODE, 1200 px2/s2 at least",
     [](Arc a) { return a.energy_drift_rel_max; }},
    {"energy_drift_rel_end", "1",
     "energy_drift_end / largest energy of the matched ODE, 1200 px2/s2 at least",
     [](Arc a) { return a.energy_drift_rel_end; }},
    {"energy_drift_slope_height", "px/s", "slope of a line fitted to the energy drift as height",
     [](Arc a) { return or_nan(a.energy_drift_slope_px_per_s); }},
    {"energy_drift_slope", "1/s", "slope of a line fitted to the relative energy drift",
     [](Arc a) { return or_nan(a.energy_drift_slope_per_s); }},
    {"energy_drift_max", "px2/s2", "largest energy drift in magnitude",
     [](Arc a) { return a.energy_drift_max_px2_per_s2; }},
    {"energy_drift_end", "px2/s2", "energy of the run minus the matched ODE's at the last row",
     [](Arc a) { return a.energy_drift_end_px2_per_s2; }},
    {"energy_by_gravity", "px2/s2", "part of energy_drift_end by the discretisation of gravity",
     [](Arc a) { return a.energy_parts.gravity; }},
    {"energy_by_drag", "px2/s2", "part of energy_drift_end by drag along another path",
     [](Arc a) { return a.energy_parts.drag; }},
}};

using Impact = const ImpactErrors&;
constexpr std::array<DriftColumn<ImpactErrors>, 9> kImpactColumns = {{
    {"time_error", "s", "time of the clamped row minus the true impact's",
     [](Impact c) { return or_nan(c.time_error_s); }},
    {"overshoot", "px", "how far past the wall the unclamped position was",
     [](Impact c) { return c.overshoot_px; }},
    {"energy_jump_rel", "1",
     "energy change over the clamped step / largest energy of the arc, 1200 px2/s2 at least",
     [](Impact c) { return c.energy_jump_rel; }},
    {"effective_restitution", "1", "normal speed after / normal speed at the true impact",
     [](Impact c) { return or_nan(c.effective_restitution); }},
    {"energy_by_flight", "px2/s2", "energy change of the clamped step by its flight without walls",
     [](Impact c) { return c.energy_parts.flight; }},
    {"energy_by_lift", "px2/s2", "by the lift out of the wall", [](Impact c) { return c.energy_parts.lift; }},
    {"energy_by_bounce", "px2/s2", "by restitution", [](Impact c) { return c.energy_parts.bounce; }},
    {"energy_by_friction", "px2/s2", "by the friction of the ground",
     [](Impact c) { return c.energy_parts.friction; }},
    {"energy_by_rest", "px2/s2", "by the rest rule", [](Impact c) { return c.energy_parts.rest; }},
}};

using Whole = const WholeRun&;
constexpr std::array<DriftColumn<WholeRun>, 4> kWholeColumns = {{
    {"end", "px", "distance from the exact fling in the last row", [](Whole w) { return w.end_px; }},
    {"max", "px", "largest distance from the exact fling", [](Whole w) { return w.max_px; }},
    {"energy_end", "px", "energy of the run minus the exact fling's in the last row, as height",
     [](Whole w) { return w.energy_end_px; }},
    {"energy_max", "px", "largest difference of energies, as height",
     [](Whole w) { return w.energy_max_px; }},
}};

// A group with one dataset for each column of its records; notes whether all could be written.
template <class Record>
class RecordTable {
 public:
  RecordTable(hid_t parent, const char* name, const std::vector<Record>& records)
      : records_(records), group_(h5::create_group(parent, name)) {}

  template <class Value, class Get>
  void column(const char* name, const char* long_name, hid_t type, hid_t memory_type, const Get& get,
              const char* unit = nullptr) {
    std::vector<Value> values;
    values.reserve(records_.size());
    for (const Record& record : records_) values.push_back(get(record));
    const h5::Handle dataset =
        h5::write_dataset(group_, name, type, memory_type, values.size(), values.data());
    is_written_ = is_written_ && dataset.is_open();
    if (unit != nullptr) h5::write_attribute(dataset, "units", unit);
    h5::write_attribute(dataset, "long_name", long_name);
  }
  template <class Get>
  void row_numbers(const char* name, const char* long_name, const Get& get) {
    column<std::int64_t>(name, long_name, H5T_STD_I64LE, H5T_NATIVE_INT64, get);
  }
  template <class Columns>
  void columns(const Columns& described) {
    for (const auto& [name, unit, long_name, get] : described)
      column<double>(name, long_name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, get, unit);
  }
  h5::Handle dataset(const char* name) { return {H5Dopen2(group_, name, H5P_DEFAULT), H5Dclose}; }
  /// Makes a column the axis of the others. Call it after all columns.
  void share_axis(const char* name) { is_written_ = h5::share_axis(group_, name) && is_written_; }
  void attribute(const char* name, std::int64_t value) { h5::write_attribute(group_, name, value); }
  [[nodiscard]] bool is_written() const { return is_written_; }

 private:
  const std::vector<Record>& records_;
  h5::Handle group_;
  bool is_written_ = true;
};

void put_row_numbers(RecordTable<ArcErrors>& table) {
  table.row_numbers("first_step", "row that the arc begins with", [](Arc a) { return a.first_step; });
  table.row_numbers("last_step", "row that the arc ends with", [](Arc a) { return a.last_step; });
}

// One row; where there is no exact fling, the attribute that says why.
bool write_whole(hid_t drift, const MeasuredArcs& measured) {
  if (!measured.whole.run) {
    h5::write_attribute(drift, "whole_why", measured.whole.why_not);
    return true;
  }
  const std::vector<WholeRun> rows = {*measured.whole.run};
  RecordTable<WholeRun> whole(drift, "whole", rows);
  whole.columns(kWholeColumns);
  whole.row_numbers("max_step", "row of the largest distance", [](Whole w) { return w.max_px_step; });
  whole.row_numbers("contacts_differ_from",
                    "row of the first contact that is not the exact fling's; -1: none",
                    [](Whole w) { return w.contacts_differ_from.value_or(-1); });
  whole.column<double>(
      "secular", "slope of the energy drift in flight, as height", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE,
      [&](Whole) { return or_nan(measured.summary.secular_px_per_s); }, "px/s");
  whole.share_axis("max_step");
  return whole.is_written();
}

constexpr std::size_t kBatch = 65536;

const DriftColumn<RowErrors>& column_of(std::size_t index) {
  return index < kReferenceRowColumns.size() ? kReferenceRowColumns[index]
                                             : kDriftRowColumns[index - kReferenceRowColumns.size()];
}

// As xarray (dimension scales) and silx (NXdata) expect the time axis.
bool describe(hid_t file, hid_t group, const char* signal) {
  h5::write_attribute(group, "NX_class", "NXdata");
  h5::write_attribute(group, "signal", signal);
  h5::write_attribute(group, "axes", "t");
  return H5Lcreate_hard(file, "/trajectory/t", group, "t", H5P_DEFAULT, H5P_DEFAULT) >= 0 &&
         H5Lcreate_hard(file, "/trajectory/step", group, "step", H5P_DEFAULT, H5P_DEFAULT) >= 0;
}

}  // namespace

DriftRowTable::DriftRowTable(hid_t reference, hid_t drift, std::int64_t steps, std::int64_t rows_every)
    : reference_(reference),
      drift_(drift),
      steps_(steps),
      rows_every_(rows_every),
      rows_(TrajectoryWriter::row_count(steps, rows_every)) {
  for (std::size_t index = 0; index < kColumns; ++index)
    datasets_[index] =
        h5::create_dataset(index < kReferenceRowColumns.size() ? reference : drift, column_of(index).name,
                           H5T_IEEE_F64LE, {static_cast<hsize_t>(rows_)});
}

void DriftRowTable::row(const RowErrors& row) {
  const bool is_due = row.step % rows_every_ == 0;
  if (!is_due && row.step != steps_) return;
  const std::int64_t index = is_due ? row.step / rows_every_ : rows_ - 1;
  if (index < next_) return;  // It has the errors of the arc that it ended.
  fill_up_to(index);
  Values values;
  for (std::size_t column = 0; column < kColumns; ++column) values[column] = column_of(column).get(row);
  put(values);
}

bool DriftRowTable::finish(hid_t file) {
  fill_up_to(rows_);
  flush();
  const h5::Handle time(H5Dopen2(file, "/trajectory/t", H5P_DEFAULT), H5Dclose);
  for (std::size_t column = 0; column < kColumns; ++column) {
    h5::write_attribute(datasets_[column], "units", column_of(column).unit);
    h5::write_attribute(datasets_[column], "long_name", column_of(column).long_name);
    is_written_ = H5DSattach_scale(datasets_[column], time, 0) >= 0 && is_written_;
    datasets_[column] = {};
  }
  return describe(file, reference_, "y") && describe(file, drift_, "truncation") && is_written_;
}

void DriftRowTable::put(const Values& values) {
  for (std::size_t column = 0; column < kColumns; ++column) pending_[column].push_back(values[column]);
  ++next_;
  if (pending_.front().size() == kBatch) flush();
}

void DriftRowTable::fill_up_to(std::int64_t index) {
  Values nothing;
  nothing.fill(std::numeric_limits<double>::quiet_NaN());
  while (next_ < index) put(nothing);
}

void DriftRowTable::flush() {
  const hsize_t count = pending_.front().size();
  if (count == 0) return;
  for (std::size_t column = 0; column < kColumns; ++column) {
    is_written_ = h5::write_part(datasets_[column], H5T_NATIVE_DOUBLE, static_cast<hsize_t>(flushed_), count,
                                 pending_[column].data()) >= 0 &&
                  is_written_;
    pending_[column].clear();
  }
  flushed_ += static_cast<std::int64_t>(count);
}

bool write_measured_arcs(hid_t reference, hid_t drift, const MeasuredArcs& measured) {
  h5::write_attribute(reference, "solution",
                      "closed form of v' = g - k v with k = -ln(0.999) / dt of each frame");
  h5::write_attribute(reference, "checked_by", measured.checked_by);
  h5::write_attribute(drift, "steps_astray", measured.summary.differing_steps);
  h5::write_attribute(drift, "reference_faults", measured.summary.reference_faults);

  RecordTable<ArcErrors> solutions(reference, "arcs", measured.arcs);
  put_row_numbers(solutions);
  solutions.columns(kReferenceArcColumns);
  solutions.share_axis("first_step");

  RecordTable<ArcErrors> arcs(drift, "arcs", measured.arcs);
  put_row_numbers(arcs);
  const h5::Handle ends = h5::enum_type(kArcEndNames);
  arcs.column<std::uint8_t>("ended_by", "what ended the arc", ends, ends,
                            [](Arc a) { return static_cast<std::uint8_t>(a.ended_by); });
  h5::write_enum_flags(arcs.dataset("ended_by"), kArcEndNames);
  arcs.columns(kDriftArcColumns);
  arcs.share_axis("first_step");
  arcs.attribute("total", measured.summary.arcs);
  arcs.attribute("skipped", measured.summary.skipped_arcs);

  RecordTable<ImpactErrors> contacts(drift, "contacts", measured.contacts);
  contacts.row_numbers("step", "clamped row", [](Impact c) { return c.step; });
  contacts.column<std::uint8_t>("wall", "wall: 1 left, 2 right, 4 top, 8 ground", H5T_STD_U8LE,
                                H5T_NATIVE_UINT8, [](Impact c) { return static_cast<std::uint8_t>(c.wall); });
  h5::write_flags(contacts.dataset("wall"), "flag_values", std::span(kContactFlags).first(kWalls.size()),
                  std::span(kContactFlagNames).first(kWalls.size()));
  contacts.columns(kImpactColumns);
  contacts.share_axis("step");
  contacts.attribute("total", measured.summary.contacts);
  return write_whole(drift, measured) && solutions.is_written() && arcs.is_written() && contacts.is_written();
}

}  // namespace hyrax
