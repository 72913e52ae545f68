// The commands of the program of a core that describes itself.
#pragma once

#include <vector>

#include "sim/described/described_core.h"
#include "sim/described/described_scenario.h"
#include "tools/app/command_line/options.h"
#include "tools/app/study/study_command.h"
#include "tools/app/sweep/sweep_run.h"

namespace hyrax {

// Each refers to the core, which must outlive it.
[[nodiscard]] Command described_run_command(const DescribedCore& core);
[[nodiscard]] Command described_check_command(const DescribedCore& core);
[[nodiscard]] Command described_bless_command(const DescribedCore& core);
[[nodiscard]] Command described_diff_command(const DescribedCore& core);
[[nodiscard]] Command described_new_command(const DescribedCore& core);
[[nodiscard]] Command described_validate_command(const DescribedCore& core);
[[nodiscard]] Command described_schema_command(const DescribedCore& core);
[[nodiscard]] Command described_fuzz_command(const DescribedCore& core);
[[nodiscard]] Command described_sweep_command(const DescribedCore& core);
[[nodiscard]] Command described_info_command(const DescribedCore& core);
[[nodiscard]] Command described_shrink_command(const DescribedCore& core);
[[nodiscard]] Command described_study_command(const DescribedCore& core);
[[nodiscard]] Command described_report_command(const DescribedCore& core);

/// How its sweeps are read and played. A member whose run ends early keeps what it came to; players throw
/// Failure(disagreed) for one without a first row.
[[nodiscard]] SweptCore swept_core(const DescribedCore& core);

/// Each scenario as it is, by frames of other lengths, jittered, with a hitch, for long, and with each value
/// that has limits at these; held to kGeneralRules. Broken: a case that breaks one.
[[nodiscard]] Result study_hard_cases(const DescribedCore& core,
                                      const std::vector<DescribedScenario>& scenarios,
                                      const StudyInput& input);

}  // namespace hyrax
