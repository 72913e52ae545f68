// What a sweep's file shows on a page, of any core, without its members.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/ensemble/member_numbers.h"
#include "tools/report/result_page.h"
#include "tools/store/ensemble_file.h"

namespace hyrax {

/// All numbers of a file's members; of a very long file those of a sample.
[[nodiscard]] std::vector<MemberNumbers> member_numbers(const EnsembleReader& reader);

/// One of every so many rows is in the samples.
[[nodiscard]] std::int64_t rows_between_samples(const EnsembleReader& reader);

/// Their ranges and distributions. @param noun of a member, as "fling".
[[nodiscard]] ShownResult member_result(const EnsembleReader& reader,
                                        const std::vector<MemberNumbers>& numbers, const std::string& title,
                                        const std::string& noun);

/// The files of a page that shows sweeps. @param show of each. ERRORS: Failure(bad_input) for a file of
/// another kind, and if they are to be compared with a trajectory.
[[nodiscard]] std::vector<ShownResult> shown_sweeps(
    const std::vector<std::string>& files, const std::string& against,
    const std::function<ShownResult(const std::string& path)>& show);

}  // namespace hyrax
