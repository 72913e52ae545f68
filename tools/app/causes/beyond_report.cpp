#include "tools/app/causes/core_check.h"

#include <fmt/format.h>

#include <cmath>

#include "sim/reference/exact_fling.h"
#include "sim/result/number_text.h"
#include "sim/study/reference_model.h"

namespace hyrax {
namespace {

// Nothing where it may meet a wall so often that it takes too long to follow.
std::optional<State> end_of_fling(const Model& model, const Scenario& scenario, double t_s) {
  constexpr double kImpactsMax = 1e5;
  const State start = start_state(scenario);
  const Bounds bounds = bounds_of(scenario.window, scenario.sprite);
  if (!(bounds.right_px > 0.0 && bounds.bottom_px > 0.0)) return std::nullopt;
  const double fastest_px_per_s =
      std::fabs(start.vy_px_per_s) + std::sqrt(2.0 * model.gravity_px_per_s2 * bounds.bottom_px);
  const double impacts_per_s =
      std::fabs(start.vx_px_per_s) / bounds.right_px + fastest_px_per_s / bounds.bottom_px;
  if (!(t_s * impacts_per_s < kImpactsMax)) return std::nullopt;
  ExactFling fling{FixedLaws(model)};
  fling.start(start, bounds);
  return fling.at(t_s);
}

// "41.2 % (38.2 .. 44.3)".
std::string percent_text(const Share& share) {
  const auto percent = [](double part) { return rounded(100.0 * part, 3); };
  return fmt::format("{} % ({} .. {})", percent(share.part()), percent(share.low()), percent(share.high()));
}

}  // namespace

ExactEnd exact_end(const std::optional<Constants>& constants) {
  if (!constants || !why_not_measurable(*constants).empty())
    return [](const Scenario&, double) { return std::nullopt; };
  return [model = Model(*constants)](const Scenario& scenario, double t_s) {
    return end_of_fling(model, scenario, t_s);
  };
}

std::string beyond_text(const BeyondLibrary& beyond) {
  std::string text =
      fmt::format("  beyond the library: of {} of 10 s, {} have other bits",
                  counted(beyond.other_bits.of, "random fling"), percent_text(beyond.other_bits));
  if (beyond.other_bits.count > 0)
    text += fmt::format(
        "; {} end elsewhere{}; {} have another number of contacts; {} settle in one only",
        percent_text(beyond.ends_elsewhere),
        beyond.apart_px ? fmt::format(", by {} px (median; 90 %: {} px)", rounded(beyond.apart_px->median, 3),
                                      rounded(beyond.apart_px->high, 3))
                        : "",
        percent_text(beyond.other_bounces), percent_text(beyond.settles_in_one));
  text += "\n";
  if (beyond.other_bits.count == 0 || !beyond.end_error_px) return text;
  const auto [accepted, current] = *beyond.end_error_px;
  const std::string before = rounded(accepted, 3), now = rounded(current, 3);
  return text + fmt::format("  {} the exact fling: {} px before, {} px now (median distance at the end)\n",
                            before == now        ? "as near to"
                            : current < accepted ? "nearer to"
                                                 : "farther from",
                            before, now);
}

Json beyond_json(const BeyondLibrary& beyond) {
  const auto share = [](const Share& counted) {
    return Json::Object{{"share", counted.part()}, {"low", counted.low()}, {"high", counted.high()}};
  };
  const auto px = [&](double Band::*value) {
    return beyond.apart_px ? Json((*beyond.apart_px).*value) : Json();
  };
  Json::Object ends = share(beyond.ends_elsewhere);
  ends.emplace_back("median_px", px(&Band::median));
  ends.emplace_back("p90_px", px(&Band::high));
  const auto& error_px = beyond.end_error_px;
  return Json::Object{{"flings", beyond.other_bits.of},
                      {"other_bits", share(beyond.other_bits)},
                      {"ends_elsewhere", std::move(ends)},
                      {"other_bounces", share(beyond.other_bounces)},
                      {"settles_in_one", share(beyond.settles_in_one)},
                      {"end_error_px", error_px ? Json(Json::Object{{"accepted", error_px->accepted},
                                                                    {"current", error_px->current}})
                                                : Json()}};
}

}  // namespace hyrax
