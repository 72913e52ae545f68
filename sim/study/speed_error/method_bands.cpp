#include "sim/study/speed_error/speed_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "sim/search/draws.h"
#include "sim/study/methods/method_errors.h"

namespace hyrax {
namespace {

Problem moved(Problem problem, std::uint64_t number, Draws& draws) {
  State& start = problem.start;
  const Bounds& bounds = problem.stages.front().bounds;
  start.x_px = std::clamp(start.x_px + kBandStart_px * draws.between(-1.0, 1.0), 0.0, bounds.right_px);
  start.y_px = std::clamp(start.y_px + kBandStart_px * draws.between(-1.0, 1.0), 0.0, bounds.bottom_px);
  start.vx_px_per_s *= 1.0 + kBandSpeed_rel * draws.between(-1.0, 1.0);
  start.vy_px_per_s *= 1.0 + kBandSpeed_rel * draws.between(-1.0, 1.0);
  if (problem.jitter) problem.jitter->seed += number;
  return problem;
}

std::vector<MethodErrors> errors_of(const Core& core, const std::vector<Problem>& problems,
                                    const MethodKind& method, double rate_hz) {
  std::vector<MethodErrors> errors;
  errors.reserve(problems.size());
  for (const Problem& problem : problems)
    errors.push_back(measure_errors(core, problem, method, stage_frames_s(problem, rate_hz), rate_hz));
  return errors;
}

// Nothing if the method, or the paper's step, failed in every fling.
std::optional<MethodBands> bands_of(const std::vector<MethodErrors>& errors,
                                    const std::vector<MethodErrors>& paper) {
  MethodBands bands;
  std::vector<double> positions_px, ends_px, energies_rel;
  for (std::size_t fling = 0; fling < errors.size(); ++fling) {
    if (errors[fling].is_failed || paper[fling].is_failed) continue;
    positions_px.push_back(errors[fling].position_px);
    ends_px.push_back(errors[fling].end_px);
    energies_rel.push_back(errors[fling].energy_rel);
    bands.nearer.add(errors[fling].end_px < paper[fling].end_px);
    bands.other_contacts.add(errors[fling].has_other_contacts);
    if (!(errors[fling].position_px <= rounding_px(errors[fling]))) ++bands.beyond_rounding;
  }
  if (positions_px.empty()) return std::nullopt;
  bands.position_px = *band_of(positions_px);
  bands.end_px = *band_of(ends_px);
  bands.energy_rel = *band_of(energies_rel);
  bands.energies = histogram_of(energies_rel);
  return bands;
}

}  // namespace

std::vector<ErrorBin> histogram_of(std::vector<double> errors) {
  std::erase_if(errors, [](double error) { return !std::isfinite(error); });
  if (errors.empty()) return {};
  const auto [least, most] = std::ranges::minmax(errors);
  const double width = std::max({(most - least) / 10.0, most / 1000.0, std::numeric_limits<double>::min()});
  double step = std::pow(10.0, std::floor(std::log10(width)));
  for (const double more : {2.0, 2.5, 2.0})  // To 2, 5 and 10.
    if (step < width) step *= more;
  std::vector<ErrorBin> bins;
  for (double place = std::floor(least / step); place * step <= most; ++place) {
    ErrorBin& bin = bins.emplace_back(ErrorBin{place * step, (place + 1.0) * step});
    bin.flings =
        std::ranges::count_if(errors, [&](double error) { return error >= bin.low && error < bin.high; });
  }
  return bins;
}

std::vector<Problem> problems_like(const Problem& problem, std::int64_t count) {
  std::vector<Problem> problems{problem};
  Draws draws(kBandSeed);
  while (std::ssize(problems) < count) problems.push_back(moved(problem, problems.size(), draws));
  return problems;
}

std::vector<MethodBands> method_bands(const Core& core, const Problem& problem,
                                      const std::vector<MethodKind>& methods,
                                      const std::vector<double>& rates_hz) {
  std::vector<MethodBands> all;
  const std::vector<Problem> flings = problems_like(problem, kBandFlings);
  for (const double rate_hz : rates_hz) {
    const std::vector<MethodErrors> paper = errors_of(core, flings, methods.front(), rate_hz);
    for (std::size_t method = 0; method < methods.size(); ++method) {
      const MethodKind& kind = methods[method];
      if (!kind.meets_walls || kind.is_adaptive() || kind.is_reference()) continue;
      std::optional<MethodBands> bands =
          bands_of(method == 0 ? paper : errors_of(core, flings, kind, rate_hz), paper);
      if (!bands) continue;
      bands->method = method;
      bands->rate_hz = rate_hz;
      all.push_back(*bands);
    }
  }
  return all;
}

std::string nearness_text(const Share& nearer) {
  if (nearer.low() > 0.5) return "it is nearer";
  return nearer.high() < 0.5 ? "it is farther" : fmt::format("not decided by {} flings", nearer.of);
}

}  // namespace hyrax
