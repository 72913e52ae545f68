#include "tools/app/core/accepted_core.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <span>

#include "sim/cause/header_change.h"
#include "sim/core/traced_core.h"
#include "sim/trace/step_program.h"
#include "sim/trace/step_text.h"
#include "sim/trajectory/state_hash.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/files/failure.h"
#include "tools/files/path.h"
#include "tools/files/summary_text.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kCoreFormat = "hyrax-core/1";

std::string checksum_of(std::string_view text) { return hex(digest(std::as_bytes(std::span(text)))); }

struct CoreFiles {
  std::string header, step, accepted;
};

CoreFiles files_in(const std::string& golden_folder) {
  const std::string folder = accepted_core_folder(golden_folder);
  return {folder + "/physics.h", folder + "/step.txt", folder + "/accepted.txt"};
}

std::string constants_text(const std::string& header) {
  std::string text;
  for (const HeaderConstant& constant : header_constants(header))
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", constant.name, constant.value);
  return text;
}

// accepted.txt: a line a key, the checksum of all lines before it last.
std::string accepted_text(const AcceptedCore& core) {
  std::string text = fmt::format("{}\nclass: {}\nconstants: {}\nheader: {}\n", kCoreFormat, core.model,
                                 constants_text(core.header), checksum_of(core.header));
  text += core.step.empty() ? fmt::format("step: not complete: {}\n", core.why_incomplete)
                            : fmt::format("step: {}\n", checksum_of(core.step));
  if (!core.agreeing_cores.empty())
    text += fmt::format("agreeing: {}\n", fmt::join(core.agreeing_cores, " "));
  text += fmt::format("reason: {}\n", core.reason);
  return text + fmt::format("checksum: {}\n", checksum_of(text));
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

[[noreturn]] void refuse_core(const std::string& path, const std::string& fault) {
  throw Failure(ExitCode::disagreed, path + ": " + fault + "; take the folder from version control");
}

}  // namespace

std::string AcceptedCore::name() const { return checksum_of(step.empty() ? header : step); }

bool AcceptedCore::covers(const std::string& core_name) const {
  return core_name == name() || std::ranges::find(agreeing_cores, core_name) != agreeing_cores.end();
}

AcceptedCore program_core(const Core& core) {
  const CoreRecord& record = core.record;
  return {.model = std::string(core.name),
          .header = std::string(record.header),
          .step = std::string(record.step),
          .why_incomplete = std::string(record.why_incomplete),
          .agreeing_cores = {},
          .reason = {}};
}

std::shared_ptr<const StepProgram> program_step(const Core& core) {
  const std::optional<TracedStep> step = read_step(core.record.step);
  return step ? make_step_program(*step) : nullptr;
}

std::string accepted_core_folder(const std::string& golden_folder) { return golden_folder + "/core"; }

CoreCommands core_commands(const std::vector<std::string>& scenarios, const std::string& golden_option) {
  const auto command = [&](const char* name, std::initializer_list<const char*> options) {
    std::vector<std::string> words = {name};
    for (const std::string& path : scenarios) words.push_back(as_argument(path));
    if (!golden_option.empty()) words.insert(words.end(), {"--golden", as_argument(golden_option)});
    words.insert(words.end(), options.begin(), options.end());
    return program_command(words);
  };
  return {command("bless", {"--core", "--reason", "TEXT"}),
          command("check", {"--core", "--unnoticed", "unnoticed"})};
}

std::optional<AcceptedCore> read_accepted_core(const std::string& golden_folder) {
  const CoreFiles files = files_in(golden_folder);
  if (!is_there(files.accepted)) {
    for (const std::string& path : {files.header, files.step})
      if (is_there(path)) refuse_core(files.accepted, "is missing, but " + path + " exists: half written");
    return std::nullopt;
  }
  for (const std::string& path : {files.header, files.step, files.accepted})
    if (is_device_or_pipe(path)) refuse_core(path, "is a pipe or a device");
  const std::string accepted = read_text_file(files.accepted);
  AcceptedCore core;
  core.model = line_value(accepted, "class: ");
  core.agreeing_cores = words_of(line_value(accepted, "agreeing: "));
  core.reason = line_value(accepted, "reason: ");
  const std::string step_line = line_value(accepted, "step: ");
  constexpr std::string_view kNotComplete = "not complete: ";
  const bool has_step = !step_line.starts_with(kNotComplete);
  if (!has_step) core.why_incomplete = step_line.substr(kNotComplete.size());
  if (!accepted.starts_with(fmt::format("{}\n", kCoreFormat)))
    refuse_core(files.accepted, fmt::format("must begin with {}", kCoreFormat));
  if (!is_there(files.header)) refuse_core(files.header, "is missing");
  core.header = read_text_file(files.header);
  if (checksum_of(core.header) != line_value(accepted, "header: "))
    refuse_core(files.header, "does not have the checksum in accepted.txt");
  if (has_step != is_there(files.step))
    refuse_core(files.step, has_step ? "is missing" : "is not in accepted.txt");
  if (has_step) core.step = read_text_file(files.step);
  if (has_step && checksum_of(core.step) != step_line)
    refuse_core(files.step, "does not have the checksum in accepted.txt");
  if (has_step && !read_step(core.step)) refuse_core(files.step, "is not the canonical text of a step");
  if (accepted_text(core) != accepted) refuse_core(files.accepted, "was changed after it was written");
  return core;
}

std::optional<Core> accepted_step(const std::string& golden_folder) try {
  const std::optional<AcceptedCore> accepted = read_accepted_core(golden_folder);
  const std::optional<TracedStep> step = accepted ? read_step(accepted->step) : std::nullopt;
  return step ? traced_core(*step) : std::nullopt;
} catch (const Failure&) {
  return std::nullopt;  // `check` reports it.
}

void write_accepted_core(const std::string& golden_folder, const AcceptedCore& core) {
  const CoreFiles files = files_in(golden_folder);
  std::error_code error;
  fs::create_directories(accepted_core_folder(golden_folder), error);
  write_text_file(files.header, core.header);
  if (!core.step.empty())
    write_text_file(files.step, core.step);
  else
    fs::remove(files.step, error);
  write_text_file(files.accepted, accepted_text(core));
}

}  // namespace hyrax
