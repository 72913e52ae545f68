#include "sim/ensemble/member_numbers.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "sim/result/estimate.h"
#include "sim/result/number_text.h"

namespace hyrax {
namespace {

constexpr int kBins = 40;

std::string count_note(std::int64_t count, std::int64_t members) {
  const auto text = [](std::int64_t number) { return with_decimals(static_cast<double>(number), 0); };
  return (count == members ? "all " : text(count) + " of ") + text(members) + " members";
}

std::vector<const MemberNumbers*> results_of(const std::vector<MemberNumbers>& numbers) {
  std::vector<const MemberNumbers*> list;
  for (const MemberNumbers& each : numbers)
    if (each.is_result() && std::isfinite(each.largest() - each.smallest()) && !each.is_constant())
      list.push_back(&each);
  return list;
}

}  // namespace

std::int64_t sample_stride(std::int64_t members) {
  assert(members >= 0);
  std::int64_t stride = (members + kSamplesMax - 1) / kSamplesMax;
  while (stride > 1 && std::gcd(stride, members) > 1) ++stride;
  return std::max<std::int64_t>(stride, 1);
}

MemberNumbers::MemberNumbers(std::string name, std::string unit, std::string long_name, bool is_result,
                             std::int64_t members, std::vector<std::string> value_names)
    : name_(std::move(name)),
      unit_(std::move(unit)),
      long_name_(std::move(long_name)),
      is_result_(is_result),
      value_names_(std::move(value_names)),
      stride_(sample_stride(members)) {}

void MemberNumbers::add(double value) {
  if (count_++ % stride_ == 0) sample_.push_back(value);
  if (std::isnan(value)) return;
  ++known_;
  smallest_ = known_ == 1 ? value : std::min(smallest_, value);
  largest_ = known_ == 1 ? value : std::max(largest_, value);
  is_whole_ = is_whole_ && value == std::floor(value);
  mean_ += (value - mean_) / static_cast<double>(known_);
}

void MemberNumbers::bin(double value) {
  const double range = largest_ - smallest_;
  if (!std::isfinite(value) || !std::isfinite(range)) return;
  if (bins_.empty()) {
    const bool is_counted = is_whole_ && range < kBins;
    bins_.resize(is_counted ? static_cast<std::size_t>(range) + 1 : kBins);
    bins_from_ = is_counted ? smallest_ - 0.5 : smallest_;
    if (!is_counted) bin_width_ = std::max(range, 1e-300) / kBins;
  }
  const double place = std::floor((value - bins_from_) / bin_width_);
  ++bins_[static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(bins_.size() - 1)))];
}

Plot MemberNumbers::histogram() const {
  Series series{.name = name_, .look = {.form = Form::band, .tone = Tone::blue}};
  Axis axis{.label = unit_.empty() || unit_ == "1" ? name_ : name_ + ", " + unit_};
  const double known = static_cast<double>(std::reduce(bins_.begin(), bins_.end()));
  constexpr std::size_t kTicksMax = 12;
  for (std::size_t bin = 0; bin < bins_.size(); ++bin) {
    const double left = bins_from_ + static_cast<double>(bin) * bin_width_;
    for (const double x : {left, bins_from_ + static_cast<double>(bin + 1) * bin_width_}) {
      series.x.push_back(x);
      series.y.push_back(100.0 * static_cast<double>(bins_[bin]) / known);
      series.y_low.push_back(0.0);
    }
    const double number = smallest_ + static_cast<double>(bin);
    if (bins_from_ != smallest_ && bins_.size() <= kTicksMax)
      axis.ticks.push_back({number, number >= 0.0 && number < static_cast<double>(value_names_.size())
                                        ? value_names_[static_cast<std::size_t>(number)]
                                        : with_decimals(number, 0)});
  }
  return {.x = std::move(axis),
          .y = {.label = "members, %", .low = 0.0},
          .series = {std::move(series)},
          .when_empty = "no member has this number"};
}

double MemberNumbers::smallest() const { return known_ == 0 ? kNotGiven : smallest_; }
double MemberNumbers::largest() const { return known_ == 0 ? kNotGiven : largest_; }
double MemberNumbers::mean() const { return known_ == 0 ? kNotGiven : mean_; }

bool MemberNumbers::is_constant() const {
  constexpr double kRounding = 1e-9;
  return !(largest_ - smallest_ > kRounding);
}

double MemberNumbers::quantile(double part) const {
  std::vector<double> known = sample_;
  std::erase_if(known, [](double value) { return !std::isfinite(value); });
  return known.empty() ? kNotGiven : hyrax::quantile(known, part);
}

std::vector<Figure> member_figures(const std::vector<MemberNumbers>& numbers, std::int64_t members) {
  const auto results = results_of(numbers);
  std::vector<Figure> figures;
  constexpr std::size_t kPlotsOfARow = 3;
  for (std::size_t first = 0; first < results.size(); first += kPlotsOfARow) {
    std::vector<Plot> plots;
    std::string title = "How the members end: ";
    for (std::size_t at = first; at < std::min(first + kPlotsOfARow, results.size()); ++at) {
      plots.push_back(results[at]->histogram());
      title += (at == first ? "" : ", ") + results[at]->name();
    }
    figures.push_back({.suffix = "-distribution-" + std::to_string(first / kPlotsOfARow + 1),
                       .title = std::move(title),
                       .subtitle = "Share of the members with a number in each interval",
                       .note = count_note(results[first]->known() + results[first]->missing(), members),
                       .note_tone = Tone::quiet,
                       .body = std::move(plots)});
  }
  return figures;
}

Table member_table(const std::vector<MemberNumbers>& numbers) {
  const auto texts = [&](const char* name, const char* what, auto get) {
    return column_of(name, "", what, numbers, get);
  };
  const auto quantiles = [&](const char* name, double part) {
    return column_of(
        name, "", "quantile of the sample", numbers,
        [part](const MemberNumbers& each) { return each.quantile(part); }, 6);
  };
  return {
      .name = "members",
      .long_name = "range of each number over the members",
      .columns = {texts("number", "its name", &MemberNumbers::name), texts("unit", "", &MemberNumbers::unit),
                  column_of("smallest", "", "", numbers, &MemberNumbers::smallest, 6), quantiles("p10", 0.1),
                  quantiles("median", 0.5), quantiles("p90", 0.9),
                  column_of("mean", "", "", numbers, &MemberNumbers::mean, 6),
                  column_of("largest", "", "", numbers, &MemberNumbers::largest, 6),
                  column_of("missing", "", "members without it", numbers, &MemberNumbers::missing),
                  texts("meaning", "", &MemberNumbers::long_name)}};
}

}  // namespace hyrax
