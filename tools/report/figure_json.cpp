#include "tools/report/figure_json.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "tools/files/failure.h"
#include "tools/report/look.h"

namespace hyrax {
namespace {

template <class Of, class Value>
struct Field {
  const char* key;
  Value Of::*member;
};
template <class Of, class Value>
Field(const char*, Value Of::*) -> Field<Of, Value>;

// What each part of a figure has, by key: written and read by the same list.
constexpr auto fields_of(const Tick*) {
  return std::tuple{Field{"at", &Tick::at}, Field{"text", &Tick::text}};
}
constexpr auto fields_of(const Axis*) {
  return std::tuple{Field{"label", &Axis::label},
                    Field{"is_logarithmic", &Axis::is_logarithmic},
                    Field{"is_reversed", &Axis::is_reversed},
                    Field{"low", &Axis::low},
                    Field{"high", &Axis::high},
                    Field{"ticks", &Axis::ticks},
                    Field{"decimals", &Axis::decimals},
                    Field{"categories", &Axis::categories},
                    Field{"zero_at", &Axis::zero_at},
                    Field{"zero_text", &Axis::zero_text},
                    Field{"strip_below", &Axis::strip_below},
                    Field{"strip_name", &Axis::strip_name}};
}
constexpr auto fields_of(const Look*) {
  return std::tuple{Field{"form", &Look::form},      Field{"tone", &Look::tone},
                    Field{"width", &Look::width_px}, Field{"dash", &Look::dash},
                    Field{"marker", &Look::marker},  Field{"marker_size", &Look::marker_size}};
}
constexpr auto fields_of(const Series*) {
  return std::tuple{Field{"name", &Series::name},     Field{"look", &Series::look},
                    Field{"x", &Series::x},           Field{"y", &Series::y},
                    Field{"y_low", &Series::y_low},   Field{"x_low", &Series::x_low},
                    Field{"x_high", &Series::x_high}, Field{"point_names", &Series::point_names}};
}
constexpr auto fields_of(const Mark*) {
  return std::tuple{Field{"is_vertical", &Mark::is_vertical}, Field{"at", &Mark::at},
                    Field{"text", &Mark::text}, Field{"tone", &Mark::tone}};
}
constexpr auto fields_of(const PointText*) {
  return std::tuple{Field{"x", &PointText::x}, Field{"y", &PointText::y}, Field{"text", &PointText::text},
                    Field{"tone", &PointText::tone}};
}
constexpr auto fields_of(const TopDot*) {
  return std::tuple{Field{"x", &TopDot::x}, Field{"tone", &TopDot::tone}};
}
constexpr auto fields_of(const Span*) {
  return std::tuple{Field{"from", &Span::from}, Field{"to", &Span::to}};
}
constexpr auto fields_of(const Plot*) {
  return std::tuple{Field{"x", &Plot::x},
                    Field{"y", &Plot::y},
                    Field{"series", &Plot::series},
                    Field{"marks", &Plot::marks},
                    Field{"texts", &Plot::texts},
                    Field{"spans", &Plot::spans},
                    Field{"top_dots", &Plot::top_dots},
                    Field{"when_empty", &Plot::when_empty},
                    Field{"has_equal_scales", &Plot::has_equal_scales}};
}
using GridColumn = std::pair<std::string, Tone>;
constexpr auto fields_of(const GridColumn*) {
  return std::tuple{Field{"text", &GridColumn::first}, Field{"tone", &GridColumn::second}};
}
constexpr auto fields_of(const Cell*) {
  return std::tuple{Field{"row", &Cell::row},   Field{"column", &Cell::column}, Field{"tone", &Cell::tone},
                    Field{"text", &Cell::text}, Field{"left", &Cell::left},     Field{"right", &Cell::right}};
}
constexpr auto fields_of(const Grid*) {
  return std::tuple{Field{"rows", &Grid::rows}, Field{"columns", &Grid::columns},
                    Field{"cells", &Grid::cells}};
}
constexpr auto fields_of(const ListColumn*) {
  return std::tuple{Field{"title", &ListColumn::title}, Field{"width", &ListColumn::width_px},
                    Field{"is_right", &ListColumn::is_right}, Field{"letters_max", &ListColumn::letters_max}};
}
constexpr auto fields_of(const ListField*) {
  return std::tuple{Field{"text", &ListField::text}, Field{"detail", &ListField::detail},
                    Field{"fill", &ListField::fill}};
}
constexpr auto fields_of(const Listing*) {
  return std::tuple{Field{"list_columns", &Listing::columns}, Field{"list_rows", &Listing::rows}};
}
constexpr auto fields_of(const LegendEntry*) {
  return std::tuple{Field{"text", &LegendEntry::text}, Field{"look", &LegendEntry::look}};
}
constexpr auto fields_of(const Figure*) {
  return std::tuple{Field{"suffix", &Figure::suffix},       Field{"title", &Figure::title},
                    Field{"subtitle", &Figure::subtitle},   Field{"note", &Figure::note},
                    Field{"note_tone", &Figure::note_tone}, Field{"body", &Figure::body},
                    Field{"legend", &Figure::legend},       Field{"remarks", &Figure::remarks}};
}

constexpr const auto& names_of(const Tone*) { return kToneNames; }
constexpr auto names_of(const Form*) {
  return std::to_array<std::string_view>({"line", "points", "line_and_points", "band", "bars"});
}
constexpr auto names_of(const Dash*) {
  return std::to_array<std::string_view>({"solid", "short_dashes", "long_dashes", "dots"});
}
constexpr auto names_of(const Marker*) { return std::to_array<std::string_view>({"dot", "ring", "square"}); }

template <class Value>
constexpr const Value* kA = nullptr;

template <class Value>
Json json_of(const Value& value) {
  if constexpr (std::is_same_v<Value, double>) {
    return std::isnan(value) ? Json() : Json(value);
  } else if constexpr (std::is_integral_v<Value> && !std::is_same_v<Value, bool>) {
    constexpr std::int64_t kExactMax = std::int64_t{1} << 53;
    if (std::cmp_greater(value, kExactMax) || std::cmp_less(value, -kExactMax)) return std::to_string(value);
    return static_cast<std::int64_t>(value);
  } else if constexpr (std::is_same_v<Value, std::optional<std::int64_t>>) {
    return value ? json_of(*value) : Json();
  } else if constexpr (std::is_enum_v<Value>) {
    return names_of(kA<Value>).at(static_cast<std::size_t>(value));
  } else if constexpr (std::is_same_v<Value, decltype(Figure::body)>) {
    const auto* const plots = std::get_if<std::vector<Plot>>(&value);
    if (plots != nullptr) return Json::Object{{"plots", json_of(*plots)}};
    const auto* const grid = std::get_if<Grid>(&value);
    return grid != nullptr ? json_of(*grid) : json_of(std::get<Listing>(value));
  } else if constexpr (std::is_constructible_v<Json, Value>) {
    return value;
  } else if constexpr (requires { value.begin(); }) {
    return list_of(value, [](const auto& each) { return json_of(each); });
  } else {
    return std::apply(
        [&](const auto&... field) {
          return Json::Object{{field.key, json_of(value.*field.member)}...};
        },
        fields_of(&value));
  }
}

template <class Value>
const Value& as(const Json& json, const std::string& place, const char* what) {
  const auto* const found = json.get<Value>();
  if (found == nullptr) refuse_input(place + ": must be " + what);
  return *found;
}

double number_of(const Json& json, const std::string& place) {
  if (json.is_number()) return json.number();
  if (json.is_null()) return kNotGiven;
  const auto& text = as<std::string>(json, place, "a number or null");
  if (!text.ends_with("Infinity")) refuse_input(place + ": must be a number or null");
  return text.front() == '-' ? -HUGE_VAL : HUGE_VAL;
}

void require_whole(const auto& /*value*/, const std::string& /*place*/) {}
void require_whole(const Series& series, const std::string& place) {
  const std::size_t count = series.x.size();
  const auto is_whole = [&](const auto& list) { return list.empty() || list.size() == count; };
  if (series.y.size() != count || !is_whole(series.y_low) || !is_whole(series.x_low) ||
      series.x_low.size() != series.x_high.size() || !is_whole(series.point_names) ||
      (series.look.form == Form::band && series.y_low.size() != count))
    refuse_input(place + ": its lists must have equal lengths");
}
void require_whole(const Listing& listing, const std::string& place) {
  for (const std::vector<ListField>& row : listing.rows)
    if (row.size() != listing.columns.size()) refuse_input(place + ": list_rows: each needs all columns");
}

// A key that is missing leaves the value as it is.
template <class Value>
void read(const Json& json, const std::string& place, Value& value) {
  if constexpr (std::is_same_v<Value, double>) {
    value = number_of(json, place);
  } else if constexpr (std::is_same_v<Value, bool> || std::is_same_v<Value, std::string>) {
    value = as<Value>(json, place, std::is_same_v<Value, bool> ? "true or false" : "a text");
  } else if constexpr (std::is_integral_v<Value>) {
    const double number = number_of(json, place);
    constexpr double kLeast = std::is_signed_v<Value> ? -1.0 : 0.0, kMost = 1e6;
    if (!(number >= kLeast && number <= kMost)) refuse_input(place + ": must be a count");
    value = static_cast<Value>(number);
  } else if constexpr (std::is_enum_v<Value>) {
    const auto& names = names_of(kA<Value>);
    const auto name = std::ranges::find(names, std::string_view(as<std::string>(json, place, "a name")));
    if (name == names.end()) refuse_input(place + ": unknown name (found " + to_text(json) + ")");
    value = static_cast<Value>(name - names.begin());
  } else if constexpr (std::is_same_v<Value, decltype(Figure::body)>) {
    if (const Json* const plots = json.find("plots"))
      read(*plots, place + "/plots", value.template emplace<std::vector<Plot>>());
    else if (json.find("cells") != nullptr)
      read(json, place, value.template emplace<Grid>());
    else
      read(json, place, value.template emplace<Listing>());
  } else if constexpr (requires { value.emplace_back(); }) {
    for (const Json& each : as<Json::Array>(json, place, "a list")) {
      const std::string its_place = place + "/" + std::to_string(value.size());
      read(each, its_place, value.emplace_back());
    }
  } else {
    as<Json::Object>(json, place, "an object");
    const auto take = [&](const auto& field) {
      if (const Json* const found = json.find(field.key))
        read(*found, place + "/" + field.key, value.*field.member);
    };
    std::apply([&](const auto&... field) { (take(field), ...); }, fields_of(&value));
    require_whole(value, place);
  }
}

Json column_json(const Column& column, std::size_t rows_max) {
  assert(column.width == 1);
  Json::Array values;
  std::visit(
      [&](const auto& all) {
        using Value = typename std::decay_t<decltype(all)>::value_type;
        assert((!std::is_same_v<Value, Table>));
        if constexpr (!std::is_same_v<Value, Table>)
          for (std::size_t row = 0; row < std::min(rows_max, all.size()); ++row)
            values.push_back(json_of(static_cast<const Value&>(all[row])));
      },
      column.values);
  return Json::Object{{"name", column.name},
                      {"unit", column.unit},
                      {"long_name", column.long_name},
                      {"digits", column.digits},
                      {"values", std::move(values)}};
}

}  // namespace

Json figure_json(const Figure& figure) { return json_of(figure); }

std::vector<Figure> figures_of(const Json& json, const std::string& place) {
  std::vector<Figure> figures;
  read(json, place, figures);
  return figures;
}

Json table_json(const Table& table, std::size_t rows_max) {
  const auto column = [rows_max](const Column& each) { return column_json(each, rows_max); };
  return Json::Object{{"name", table.name},
                      {"long_name", table.long_name},
                      {"row_count", static_cast<std::int64_t>(row_count(table))},
                      {"columns", list_of(table.columns, column)}};
}

Json verdict_json(const Verdict& verdict) {
  Json::Array text;
  for (const auto& part : verdict.text) {
    const auto* const table = std::get_if<Table>(&part);
    text.push_back(table ? table_json(*table) : Json(std::get<std::string>(part)));
  }
  return Json::Object{{"text", std::move(text)}, {"broken", json_of(verdict.broken)}};
}

}  // namespace hyrax
