// Errors of arcs and contacts in a file.
#pragma once

#include <string>
#include <vector>

#include "sim/reference/drift.h"
#include "tools/store/hdf5.h"

namespace hyrax {

struct MeasuredArcs {
  const DriftSummary& summary;
  const std::vector<ArcErrors>& arcs;         ///< The first of them.
  const std::vector<ImpactErrors>& contacts;  ///< The first of them.
  std::string checked_by;                     ///< The second solution beside the closed form.
};

/// Writes /reference/arcs, /drift/arcs and /drift/contacts, and the attributes.
/// @param reference, drift the open groups. Returns false where the file could not be written.
[[nodiscard]] bool write_measured_arcs(hid_t reference, hid_t drift, const MeasuredArcs& measured);

}  // namespace hyrax
