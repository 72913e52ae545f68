// The commands of the program of a core that describes itself.
#pragma once

#include "sim/described/described_core.h"
#include "tools/app/command_line/options.h"
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

}  // namespace hyrax
