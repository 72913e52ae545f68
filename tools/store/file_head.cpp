#include "tools/store/file_head.h"

#include <functional>

#include "tools/files/scenario_writer.h"
#include "tools/store/input_record.h"
#include "tools/store/provenance.h"
#include "tools/store/trajectory_format.h"

namespace hyrax {
namespace {

template <class Value, class Get>
bool write_column(const h5::Handle& dataset, hid_t memory_type, const std::vector<InputRecord>& inputs,
                  const Get& get) {
  std::vector<Value> values;
  for (const InputRecord& input : inputs) values.push_back(get(input));
  return dataset.is_open() && (values.empty() || H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                                                          values.data()) >= 0);
}

// Of a and b the kind says what they are, and in which unit.
void describe_numbers(hid_t kind, hid_t a, hid_t b) {
  h5::write_enum_flags(kind, kInputKindNames);
  h5::write_attribute(kind, "long_name", "kind of the input");
  h5::write_attribute(
      a, "long_name",
      "vx of a fling or release, x of a place, width of a resize, dt of a hitch, or 0 (unused)");
  h5::write_attribute(b, "long_name",
                      "vy of a fling or release, y of a place, height of a resize, or 0 (unused)");
  h5::write_attribute(a, "units_by_kind", "px/s px 1 px px s 1 px/s");
  h5::write_attribute(b, "units_by_kind", "px/s px 1 px px 1 1 px/s");
}

bool write_inputs(hid_t file, const std::vector<InputRecord>& inputs) {
  const h5::Handle group = h5::create_group(file, "events");
  const h5::Handle kind_type = h5::enum_type(kInputKindNames);
  const auto make = [&](const char* name, hid_t type) {
    return h5::create_dataset(group, name, type, {inputs.size()});
  };
  const h5::Handle frame = make("frame", H5T_STD_I64LE);
  const h5::Handle kind = make("kind", kind_type);
  const h5::Handle a = make("a", H5T_IEEE_F64LE);
  const h5::Handle b = make("b", H5T_IEEE_F64LE);
  const bool is_written =
      write_column<std::int64_t>(frame, H5T_NATIVE_INT64, inputs, std::mem_fn(&InputRecord::frame)) &&
      write_column<std::uint8_t>(kind, kind_type, inputs, std::mem_fn(&InputRecord::kind)) &&
      write_column<double>(a, H5T_NATIVE_DOUBLE, inputs, std::mem_fn(&InputRecord::a)) &&
      write_column<double>(b, H5T_NATIVE_DOUBLE, inputs, std::mem_fn(&InputRecord::b));
  h5::write_attribute(frame, "long_name", "frame to which the input was applied; it makes row frame + 1");
  describe_numbers(kind, a, b);
  return is_written && h5::share_axis(group, "frame");
}

}  // namespace

bool write_head(hid_t file, const FileHead& head, const std::vector<Input>& inputs) {
  h5::write_attribute(file, "format", kTrajectoryFormat);
  h5::write_attribute(file, "name", head.scenario.name);
  h5::write_attribute(file, "scenario", to_text(to_json(head.scenario)));
  h5::write_attribute(file, "steps", head.steps);
  h5::write_attribute(file, "physics", head.physics);
  h5::write_attribute(file, "state_hash", head.state_hash);
  h5::write_attribute(file, "NX_class", "NXroot");
  h5::write_attribute(file, "default", "trajectory");
  write_provenance(file, own_provenance());
  std::vector<InputRecord> records;
  for (const Input& input : inputs) records.push_back(record_of(input));
  return write_inputs(file, records);
}

}  // namespace hyrax
