// What every trajectory file says of itself: attributes, inputs, provenance.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/scenario/schedule.h"
#include "tools/store/hdf5.h"

namespace hyrax {

struct FileHead {
  Scenario scenario;
  std::int64_t steps = 0;
  std::string physics;
  std::string state_hash;  ///< 32 hex digits.
};

/// Writes the attributes of `/`, the group /events and the group /provenance.
/// Returns false where the file could not be written.
[[nodiscard]] bool write_head(hid_t file, const FileHead& head, const std::vector<Input>& inputs);

}  // namespace hyrax
