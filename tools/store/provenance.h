// The build that wrote a file, with its floating-point settings. Not part of any comparison of runs.
#pragma once

#include <hdf5.h>

#include <array>
#include <optional>
#include <string>

namespace hyrax {

/// The attributes of /provenance; nothing where a file lacks one.
struct Provenance {
  std::optional<std::string> program;
  std::optional<std::string> compiler;
  std::optional<std::string> flags;
  std::optional<std::string> target;
  std::optional<std::string> instruction_set;  ///< Of the build, not of the machine.
  std::optional<std::string> self_test;        ///< The result of the test of its arithmetic.
};

struct ProvenanceField {
  const char* name;
  std::optional<std::string> Provenance::*value;
};

inline constexpr std::array<ProvenanceField, 6> kProvenanceFields = {{
    {"program", &Provenance::program},
    {"compiler", &Provenance::compiler},
    {"flags", &Provenance::flags},
    {"target", &Provenance::target},
    {"instruction_set", &Provenance::instruction_set},
    {"self_test", &Provenance::self_test},
}};

/// Of this program.
[[nodiscard]] Provenance own_provenance();

void write_provenance(hid_t file, const Provenance& provenance);
[[nodiscard]] Provenance read_provenance(hid_t file);

}  // namespace hyrax
