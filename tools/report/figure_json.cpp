#include "tools/report/figure_json.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "tools/report/look.h"

namespace hyrax {
namespace {

template <class Values, class Get>
Json::Array list_of(const Values& values, const Get& get) {
  Json::Array list;
  list.reserve(values.size());
  for (const auto& value : values) list.push_back(get(value));
  return list;
}

Json number(double value) { return std::isnan(value) ? Json() : Json(value); }
Json::Array numbers(const std::vector<double>& values) { return list_of(values, number); }

Json look_json(const Look& look) {
  constexpr std::array kForms = {"line", "points", "line_and_points", "band", "bars"};
  constexpr std::array kDashes = {"solid", "short_dashes", "long_dashes", "dots"};
  constexpr std::array kMarkers = {"dot", "ring", "square"};
  return Json::Object{{"form", kForms.at(static_cast<std::size_t>(look.form))},
                      {"tone", name_of(look.tone)},
                      {"width", look.width_px},
                      {"dash", kDashes.at(static_cast<std::size_t>(look.dash))},
                      {"marker", kMarkers.at(static_cast<std::size_t>(look.marker))},
                      {"marker_size", look.marker_size}};
}

Json axis_json(const Axis& axis) {
  const auto tick = [](const Tick& each) { return Json::Object{{"at", each.at}, {"text", each.text}}; };
  return Json::Object{{"label", axis.label},
                      {"is_logarithmic", axis.is_logarithmic},
                      {"is_reversed", axis.is_reversed},
                      {"low", number(axis.low)},
                      {"high", number(axis.high)},
                      {"ticks", list_of(axis.ticks, tick)},
                      {"decimals", axis.decimals},
                      {"categories", Json::Array(axis.categories.begin(), axis.categories.end())},
                      {"zero_at", number(axis.zero_at)},
                      {"zero_text", axis.zero_text},
                      {"strip_below", number(axis.strip_below)},
                      {"strip_name", axis.strip_name}};
}

Json series_json(const Series& series) {
  return Json::Object{{"name", series.name},
                      {"look", look_json(series.look)},
                      {"x", numbers(series.x)},
                      {"y", numbers(series.y)},
                      {"y_low", numbers(series.y_low)},
                      {"x_low", numbers(series.x_low)},
                      {"x_high", numbers(series.x_high)},
                      {"point_names", Json::Array(series.point_names.begin(), series.point_names.end())}};
}

Json plot_json(const Plot& plot) {
  const auto mark = [](const Mark& each) {
    return Json::Object{{"is_vertical", each.is_vertical},
                        {"at", number(each.at)},
                        {"text", each.text},
                        {"tone", name_of(each.tone)}};
  };
  const auto text = [](const PointText& each) {
    return Json::Object{
        {"x", number(each.x)}, {"y", number(each.y)}, {"text", each.text}, {"tone", name_of(each.tone)}};
  };
  const auto span = [](const Span& each) { return Json::Array{each.from, each.to}; };
  const auto dot = [](const TopDot& each) {
    return Json::Object{{"x", number(each.x)}, {"tone", name_of(each.tone)}};
  };
  return Json::Object{{"x", axis_json(plot.x)},
                      {"y", axis_json(plot.y)},
                      {"series", list_of(plot.series, series_json)},
                      {"marks", list_of(plot.marks, mark)},
                      {"texts", list_of(plot.texts, text)},
                      {"spans", list_of(plot.spans, span)},
                      {"top_dots", list_of(plot.top_dots, dot)},
                      {"when_empty", plot.when_empty},
                      {"has_equal_scales", plot.has_equal_scales},
                      {"share", plot.share}};
}

Json body_json(const std::vector<Plot>& plots) { return Json::Object{{"plots", list_of(plots, plot_json)}}; }

Json body_json(const Grid& grid) {
  const auto column = [](const std::pair<std::string, Tone>& each) {
    return Json::Object{{"text", each.first}, {"tone", name_of(each.second)}};
  };
  const auto cell = [](const Cell& each) {
    return Json::Object{{"row", static_cast<std::int64_t>(each.row)},
                        {"column", static_cast<std::int64_t>(each.column)},
                        {"tone", name_of(each.tone)},
                        {"text", each.text},
                        {"left", each.left},
                        {"right", each.right}};
  };
  return Json::Object{{"rows", Json::Array(grid.rows.begin(), grid.rows.end())},
                      {"columns", list_of(grid.columns, column)},
                      {"cells", list_of(grid.cells, cell)}};
}

Json body_json(const Listing& listing) {
  const auto column = [](const ListColumn& each) {
    return Json::Object{{"title", each.title}, {"is_right", each.is_right}};
  };
  const auto field = [](const ListField& each) {
    return Json::Object{{"text", each.text}, {"detail", each.detail}, {"fill", name_of(each.fill)}};
  };
  const auto row = [&](const std::vector<ListField>& each) { return list_of(each, field); };
  return Json::Object{{"list_columns", list_of(listing.columns, column)},
                      {"list_rows", list_of(listing.rows, row)}};
}

Json value_json(double value) { return number(value); }
Json value_json(std::string_view value) { return value; }
Json value_json(bool value) { return value; }
Json value_json(std::int64_t value) {
  constexpr std::int64_t kExactMax = std::int64_t{1} << 53;
  return value > kExactMax || value < -kExactMax ? Json(std::to_string(value)) : Json(value);
}
Json value_json(const std::optional<std::int64_t>& value) { return value ? value_json(*value) : Json(); }
Json value_json(const Table&) {
  assert(false);
  return {};
}

Json column_json(const Column& column, std::size_t rows_max) {
  Json::Array values;
  std::visit(
      [&](const auto& all) {
        using Value = typename std::decay_t<decltype(all)>::value_type;
        for (std::size_t row = 0; row < std::min(rows_max, all.size()); ++row)
          values.push_back(value_json(static_cast<const Value&>(all[row])));
      },
      column.values);
  return Json::Object{{"name", column.name},
                      {"unit", column.unit},
                      {"long_name", column.long_name},
                      {"digits", column.digits},
                      {"values", std::move(values)}};
}

}  // namespace

Json figure_json(const Figure& figure) {
  const auto entry = [](const LegendEntry& each) {
    return Json::Object{{"text", each.text}, {"look", look_json(each.look)}};
  };
  return Json::Object{{"suffix", figure.suffix},
                      {"title", figure.title},
                      {"subtitle", figure.subtitle},
                      {"note", figure.note},
                      {"note_tone", name_of(figure.note_tone)},
                      {"body", std::visit([](const auto& body) { return body_json(body); }, figure.body)},
                      {"legend", list_of(figure.legend, entry)},
                      {"remarks", Json::Array(figure.remarks.begin(), figure.remarks.end())}};
}

Json table_json(const Table& table, std::size_t rows_max) {
  const auto column = [&](const Column& each) { return column_json(each, rows_max); };
  return Json::Object{{"name", table.name},
                      {"long_name", table.long_name},
                      {"row_count", static_cast<std::int64_t>(row_count(table))},
                      {"columns", list_of(table.columns, column)}};
}

Json verdict_json(const Verdict& verdict) {
  const auto part = [](const auto& each) {
    const auto* const table = std::get_if<Table>(&each);
    return table ? table_json(*table) : Json(std::get<std::string>(each));
  };
  return Json::Object{{"text", list_of(verdict.text, part)},
                      {"broken", Json::Array(verdict.broken.begin(), verdict.broken.end())}};
}

}  // namespace hyrax
