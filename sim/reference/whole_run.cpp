#include "sim/reference/whole_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyrax {
namespace {

// No run is longer: 1e12 frames of kFrameMax_s.
constexpr double kEndless_s = 1e21;
// Far less than a row can hold of a coordinate in a window.
constexpr double kStill_px = 1e-12;

bool is_inside_unit(double factor) { return factor > 0.0 && factor < 1.0; }

std::string why_no_fling(const Model& model) {
  if (!(model.gravity_px_per_s2 > 0.0)) return "gravity is 0";
  if (!is_inside_unit(model.air_drag)) return "the drag factor is not between 0 and 1";
  if (!is_inside_unit(model.ground_friction)) return "the friction factor is not between 0 and 1";
  if (!(model.restitution >= 0.0 && model.restitution < 1.0)) return "the restitution is not below 1";
  if (!(model.rest_threshold_px_per_s > 0.0)) return "the rest threshold is 0";
  return "";
}

}  // namespace

WholeMeter::WholeMeter(const Scenario& scenario, std::vector<Input> inputs, const Model& model,
                       std::function<void(const WholeRow&)> each)
    : playback_(scenario, std::move(inputs)),
      laws_(model),
      fling_(laws_),
      steps_(step_count(scenario)),
      each_(std::move(each)) {
  if (std::string why = why_no_fling(model); !why.empty())
    end_without(std::move(why));
  else
    outcome_.run.emplace();
}

void WholeMeter::end_without(std::string why) {
  outcome_ = {std::nullopt, std::move(why)};
  is_over_ = true;
}

void WholeMeter::row(const Row& row) {
  if (is_over_) return;
  if (!is_finite(state_of(row)))
    return end_without("a value is not finite from row " + std::to_string(row.step));
  if (row.step == 0) {
    exact_ = state_of(row);
  } else {
    if (!playback_.is_held() && !still_from_step_) exact_ = fling_.at(row.t_s - from_s_);
    compare(row);
  }
  Row from = row;
  set_state(from, exact_);
  if (playback_.apply(from).ends_arc || row.step == 0) start(from);
  // The state repeats itself to the end, without inputs: the last row is as this one.
  is_over_ = is_over_ || (still_from_step_ && repetition_ && repetition_->from_step <= row.step &&
                          row.step - *still_from_step_ >= repetition_->period_steps &&
                          (steps_ - row.step) % repetition_->period_steps == 0);
}

void WholeMeter::start(const Row& from) {
  const Bounds bounds = playback_.bounds();
  if (!(bounds.right_px >= 0.0 && bounds.bottom_px >= 0.0))
    return end_without("the sprite is larger than its window in row " + std::to_string(from.step));
  exact_ = state_of(from);
  from_s_ = from.t_s;
  fling_.start(exact_, bounds, from.step > 0 && fling_.slides(), kEndless_s);
  still_from_step_.reset();
  met_.clear();
  compared_ = 0;
  contact_before_ = 0;
}

void WholeMeter::compare(const Row& row) {
  WholeRun& whole = *outcome_.run;
  const double dx_px = row.x_px - exact_.x_px;
  const double dy_px = row.y_px - exact_.y_px;
  whole.end_px = std::hypot(dx_px, dy_px);
  if (whole.end_px > whole.max_px) {
    whole.max_px = whole.end_px;
    whole.max_px_step = row.step;
  }
  // Two large energies are never subtracted: (v - w)(v + w) / 2 - g (y - z).
  const auto half_difference = [](double v, double w) { return 0.5 * (v - w) * (v + w); };
  whole.energy_end_px = (half_difference(row.vx_px_per_s, exact_.vx_px_per_s) +
                         half_difference(row.vy_px_per_s, exact_.vy_px_per_s)) /
                            laws_.gravity_px_per_s2 -
                        dy_px;
  whole.energy_max_px = std::max(whole.energy_max_px, std::fabs(whole.energy_end_px));
  if (each_) each_({row.t_s, whole.end_px});
  compare_contacts(row);
  const double slide_px = exact_.vx_px_per_s / (laws_.drag_rate_per_s + laws_.friction_rate_per_s);
  if (still_from_step_ || !fling_.slides() || !(std::fabs(slide_px) < kStill_px)) return;
  exact_.vx_px_per_s = 0.0;
  still_from_step_ = row.step;
}

// In a corner the run's two contacts are one row's: their order is the exact fling's.
void WholeMeter::compare_contacts(const Row& row) {
  if (outcome_.run->contacts_differ_from) return;
  for (const Wall wall : kWalls)
    if (touches(row.contact, wall) && !touches(contact_before_, wall)) met_.push_back({row.step, wall});
  contact_before_ = row.contact;
  const std::vector<ExactImpact>& exact = fling_.impacts();
  std::size_t count = exact.size();  // Of those up to the one with which it slides.
  while (fling_.slides() && count > 0 && exact[count - 1].wall != Wall::ground) --count;
  for (; compared_ < std::min(met_.size(), count); ++compared_) {
    const std::size_t next = compared_ + 1;
    if (met_[compared_].wall != exact[compared_].wall && next < met_.size() &&
        met_[next].step == met_[compared_].step)
      std::swap(met_[compared_], met_[next]);
    if (met_[compared_].wall == exact[compared_].wall) continue;
    outcome_.run->contacts_differ_from = met_[compared_].step;
    return;
  }
}

}  // namespace hyrax
