// The build, as files state it and as info prints it with this machine and its libraries.
#pragma once

#include <hdf5.h>

#include <array>
#include <optional>
#include <string>

#include "tools/files/json.h"

namespace hyrax {

/// Texts: version, compiler, flags, target, instruction_set, processor.
[[nodiscard]] Json::Object build_facts();
/// Texts: self_test, and the versions of what every program links.
[[nodiscard]] Json::Object library_facts();

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
