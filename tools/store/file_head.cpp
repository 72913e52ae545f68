#include "tools/store/file_head.h"

#include "tools/files/build_info.h"
#include "tools/files/scenario_writer.h"
#include "tools/store/trajectory_format.h"

namespace hyrax {
namespace {

h5::Handle input_kind_type() {
  h5::Handle type(H5Tenum_create(H5T_STD_U8LE), H5Tclose);
  for (std::uint8_t kind = 0; kind < kInputKindNames.size(); ++kind)
    H5Tenum_insert(type, std::string(kInputKindNames[kind]).c_str(), &kind);
  return type;
}

template <class Value, class Get>
bool write_column(hid_t group, const char* name, hid_t type, hid_t memory_type,
                  const std::vector<Input>& inputs, const Get& get) {
  std::vector<Value> values;
  for (const Input& input : inputs) values.push_back(get(input));
  const h5::Handle dataset = h5::create_dataset(group, name, type, {values.size()});
  return dataset.is_open() && (values.empty() || H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                                                          values.data()) >= 0);
}

bool write_inputs(hid_t file, const std::vector<Input>& inputs) {
  const h5::Handle group = h5::create_group(file, "events");
  const h5::Handle kind = input_kind_type();
  const auto code = [](const Input& input) { return static_cast<std::uint8_t>(input.kind); };
  return write_column<std::int64_t>(group, "frame", H5T_STD_I64LE, H5T_NATIVE_INT64, inputs,
                                    [](const Input& input) { return input.frame; }) &&
         write_column<std::uint8_t>(group, "kind", kind, kind, inputs, code) &&
         write_column<double>(group, "a", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, inputs,
                              [](const Input& input) { return input.a; }) &&
         write_column<double>(group, "b", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, inputs,
                              [](const Input& input) { return input.b; });
}

}  // namespace

void write_provenance(hid_t file) {
  const h5::Handle group = h5::create_group(file, "provenance");
  const BuildInfo build = build_info();
  h5::write_attribute(group, "program", "hyrax-sim " + std::string(build.version));
  h5::write_attribute(group, "compiler", build.compiler);
  h5::write_attribute(group, "flags", build.flags);
  h5::write_attribute(group, "target", build.target);
}

bool write_head(hid_t file, const FileHead& head, const std::vector<Input>& inputs) {
  h5::write_attribute(file, "format", kTrajectoryFormat);
  h5::write_attribute(file, "name", head.scenario.name);
  h5::write_attribute(file, "scenario", to_text(to_json(head.scenario)));
  h5::write_attribute(file, "steps", head.steps);
  h5::write_attribute(file, "physics", head.physics);
  h5::write_attribute(file, "state_hash", head.state_hash);
  h5::write_attribute(file, "NX_class", "NXroot");
  h5::write_attribute(file, "default", "trajectory");
  write_provenance(file);
  return write_inputs(file, inputs);
}

}  // namespace hyrax
