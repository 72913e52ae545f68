#include "tools/app/command_line/part.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <utility>

#include "tools/files/failure.h"
#include "tools/files/printable.h"

namespace hyrax {
namespace {

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

ChosenPart checked(const std::string& place, std::int64_t index, std::int64_t count, std::string source) {
  if (count < 1 || index < 0 || index >= count)
    refuse_input(fmt::format("{}: must be part I of N with 0 <= I < N (found {}/{})", place, index, count));
  return {{index, count}, std::move(source)};
}

ChosenPart parse_part(const std::string& command, const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string_view numbers = text;
  const std::int64_t index = parse_count(numbers.substr(0, slash)).value_or(-1);
  const std::int64_t count =
      slash == std::string::npos ? 0 : parse_count(numbers.substr(slash + 1)).value_or(0);
  if (index < 0 || index >= count)
    refuse_input(fmt::format("{}: --part: must be I/N with 0 <= I < N (found {})", command, text));
  return {{index, count}, ""};
}

}  // namespace

std::optional<ChosenPart> choose_part(const std::string& command, const std::string& part,
                                      std::optional<std::int64_t> parts) {
  if (!part.empty() && parts) refuse_input(command + ": --part and --parts: only one allowed");
  if (!part.empty()) return parse_part(command, part);
  const auto variable = [&](const char* name) { return read_variable(command, name); };
  if (!parts) {
    const auto task = variable("SLURM_ARRAY_TASK_ID");
    const auto tasks = variable("SLURM_ARRAY_TASK_COUNT");
    if (task && tasks)
      return checked(command + ": SLURM_ARRAY_TASK_ID", *task - variable("SLURM_ARRAY_TASK_MIN").value_or(0),
                     *tasks, "SLURM_ARRAY_TASK_ID and SLURM_ARRAY_TASK_COUNT");
    const auto rank = variable("OMPI_COMM_WORLD_RANK");
    const auto size = variable("OMPI_COMM_WORLD_SIZE");
    if (rank && size)
      return checked(command + ": OMPI_COMM_WORLD_RANK", *rank, *size,
                     "OMPI_COMM_WORLD_RANK and OMPI_COMM_WORLD_SIZE");
    for (const auto& [index, count] : {std::pair{"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT"},
                                       std::pair{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                       std::pair{"JOB_COMPLETION_INDEX", "--parts N"}})
      if (std::getenv(index) != nullptr)
        print_error(fmt::format("{}: {} without {} names no part; this process computes all of them", command,
                                index, count));
    return std::nullopt;
  }
  const auto index = variable("JOB_COMPLETION_INDEX");
  if (!index) refuse_input(command + ": --parts: needs JOB_COMPLETION_INDEX; else give --part I/N");
  return checked(command + ": JOB_COMPLETION_INDEX", *index, *parts, "JOB_COMPLETION_INDEX and --parts");
}

}  // namespace hyrax
