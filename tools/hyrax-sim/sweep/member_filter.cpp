#include "tools/hyrax-sim/sweep/member_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstring>
#include <utility>

#include "tools/files/failure.h"
#include "tools/files/json.h"
#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

[[noreturn]] void refuse_filter(const std::string& sentence) {
  throw Failure(ExitCode::bad_input, "hyrax-sim sweep: --where: " + sentence);
}

constexpr std::array<std::string_view, 6> kOrders = {"<", "<=", ">", ">=", "==", "!="};

// Words and orders, with or without blanks between them.
std::vector<std::string> tokens_of(std::string_view text) {
  constexpr std::string_view kOrderCharacters = "<>=!";
  constexpr std::string_view kBlanks = " \t\r\n";
  std::vector<std::string> tokens;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    if (text.empty()) return tokens;
    const bool is_order = kOrderCharacters.find(text.front()) != std::string_view::npos;
    const std::size_t end = is_order ? text.find_first_not_of(kOrderCharacters)
                                     : text.find_first_of(std::string(kOrderCharacters).append(kBlanks));
    tokens.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end, text.size()));
  }
}

// A field by its name: the column, and which of its values.
struct Field {
  std::string name;
  std::size_t column;
  std::size_t offset;
};

std::vector<Field> fields_of(const std::vector<EnsembleColumn>& columns) {
  std::vector<Field> fields;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    if (columns[column].type == ColumnType::byte) continue;  // A hash has no order.
    if (columns[column].width == 1) fields.push_back({columns[column].name, column, 0});
    for (std::size_t wall = 0; columns[column].width > 1 && wall < kWallNames.size(); ++wall)
      fields.push_back({fmt::format("{}.{}", columns[column].name, kWallNames[wall]), column, wall});
  }
  return fields;
}

SweepNumber parse_number(const std::string& text) {
  try {
    const Json json = parse_json(text, "");
    if (const auto* const whole = json.get<std::uint64_t>()) return *whole;
    if (const auto* const whole = json.get<std::int64_t>()) return *whole;
    if (const auto* const real = json.get<double>()) return *real;
  } catch (const Failure&) {
  }
  refuse_filter("must compare with a number (found " + text + ")");
}

std::partial_ordering compare(std::integral auto a, std::integral auto b) {
  if (std::cmp_less(a, b)) return std::partial_ordering::less;
  return std::cmp_equal(a, b) ? std::partial_ordering::equivalent : std::partial_ordering::greater;
}

// Not as doubles, which do not hold all whole numbers.
std::partial_ordering compare(std::integral auto whole, double real) {
  if (std::isnan(real)) return std::partial_ordering::unordered;
  if (real >= 0x1p64) return std::partial_ordering::less;
  if (real < -0x1p63) return std::partial_ordering::greater;
  const double below = std::floor(real);
  const auto order = below < 0.0 ? compare(whole, static_cast<std::int64_t>(below))
                                 : compare(whole, static_cast<std::uint64_t>(below));
  return order == 0 && real > below ? std::partial_ordering::less : order;
}

std::partial_ordering compare(const SweepNumber& a, const SweepNumber& b) {
  return std::visit(
      [](auto x, auto y) -> std::partial_ordering {
        if constexpr (std::is_integral_v<decltype(x)>)
          return compare(x, y);
        else if constexpr (std::is_integral_v<decltype(y)>)
          return 0 <=> compare(y, x);
        else
          return x <=> y;
      },
      a, b);
}

template <class Value>
SweepNumber load(const std::byte* from) {
  Value value{};
  std::memcpy(&value, from, sizeof value);
  return value;
}

SweepNumber load(ColumnType type, const std::byte* from) {
  if (type == ColumnType::integer) return load<std::int64_t>(from);
  return type == ColumnType::seed ? load<std::uint64_t>(from) : load<double>(from);
}

}  // namespace

MemberFilter::MemberFilter(std::string_view expression, const std::vector<EnsembleColumn>& columns) {
  const std::vector<Field> fields = fields_of(columns);
  std::vector<std::string_view> names;
  for (const Field& field : fields) names.push_back(field.name);
  const std::vector<std::string> tokens = tokens_of(expression);
  if (tokens.empty() || tokens.size() % 4 != 3)
    refuse_filter(fmt::format("must be FIELD ORDER NUMBER, joined by and / or (found {})", expression));
  any_of_.emplace_back();
  for (std::size_t at = 0; at < tokens.size(); at += 4) {
    const auto field = std::find(names.begin(), names.end(), tokens[at]);
    if (field == names.end()) refuse_filter(unknown_word("field", tokens[at], names));
    const auto order = std::find(kOrders.begin(), kOrders.end(), tokens[at + 1]);
    if (order == kOrders.end())
      refuse_filter(unknown_word("order", tokens[at + 1], {kOrders.begin(), kOrders.end()}));
    const Field& found = fields[static_cast<std::size_t>(field - names.begin())];
    any_of_.back().push_back({found.column, found.offset, static_cast<Order>(order - kOrders.begin()),
                              parse_number(tokens[at + 2])});
    if (at + 3 >= tokens.size()) break;
    if (tokens[at + 3] == "or")
      any_of_.emplace_back();
    else if (tokens[at + 3] != "and")
      refuse_filter(unknown_word("word", tokens[at + 3], {"and", "or"}));
  }
}

bool MemberFilter::meets(const Comparison& comparison, const EnsembleColumn& column,
                         const std::byte* row) const {
  const std::partial_ordering found =
      compare(load(column.type, row + comparison.offset * 8), comparison.number);
  switch (comparison.order) {
    case Order::less:
      return found < 0;
    case Order::less_equal:
      return found <= 0;
    case Order::greater:
      return found > 0;
    case Order::greater_equal:
      return found >= 0;
    case Order::equal:
      return found == 0;
    case Order::not_equal:
      return found != 0;
  }
  return false;
}

bool MemberFilter::meets(const std::vector<EnsembleColumn>& columns, const Rows& rows,
                         std::size_t row) const {
  return std::ranges::any_of(any_of_, [&](const std::vector<Comparison>& all) {
    return std::ranges::all_of(all, [&](const Comparison& one) {
      const EnsembleColumn& column = columns[one.column];
      return meets(one, column, rows[one.column].data() + row * column.row_bytes());
    });
  });
}

void MemberFilter::list(const EnsembleReader& file, const std::function<void(std::int64_t)>& take) const {
  constexpr std::int64_t kRows = 65536;
  Rows rows(file.columns().size());
  for (std::int64_t first = 0; first < file.rows(); first += kRows) {
    const std::int64_t count = std::min(kRows, file.rows() - first);
    for (const auto& all : any_of_)
      for (const Comparison& one : all) {
        rows[one.column].resize(static_cast<std::size_t>(count) * file.columns()[one.column].row_bytes());
        file.read(one.column, first, count, rows[one.column].data());
      }
    for (std::int64_t row = 0; row < count; ++row)
      if (meets(file.columns(), rows, static_cast<std::size_t>(row)))
        take(file.head().part.member(first + row));
  }
}

}  // namespace hyrax
