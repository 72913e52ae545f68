// A core whose calls are looked at for what they do to the processor, and for what they throw.
#pragma once

#include <string>
#include <utility>

#include "sim/core/core.h"
#include "tools/files/failure.h"

namespace hyrax {

/// What a core does that ends its run.
class CoreFailure : public UnplacedFailure {
 public:
  CoreFailure(ExitCode exit_code, const std::string& sentence, std::string without_row)
      : UnplacedFailure(exit_code, sentence), without_row_(std::move(without_row)) {}
  /// The same in every run in which the core does it.
  [[nodiscard]] const std::string& without_row() const { return without_row_; }

 private:
  std::string without_row_;
};

/// The core, with every call followed by a look at the control bits of floating-point arithmetic: rounding
/// and flush-to-zero, not the sticky flags. Where they changed they are restored. ERRORS: of its stepper's
/// functions CoreFailure(not_strict_ieee), or CoreFailure(disagreed) where the core throws, with the row that
/// the first such step makes, found by a second play.
[[nodiscard]] Core controlled(Core core);

}  // namespace hyrax
