// A run as a golden file keeps it: every row of a short one, block digests of a long one.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/scenario/schedule.h"
#include "sim/trajectory/columns.h"
#include "sim/trajectory/row.h"
#include "sim/trajectory/row_sink.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

/// Runs of more rows than this are kept as blocks.
inline constexpr std::int64_t kStoredRowsMax = 2000;
[[nodiscard]] constexpr bool is_stored_as_rows(std::int64_t steps) { return steps + 1 <= kStoredRowsMax; }
/// Only so many distinct blocks keep row checks, so that a golden file stays small.
inline constexpr std::size_t kCheckedBlocksMax = 16;

/// A byte for each of dt, x, y, vx, vy and contact: finds which row and field of a block differ, if the
/// digest differs. It misses 1 difference in 256.
using RowCheck = std::array<std::uint8_t, 6>;
[[nodiscard]] RowCheck check_of(const Row& row);

/// A block, `count` times over.
struct StoredBlock {
  std::int64_t count = 1;
  Digest digest{};
  Keyframe keyframe;             ///< At the first row of the first of them.
  std::vector<RowCheck> checks;  ///< One a row, or none.
};

/// Whether all bits of two keyframes are the same.
[[nodiscard]] bool is_same_keyframe(const Keyframe& a, const Keyframe& b);

/// What is known of a run as a whole, whatever core played it.
struct RunHead {
  std::int64_t steps = 0;
  std::string physics = {};     ///< Physics model.
  std::string state_hash = {};  ///< 32 hex digits.
  /// Of the core that played it; nothing where it is not the paper's model.
  std::optional<Constants> constants = {};
  std::string core = {};           ///< That core's checksum; empty: unknown. No comparison looks at it.
  std::uint8_t walls_of_rows = 0;  ///< Core::walls_of_rows of that core.
};

/// The same with the scenario, of a core of the paper's interface.
struct FileHead : RunHead {
  Scenario scenario = {};
};

struct StoredRun : FileHead {
  Columns rows;                     ///< Every row of a short run; else empty.
  std::vector<StoredBlock> blocks;  ///< Of a long run; else empty.
  Row final;
  std::vector<Contact> contacts;
  /// Set for a run of too many contacts to hold them: passes all of them on; `contacts` is then empty.
  std::function<void(const std::function<void(const Contact&)>& take)> replay_contacts;
  std::int64_t contacts_total = 0;
  std::vector<Input> inputs;

  /// Every contact in order, held or not.
  void each_contact(const std::function<void(const Contact&)>& take) const;
};

/// Keeps of a run what a StoredRun holds; scenario, hash and steps are its owner's to fill in.
class RunRecorder : public ContactRecorder {
 public:
  /// @param steps of the run: decides between rows and blocks.
  explicit RunRecorder(std::int64_t steps) : is_short_(is_stored_as_rows(steps)) {}

  [[nodiscard]] Wants wants() const override {
    return {.rows_every = is_short_ ? 1 : 0, .contacts = true, .blocks = !is_short_};
  }
  void row(const Row& row) override { run_.rows.append(row); }
  void block(const Block& block, std::int64_t count) override;

  [[nodiscard]] StoredRun take() {
    run_.contacts = take_contacts();
    return std::move(run_);
  }

 private:
  bool is_short_;
  StoredRun run_;
};

}  // namespace hyrax
