// The verdicts of `check` on scenarios, in the words and exit codes of every program that checks.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tools/files/failure.h"

namespace hyrax {

enum class CheckStatus { agreed, disagreed, missing, failed, unreferenced };

[[nodiscard]] std::string_view name_of(CheckStatus status);

/// The exit code of a status. REQUIRES: not `failed`, whose exit code is that of its Failure.
[[nodiscard]] ExitCode exit_code_of(CheckStatus status);

/// "3 checked: 2 agreed, 1 disagreed, 0 without golden file, 0 failed". One line. Unreferenced golden files
/// are no scenarios; they are counted at its end, if there are any, and so are folders that failed.
[[nodiscard]] std::string counts_sentence(const std::vector<CheckStatus>& statuses,
                                          std::int64_t folders_failed = 0);

}  // namespace hyrax
