// The verdicts that an author expects of the paper's claims: a JSON file of the format `hyrax-verdicts/1`.
#pragma once

#include <string>
#include <vector>

#include "sim/study/paper/paper_claim.h"

namespace hyrax {

/// How the claims differ from the file's verdicts, one sentence each: another verdict, or a claim of which
/// the file says nothing. The file is
///
///   { "format": "hyrax-verdicts/1", "verdicts": { "2.3-energy": "does not hold", ... } }
///
/// with `holds`, `holds when`, `does not hold` or `not measured` for each claim.
/// ERRORS: Failure(cannot_access) where it cannot be read; Failure(bad_input) with all that is wrong in it,
/// a name that is no claim's among that.
[[nodiscard]] std::vector<std::string> unexpected_verdicts(const std::string& path,
                                                           const std::vector<Claim>& claims);

}  // namespace hyrax
