#include "sim/described/described_figure.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "sim/described/scripted_body.h"
#include "sim/result/number_text.h"

namespace hyrax {
namespace {

constexpr std::array kTones = {Tone::blue,   Tone::vermilion, Tone::green,
                               Tone::purple, Tone::orange,    Tone::sky_blue};
constexpr std::array kDashes = {Dash::solid, Dash::long_dashes, Dash::short_dashes, Dash::dots};
constexpr std::size_t kSeriesMax = 12;  // Of a plot; a remark says so.
constexpr std::size_t kMarksMax = 12;

// A tone and a dash together tell one curve from all others of a plot.
Look look_of(std::size_t curve) {
  return {.tone = kTones[curve % kTones.size()],
          .width_px = 2,
          .dash = kDashes[curve / kTones.size() % kDashes.size()]};
}

// A golden curve has the tone of the run's own.
constexpr Look golden_look(Tone tone) { return {.tone = tone, .width_px = 4, .dash = Dash::dots}; }

// A number, or the name that it has.
std::string value_text(const ValueInfo& value, double number) {
  if (number >= 0.0 && number < static_cast<double>(value.names.size()))
    return value.names[static_cast<std::size_t>(number)];
  return with_decimals(number, 0);
}

// The names of the values on the axis, at most so many.
void name_values(const ValueInfo& value, Axis& axis) {
  constexpr std::size_t kNamesMax = 12;
  const std::size_t every = (value.names.size() + kNamesMax - 1) / kNamesMax;
  for (std::size_t place = 0; place < value.names.size(); place += every)
    axis.ticks.push_back({static_cast<double>(place), value.names[place]});
}

std::string named(const PositionPair& pair) { return pair.name.empty() ? "position" : pair.name; }

// Whether a contact's name has that of a pair in it, as whole words: a_floor that of a.
bool is_named_after(const std::string& contact, const PositionPair& pair) {
  const auto words = [](std::string name) {
    std::ranges::replace(name, '.', '_');
    return "_" + name + "_";
  };
  return !pair.name.empty() && words(contact).find(words(pair.name)) != std::string::npos;
}

std::optional<double> input_of(const Description& description, const DescribedScenario& scenario,
                               std::string_view name) {
  const std::vector<ValueInfo>& inputs = description.inputs.values;
  const auto found = std::ranges::find(inputs, name, &ValueInfo::name);
  if (found == inputs.end()) return std::nullopt;
  Word word = found->initial;
  for (const auto& [input, given] : scenario.inputs)
    if (input == static_cast<std::size_t>(found - inputs.begin())) word = given;
  return number_of(found->type, word);
}

}  // namespace

DescribedPicture::DescribedPicture(const Description& description, const DescribedScenario& scenario)
    : description_(description),
      scenario_(scenario),
      flags_before_(description.contacts.size()),
      event_frames_(event_frames(scenario, step_count(scenario))) {}

void DescribedPicture::row(const DescribedRow& row) {
  for (; next_event_ < event_frames_.size() && event_frames_[next_event_] < row.step; ++next_event_)
    if (marks_.size() < kMarksMax)
      marks_.push_back({.at = row.t_s,
                        .text = event_name(description_, scenario_.events[next_event_].action),
                        .tone = Tone::quiet});
  Point point{.step = row.step, .t_s = row.t_s};
  for (std::size_t contact = 0; contact < row.contacts.size() && row.step == next_step_; ++contact)
    if (row.contacts[contact] != 0 && flags_before_[contact] == 0) point.contacts.push_back(contact);
  next_step_ = row.step + 1;
  flags_before_.assign(row.contacts.begin(), row.contacts.end());
  const bool is_marked = !point.contacts.empty() && contacts_.size() < kContactsMax;
  if (row.step % every_ != 0 && !is_marked) return;
  for (std::size_t value = 0; value < row.state.size(); ++value)
    point.values.push_back(number_of(description_.state.values[value].type, row.state[value]));
  for (std::size_t value = 0; value < row.outputs.size(); ++value)
    point.values.push_back(number_of(description_.outputs.values[value].type, row.outputs[value]));
  if (is_marked) contacts_.push_back(point);
  if (row.step % every_ != 0) return;
  points_.push_back(std::move(point));
  if (points_.size() <= kPointsMax) return;
  every_ *= 2;
  std::erase_if(points_, [&](const Point& each) { return each.step % every_ != 0; });
}

Plot DescribedPicture::path_plot(const std::vector<PositionPair>& pairs,
                                 const DescribedPicture* golden) const {
  Plot plot{.x = {.label = "x, px"}, .y = {.label = "y, px", .is_reversed = true}, .has_equal_scales = true};
  const auto width_px = input_of(description_, scenario_, "width_px");
  const auto height_px = input_of(description_, scenario_, "height_px");
  if (width_px && height_px)
    plot.series.push_back({.name = "width_px and height_px",
                           .look = {.tone = Tone::hairline, .width_px = 1.5},
                           .x = {0.0, *width_px, *width_px, 0.0, 0.0},
                           .y = {0.0, 0.0, *height_px, *height_px, 0.0}});
  for (std::size_t pair = 0; pair < std::min(pairs.size(), kSeriesMax); ++pair) {
    Series path{.name = named(pairs[pair]), .look = look_of(pair)};
    Series dots{.name = "contact",
                .look = {.form = Form::points, .tone = path.look.tone, .marker = Marker::ring}};
    const auto is_of_pair = [&](std::size_t contact) {
      const std::string& name = description_.contacts[contact];
      return is_named_after(name, pairs[pair]) || std::ranges::none_of(pairs, [&](const PositionPair& each) {
               return is_named_after(name, each);
             });
    };
    const auto add = [&](Series& series, const Point& point) {
      series.x.push_back(point.values[pairs[pair].x]);
      series.y.push_back(point.values[pairs[pair].y]);
    };
    if (golden != nullptr) {
      Series before{.name = named(pairs[pair]) + ", golden", .look = golden_look(path.look.tone)};
      for (const Point& point : golden->points_) add(before, point);
      plot.series.push_back(std::move(before));
    }
    for (const Point& point : points_) add(path, point);
    for (const Point& point : contacts_)
      if (std::ranges::any_of(point.contacts, is_of_pair)) add(dots, point);
    plot.texts.push_back({path.x.front(), path.y.front(), named(pairs[pair]), path.look.tone});
    plot.series.push_back(std::move(path));
    if (!dots.x.empty()) plot.series.push_back(std::move(dots));
  }
  return plot;
}

std::vector<Plot> DescribedPicture::value_plots(const std::vector<PositionPair>& pairs,
                                                const DescribedPicture* golden) const {
  std::vector<const ValueInfo*> values;
  for (const ValueInfo& value : description_.state.values) values.push_back(&value);
  for (const ValueInfo& value : description_.outputs.values) values.push_back(&value);
  std::map<std::pair<std::string, std::vector<std::string>>, Plot> plots;  // By unit and names of values.
  for (std::size_t value = 0; value < values.size(); ++value) {
    if (std::ranges::any_of(pairs,
                            [&](const PositionPair& pair) { return pair.x == value || pair.y == value; }))
      continue;
    const std::string& unit = values[value]->unit;
    Plot& plot = plots[{unit, values[value]->names}];
    if (plot.texts.size() == kSeriesMax) continue;
    const auto curve = [value](std::string name, Look look, const std::vector<Point>& points) {
      Series series{.name = std::move(name), .look = look};
      for (const Point& point : points) {
        series.x.push_back(point.t_s);
        series.y.push_back(point.values[value]);
      }
      return series;
    };
    Series series = curve(values[value]->name, look_of(plot.texts.size()), points_);
    if (golden != nullptr)
      plot.series.push_back(curve(series.name + ", golden", golden_look(series.look.tone), golden->points_));
    if (plot.texts.empty()) {
      plot.y.label = series.name + (unit.empty() ? "" : ", " + unit);
      name_values(*values[value], plot.y);
    } else {
      plot.y.label = unit.empty() ? "values without a unit" : unit;
    }
    plot.x.label = "time, s";
    plot.texts.push_back({series.x.back(), series.y.back(), series.name, series.look.tone});
    plot.series.push_back(std::move(series));
  }
  std::vector<Plot> list;
  for (auto& [kind, plot] : plots) {
    plot.marks = marks_;
    list.push_back(std::move(plot));
  }
  return list;
}

Figure DescribedPicture::figure(const std::string& subtitle, const DescribedPicture* golden) const {
  const bool is_golden_alike = golden != nullptr && !golden->points_.empty() &&
                               description_difference(golden->description_, description_).empty();
  if (!is_golden_alike) golden = nullptr;
  Figure figure{.title = scenario_.name, .subtitle = subtitle, .row_count = points_.size()};
  const std::vector<PositionPair> pairs = position_pairs(description_);
  std::vector<Plot> plots;
  if (!pairs.empty()) plots.push_back(path_plot(pairs, golden));
  std::size_t drawn = 2 * std::min(pairs.size(), kSeriesMax);
  for (Plot& plot : value_plots(pairs, golden)) {
    drawn += plot.texts.size();
    plots.push_back(std::move(plot));
  }
  if (drawn < description_.state.values.size() + description_.outputs.values.size())
    figure.remarks.emplace_back("Not all values are drawn: of each unit the first twelve.");
  if (!contacts_.empty() && !pairs.empty())
    figure.legend.push_back(
        {"position at the first row of a contact", {.form = Form::points, .marker = Marker::ring}});
  if (golden != nullptr) figure.legend.push_back({"golden file", golden_look(Tone::quiet)});
  figure.body = std::move(plots);
  return figure;
}

Table DescribedPicture::rows() const {
  Table table{.name = "rows", .long_name = "Every row"};
  const std::int64_t every = points_.size() > 1 ? points_[1].step - points_[0].step : 1;
  if (every > 1) table.long_name = "One row of every " + std::to_string(every);
  const auto add = [&](const std::string& name, const std::string& unit, const auto& value_of) {
    table.columns.push_back(column_of(name, unit, "", points_, value_of, 6));
  };
  add("step", "", &Point::step);
  add("t", "s", &Point::t_s);
  std::size_t place = 0;
  for (const ValueList* list : {&description_.state, &description_.outputs})
    for (const ValueInfo& value : list->values) {
      if (value.names.empty())
        add(value.name, "", [place](const Point& point) { return point.values[place]; });
      else
        add(value.name, "",
            [place, &value](const Point& point) { return value_text(value, point.values[place]); });
      ++place;
    }
  return table;
}

}  // namespace hyrax
