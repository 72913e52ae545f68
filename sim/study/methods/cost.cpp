#include "sim/study/methods/cost.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/scenario/split_mix64.h"

namespace hyrax {
namespace {

// A chain of multiplications, each of which waits for the one before: nothing but the clock decides how
// long it takes.
double probe_chain() {
  volatile double factor = 1.0000001;
  double product = factor;
  for (int link = 0; link < 5'000; ++link) product *= factor;
  return product;
}

std::int64_t probe_ns(const NanosecondClock& now_ns) {
  const std::int64_t from_ns = now_ns();
  volatile double product = probe_chain();
  static_cast<void>(product);
  return now_ns() - from_ns;
}

// Every work `repetitions` times, shuffled (Fisher and Yates; Durstenfeld, CACM 7:420, 1964).
std::vector<std::size_t> shuffled(std::size_t works, int repetitions, std::uint64_t seed) {
  std::vector<std::size_t> order;
  for (int repetition = 0; repetition < repetitions; ++repetition)
    for (std::size_t work = 0; work < works; ++work) order.push_back(work);
  for (std::size_t end = order.size(); end > 1; --end)
    std::swap(order[end - 1], order[split_mix64(seed, end) % end]);
  return order;
}

}  // namespace

double quantile(std::vector<double> values, double part) {
  assert(!values.empty() && part >= 0.0 && part <= 1.0);
  std::sort(values.begin(), values.end());
  const double place = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
}

Costs measure_costs(const std::vector<std::function<void()>>& works, const NanosecondClock& now_ns,
                    const CostOptions& options,
                    const std::function<void(std::int64_t, std::int64_t)>& report_progress) {
  std::vector<std::int64_t> runs_per_sample;
  for (const auto& work : works) {
    work();
    const std::int64_t from_ns = now_ns();
    work();
    const std::int64_t run_ns = std::max<std::int64_t>(now_ns() - from_ns, 1);
    runs_per_sample.push_back(std::max<std::int64_t>(1, options.sample_ns / run_ns));
  }
  std::vector<std::vector<double>> samples_ns(works.size());
  std::vector<double> probes_ns{static_cast<double>(probe_ns(now_ns))};
  const std::vector<std::size_t> order = shuffled(works.size(), options.repetitions, options.seed);
  constexpr std::size_t kSamplesBetweenProbes = 16;
  for (std::size_t sample = 0; sample < order.size(); ++sample) {
    const std::size_t work = order[sample];
    const std::int64_t runs = runs_per_sample[work];
    const std::int64_t from_ns = now_ns();
    for (std::int64_t run = 0; run < runs; ++run) works[work]();
    samples_ns[work].push_back(static_cast<double>(now_ns() - from_ns) / static_cast<double>(runs));
    if (sample % kSamplesBetweenProbes == 0) probes_ns.push_back(static_cast<double>(probe_ns(now_ns)));
    if (report_progress)
      report_progress(static_cast<std::int64_t>(sample), static_cast<std::int64_t>(order.size()));
  }
  Costs result;
  for (const std::vector<double>& sample : samples_ns)
    result.costs.push_back({quantile(sample, 0.5), quantile(sample, 0.25), quantile(sample, 0.75)});
  result.probe.median_ns = quantile(probes_ns, 0.5);
  if (result.probe.median_ns > 0.0)
    result.probe.drift_rel = (quantile(probes_ns, 0.95) - quantile(probes_ns, 0.05)) / result.probe.median_ns;
  return result;
}

}  // namespace hyrax
