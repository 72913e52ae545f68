#include "tools/app/command_line/part.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "tools/files/failure.h"
#include "tools/files/printable.h"

namespace hyrax {
namespace {

// Index, count, first index and step of the indices of parts, by variables or, of the count, by an option.
constexpr const char* kPartNames[][4] = {
    {"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_STEP"},
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "", ""},
    {"JOB_COMPLETION_INDEX", "--parts", "", ""}};

bool is_option(const char* name) { return *name == '-'; }

std::optional<std::int64_t> parse_count(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0) return std::nullopt;
  return value;
}

std::optional<std::int64_t> read_variable(const std::string& command, const char* name) {
  const char* const text = std::getenv(name);
  if (text == nullptr || *text == '\0') return std::nullopt;
  const auto value = parse_count(text);
  if (!value)
    refuse_input(fmt::format("{}: {}: must be a whole number of at least 0 (found {})", command, name, text));
  return value;
}

WorkPart parse_part(const std::string& command, const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string_view numbers = text;
  const std::int64_t index = parse_count(numbers.substr(0, slash)).value_or(-1);
  const std::int64_t count =
      slash == std::string::npos ? 0 : parse_count(numbers.substr(slash + 1)).value_or(0);
  if (index < 0 || index >= count)
    refuse_input(fmt::format("{}: --part: must be I/N with 0 <= I < N (found {})", command, text));
  return {index, count};
}

}  // namespace

std::optional<WorkPart> choose_part(const std::string& command, const std::string& part,
                                    std::optional<std::int64_t> parts) {
  if (!part.empty() && parts) refuse_input(command + ": --part and --parts: only one allowed");
  if (!part.empty()) return parse_part(command, part);
  const auto variable = [&](const char* name) { return read_variable(command, name); };
  for (const auto& [index_name, count_name, first_name, step_name] : kPartNames) {
    if (parts.has_value() != is_option(count_name)) continue;
    const auto index = variable(index_name), count = parts ? parts : variable(count_name);
    if (!index || !count) continue;
    const std::int64_t step = std::max<std::int64_t>(variable(step_name).value_or(1), 1);
    const std::int64_t offset = *index - variable(first_name).value_or(0);
    if (offset % step != 0)
      refuse_input(fmt::format("{}: {}: must be a multiple of {} after the first one (found {})", command,
                               index_name, step_name, *index));
    const WorkPart chosen{offset / step, *count};
    if (chosen.count < 1 || chosen.index < 0 || chosen.index >= chosen.count)
      refuse_input(fmt::format("{}: {}: must be part I of N with 0 <= I < N (found {}/{})", command,
                               index_name, chosen.index, chosen.count));
    print_error(fmt::format("{}: part {}/{}, from {} and {}", command, chosen.index, chosen.count, index_name,
                            count_name));
    return chosen;
  }
  if (parts) refuse_input(command + ": --parts: needs JOB_COMPLETION_INDEX; else give --part I/N");
  for (const auto& [index_name, count_name, first_name, step_name] : kPartNames)
    if (std::getenv(index_name) != nullptr)
      print_error(fmt::format("{}: {} without {}{} names no part; this process computes all of them", command,
                              index_name, count_name, is_option(count_name) ? " N" : ""));
  return std::nullopt;
}

}  // namespace hyrax
