#include "tools/app/sweep/member_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/motion/state.h"
#include "sim/result/number_text.h"
#include "tools/files/failure.h"
#include "tools/store/table_file.h"

namespace hyrax {
namespace {

// Every row is read, or of a very long file every K-th.
std::int64_t rows_between_read(const EnsembleReader& reader) {
  constexpr std::int64_t kReadMax = 100'000'000;
  return reader.rows() <= kReadMax ? 1 : sample_stride(reader.rows());
}

// All numbers of a column: one, or of the paper's contacts one a wall.
void add_numbers(std::vector<MemberNumbers>& all, const EnsembleReader& reader, std::size_t table,
                 std::size_t index) {
  const auto& [group, long_name, columns, form] = reader.tables()[table];
  const Column& column = columns[index];
  if (std::holds_alternative<Codes>(column.values)) return;
  const bool is_result = group.starts_with("members");
  const std::string name = group.starts_with("members/") ? group.substr(8) + " " + column.name : column.name;
  const std::size_t first = all.size();
  const std::int64_t between = rows_between_read(reader);
  for (std::size_t part = 0; part < column.width; ++part)
    all.emplace_back(column.width == 1 ? name : name + "." + std::string(kWallNames.at(part)), column.unit,
                     column.long_name, is_result, (reader.rows() + between - 1) / between,
                     column.value_names);
  const std::int64_t rows_at_once = between == 1 ? 1 << 16 : 1;
  Column rows = column;
  for (const auto take : {&MemberNumbers::add, &MemberNumbers::bin}) {
    if (take == &MemberNumbers::bin && !is_result) continue;
    for (std::int64_t row = 0; row < reader.rows(); row += std::max(rows_at_once, between)) {
      reader.read(table, index, row, std::min(rows_at_once, reader.rows() - row), rows);
      with_numbers(rows, [&](const auto& values) {
        for (std::size_t value = 0; value < values.size(); ++value)
          (all[first + value % column.width].*take)(static_cast<double>(values[value]));
      });
    }
  }
}

// Results that are the same in all members within rounding.
std::string constants_text(const std::vector<MemberNumbers>& numbers) {
  std::string text;
  for (const MemberNumbers& each : numbers) {
    if (!each.is_result() || each.known() == 0 || !each.is_constant()) continue;
    const bool is_zero = std::abs(each.mean()) < 1e-9;
    const bool is_rounded = is_zero && (each.largest() != 0.0 || each.smallest() != 0.0);
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", each.name(),
                        is_zero ? "0" : rounded(each.mean(), 6),
                        each.unit() == "1" || each.unit().empty() ? "" : " " + each.unit());
    if (is_rounded) text += " (rounding)";
  }
  return text;
}

std::string count_text(std::int64_t count) { return with_decimals(static_cast<double>(count), 0); }

}  // namespace

std::int64_t rows_between_samples(const EnsembleReader& reader) {
  const std::int64_t between = rows_between_read(reader);
  return between * sample_stride((reader.rows() + between - 1) / between);
}

std::vector<MemberNumbers> member_numbers(const EnsembleReader& reader) {
  std::vector<MemberNumbers> numbers;
  for (std::size_t table = 0; table < reader.tables().size(); ++table)
    for (std::size_t column = 0; column < reader.tables()[table].columns.size(); ++column)
      add_numbers(numbers, reader, table, column);
  return numbers;
}

ShownResult member_result(const EnsembleReader& reader, const std::vector<MemberNumbers>& numbers,
                          const std::string& title, const std::string& noun) {
  const SweepPlan& sweep = reader.plan();
  std::string varied;
  for (const VariedKey& key : sweep.vary) varied += (varied.empty() ? "" : ", ") + key.pointer;
  ShownResult result{.title = title,
                     .subtitle = fmt::format("{}, varied in {}", counted(sweep.members, noun), varied),
                     .tables = {member_table(numbers)},
                     .figures = member_figures(numbers, reader.rows()),
                     .origin = {{"file", reader.path()},
                                {"seed of the draws", std::to_string(sweep.seed)},
                                {"sweep", reader.head().sweep_text}}};
  auto& text = result.verdict.text;
  if (reader.head().is_part)
    text.emplace_back(fmt::format("Part {} of {} of the sweep: {} members.", reader.head().part.index,
                                  reader.head().part.count, count_text(reader.rows())));
  if (const std::int64_t between = rows_between_read(reader); between > 1)
    text.emplace_back(fmt::format("All numbers are those of a sample: 1 of every {} of {} members.", between,
                                  count_text(reader.rows())));
  for (const MemberNumbers& each : numbers)
    if (each.name() == "at_rest_since")
      text.emplace_back(fmt::format("{} of {} members have settled by the end.", count_text(each.known()),
                                    count_text(each.known() + each.missing())));
  if (const std::string constants = constants_text(numbers); !constants.empty())
    text.emplace_back("The same in all members: " + constants + ".");
  return result;
}

std::vector<ShownResult> shown_sweeps(const std::vector<std::string>& files, const std::string& against,
                                      const std::function<ShownResult(const std::string& path)>& show) {
  if (!against.empty())
    refuse_input("hyrax-sim report: --against: allowed for trajectories only (found " + files.front() + ")");
  std::vector<ShownResult> results;
  for (const std::string& path : files) {
    if (format_of_file(path) != kEnsembleFormat)
      refuse_input(path + ": is not a sweep's file, as " + files.front() +
                   " is; a page shows either trajectories or sweeps");
    results.push_back(show(path));
  }
  return results;
}

}  // namespace hyrax
