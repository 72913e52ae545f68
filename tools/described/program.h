// The program of a core that describes itself.
#pragma once

namespace hyrax {

struct DescribedCore;

/// What `main` returns, with its arguments. @param make_core as built_described_core: the core may throw.
[[nodiscard]] int run_described_program(DescribedCore (*make_core)(), int argc, char** argv);

}  // namespace hyrax
