#include "tools/store/provenance.h"

#include "tools/files/build_info.h"
#include "tools/store/hdf5.h"

namespace hyrax {

Provenance own_provenance() {
  const BuildInfo build = build_info();
  const auto text = [](std::string_view view) { return std::string(view); };
  return {.program = "hyrax-sim " + text(build.version),
          .compiler = text(build.compiler),
          .flags = text(build.flags),
          .target = text(build.target),
          .instruction_set = text(build.instruction_set),
          .self_test = text(kStrictArithmetic)};
}

void write_provenance(hid_t file, const Provenance& provenance) {
  const h5::Handle group = h5::create_group(file, "provenance");
  for (const ProvenanceField& field : kProvenanceFields)
    if (const auto& value = provenance.*field.value) h5::write_attribute(group, field.name, *value);
}

Provenance read_provenance(hid_t file) {
  Provenance provenance;
  if (H5Lexists(file, "provenance", H5P_DEFAULT) <= 0) return provenance;
  const h5::Handle group(H5Gopen2(file, "provenance", H5P_DEFAULT), H5Gclose);
  if (!group.is_open()) return provenance;
  for (const ProvenanceField& field : kProvenanceFields)
    provenance.*field.value = h5::read_text_attribute(group, field.name);
  return provenance;
}

}  // namespace hyrax
