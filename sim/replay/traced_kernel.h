// The kernel of a traced step: what a replay plays without its header.
#pragma once

#include <cstdint>
#include <memory>

#include "sim/replay/kernel.h"
#include "sim/trace/traced_step.h"

namespace hyrax {

/// What a kernel of a traced step tells the walls by.
enum class ContactSource : std::uint8_t {
  comparisons,  ///< The step's own comparisons with its walls.
  rows          ///< The rows alone (row_walls.h), as the kernel of a core of one's own.
};

/// Null if the step is not playable, or has
/// members that a row does not: between two stretches they would be lost.
/// REQUIRES: a step as canonical() or read_step() return it.
[[nodiscard]] std::unique_ptr<const Kernel> make_traced_kernel(
    const TracedStep& step, ContactSource contacts = ContactSource::comparisons);

}  // namespace hyrax
