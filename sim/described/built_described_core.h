// The core that a program is built with.
#pragma once

namespace hyrax {

struct DescribedCore;

/// Named by the program; only its `main` asks for it. Defined by the one source that includes the core's
/// header.
[[nodiscard]] DescribedCore built_described_core();

}  // namespace hyrax
