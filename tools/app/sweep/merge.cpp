#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "tools/app/command_line/print.h"
#include "tools/app/sweep/sweep_run.h"
#include "tools/files/failure.h"
#include "tools/files/printable.h"
#include "tools/platform/process.h"

namespace hyrax {
namespace {

std::string core_text(const std::string& core) { return core.empty() ? "not named" : printable(core); }

using Parts = std::map<std::int64_t, std::unique_ptr<EnsembleReader>>;

void add_part(const std::string& path, const ReadContents& read_contents, Parts& parts) {
  auto reader = std::make_unique<EnsembleReader>(path, read_contents);
  const auto refuse = [&](const std::string& sentence) { refuse_input(path + ": " + sentence); };
  const EnsembleHead& head = reader->head();
  if (!head.is_part) refuse("is no part of a sweep, but a complete one");
  if (!parts.empty()) {
    const EnsembleHead& first = parts.begin()->second->head();
    if (head.sweep_text != first.sweep_text) refuse("is a part of another sweep than the first file");
    if (head.physics != first.physics)
      refuse(fmt::format("was computed by the physics model {}, the first file by {}",
                         printable(head.physics), printable(first.physics)));
    if (head.core != first.core)
      refuse(
          fmt::format("was computed by another core than the first file ({}, the first file: {}); compute "
                      "all parts with one program",
                      core_text(head.core), core_text(first.core)));
    if (head.part.count != first.part.count)
      refuse(fmt::format("is one of {} parts, the first file one of {}", head.part.count, first.part.count));
  }
  if (!parts.emplace(head.part.index, std::move(reader)).second)
    refuse(fmt::format("part {} is given twice", head.part.index));
}

// The name that a missing part has, if it is named as the first one.
std::string missing_path(const std::string& known_path, const WorkPart& known, std::int64_t index) {
  const std::string mark = fmt::format(".part-{}-of-{}", known.index, known.count);
  const std::size_t at = known_path.rfind(mark);
  const std::string name = fmt::format(".part-{}-of-{}", index, known.count);
  return at == std::string::npos ? "part" + name.substr(5)
                                 : known_path.substr(0, at) + name + known_path.substr(at + mark.size());
}

// Puts a part's rows where they belong among those of all parts.
void put_rows(const Column& rows, const WorkPart& part, Column& all) {
  const auto part_rows = static_cast<std::int64_t>(length(rows));
  with_numbers(all, [&](auto& to) {
    with_numbers(rows, [&](const auto& from) {
      for (std::int64_t row = 0; row < part_rows; ++row)
        std::copy_n(from.data() + static_cast<std::size_t>(row) * rows.width, rows.width,
                    to.data() + static_cast<std::size_t>(part.member(row)) * rows.width);
    });
  });
}

void write_merged(const Parts& parts, const EnsembleHead& head, const std::string& output) {
  const EnsembleReader& first_part = *parts.begin()->second;
  EnsembleWriter writer(output, head, first_part.tables());
  constexpr std::int64_t kRows = 1 << 16;
  const std::int64_t stride = std::ssize(parts);
  const std::int64_t rows_at_once = std::max<std::int64_t>(1, kRows / stride) * stride;
  std::vector<Table> merged = first_part.tables(), of_part = merged;
  Progress progress("members", head.members);
  while (writer.rows_done() < head.members) {
    const std::int64_t count = std::min(rows_at_once, head.members - writer.rows_done());
    for (std::size_t table = 0; table < merged.size(); ++table)
      for (std::size_t column = 0; column < merged[table].columns.size(); ++column) {
        Column& all = merged[table].columns[column];
        with_numbers(all, [&](auto& values) { values.resize(static_cast<std::size_t>(count) * all.width); });
        for (const auto& [index, part] : parts) {
          const WorkPart place{index, stride};
          const std::int64_t first = writer.rows_done() / stride;
          Column& rows = of_part[table].columns[column];
          part->read(table, column, first, place.rows(writer.rows_done() + count) - first, rows);
          put_rows(rows, place, all);
        }
      }
    writer.write(merged, count);
    progress.show(writer.rows_done());
  }
  writer.finish();
}

}  // namespace

MergeOutcome merge_parts(const std::vector<std::string>& paths, const ReadContents& read_contents,
                         const std::string& output) {
  allow_open_files(paths.size());  // All parts are open at once.
  Parts parts;
  for (const std::string& path : paths) add_part(path, read_contents, parts);
  const EnsembleReader& first = *parts.begin()->second;
  const EnsembleHead& known = first.head();
  MergeOutcome outcome{.head = known, .missing = {}};
  outcome.head.part = {};
  outcome.head.is_part = false;
  for (std::int64_t index = 0; index < known.part.count; ++index)
    if (!parts.contains(index)) outcome.missing.push_back(missing_path(first.path(), known.part, index));
  if (outcome.missing.empty()) write_merged(parts, outcome.head, output);
  return outcome;
}

}  // namespace hyrax
