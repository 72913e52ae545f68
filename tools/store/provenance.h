// The build that wrote a file, with its floating-point settings. Not part of any comparison of runs.
#pragma once

#include <hdf5.h>

#include <array>
#include <optional>
#include <string>

namespace hyrax {

/// The attributes of /provenance: the instruction set is that of the build, not of the machine; the self-test
/// is that of arithmetic.
inline constexpr std::array kProvenanceNames = {"program", "compiler",        "flags",
                                                "target",  "instruction_set", "self_test"};

inline constexpr const char* kCoreAttribute = "core";

/// Their values; nothing where a file lacks one.
using Provenance = std::array<std::optional<std::string>, kProvenanceNames.size()>;

/// Of this program.
void write_provenance(hid_t file);
[[nodiscard]] Provenance read_provenance(hid_t file);

/// The attribute `core` of `/`: the checksum of the core that played or computed the file, as
/// CoreRecord::checksum has it; empty, and no attribute: unknown. Not part of a comparison either.
void write_core_name(hid_t file, const std::string& checksum);
[[nodiscard]] std::string read_core_name(hid_t file);

}  // namespace hyrax
