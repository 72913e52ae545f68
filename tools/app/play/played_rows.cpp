#include "tools/app/play/played_rows.h"

#include <algorithm>
#include <memory>

#include "sim/replay/replay.h"

namespace hyrax {
namespace {

class PlayedRows final : public RowSink {
 public:
  PlayedRows(const Core& core, const Scenario& scenario)
      : scenario_(scenario),
        replay_(core, scenario_, *this),
        end_(std::min(replay_.steps(), kRowsPlayedMax)) {}

  [[nodiscard]] Wants wants() const override { return {.rows_every = 1}; }
  void row(const Row& row) override { rows_.append(row); }

  // Rows come in batches of a block; those that are left, at the end.
  void next(Columns& batch) {
    constexpr std::int64_t kPiece = 1 << 16;
    rows_.clear();
    while (rows_.size() == 0 && !is_done_) {
      const std::int64_t from = replay_.keyframe().row.step;
      replay_.play_to(std::min(end_, from + kPiece));
      is_done_ = replay_.keyframe().row.step < from + kPiece;
      if (is_done_) static_cast<void>(replay_.finish());
    }
    std::swap(batch, rows_);
  }

 private:
  Scenario scenario_;
  Columns rows_;
  bool is_done_ = false;
  Replay replay_;
  std::int64_t end_;
};

}  // namespace

RowBatches played_rows(const Core& core, const Scenario& scenario) {
  return [played = std::make_shared<PlayedRows>(core, scenario)](Columns& batch) { played->next(batch); };
}

}  // namespace hyrax
