// Frames of a core that describes itself as they were shown, and the inputs between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/described/described_rows.h"
#include "sim/described/described_scenario.h"

namespace hyrax {

/// All values after a frame. Refers to the core's description.
struct CoreMoment {
  const Description* description = nullptr;
  KeptRow row = {};
  std::vector<Word> inputs = {};
  std::vector<Word> parameters = {};
  bool is_held = false;
};

/// As Tape (tape.h).
class CoreTape {
 public:
  using Start = CoreMoment;
  using Input = DescribedAction;
  using Document = DescribedScenario;

  explicit CoreTape(const CoreMoment& start);

  void add_input(const DescribedAction& action) { inputs_.push_back({frames(), action}); }
  void add_frame(const KeptRow& row);
  [[nodiscard]] std::int64_t frames() const {
    return static_cast<std::int64_t>(rows_.size() / row_bytes_) - 1;
  }

  [[nodiscard]] DescribedScenario scenario(const std::string& name) const;

 private:
  CoreMoment start_;
  std::vector<DescribedEvent> inputs_;
  std::vector<std::byte> rows_;  // Packed, row 0 first.
  std::size_t row_bytes_ = 0;
};

}  // namespace hyrax
