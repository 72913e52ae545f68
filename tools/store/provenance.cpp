#include "tools/store/provenance.h"

#include "tools/files/build_info.h"
#include "tools/store/hdf5.h"

namespace hyrax {

void write_provenance(hid_t file) {
  const BuildInfo build = build_info();
  const std::string program = "hyrax-sim " + std::string(build.version);
  const std::array<std::string_view, kProvenanceNames.size()> values = {
      program, build.compiler, build.flags, build.target, build.instruction_set, kStrictArithmetic};
  const h5::Handle group = h5::create_group(file, "provenance");
  for (std::size_t index = 0; index < values.size(); ++index)
    h5::write_attribute(group, kProvenanceNames[index], values[index]);
}

Provenance read_provenance(hid_t file) {
  const h5::Handle group(H5Gopen2(file, "provenance", H5P_DEFAULT), H5Gclose);
  Provenance provenance;
  for (std::size_t index = 0; index < provenance.size(); ++index)
    provenance[index] = h5::read_text_attribute(group, kProvenanceNames[index]);
  return provenance;
}

void write_core_name(hid_t file, const std::string& checksum) {
  if (!checksum.empty()) h5::write_attribute(file, kCoreAttribute, checksum);
}

std::string read_core_name(hid_t file) { return h5::read_text_attribute(file, kCoreAttribute).value_or(""); }

}  // namespace hyrax
