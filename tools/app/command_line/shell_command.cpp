#include "tools/app/command_line/shell_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "tools/files/golden_place.h"
#include "tools/files/printable.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

std::string program_called = "hyrax-sim";

bool is_plain(char c) {
  constexpr std::string_view kPlain = "@%+=:,./_-";
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         kPlain.find(c) != std::string_view::npos;
}

// Escapes have three octal digits, so that a digit that follows is not part of them.
std::string shell_word(std::string_view argument) {
  std::string in_quotes;
  std::string escaped;
  bool is_all_plain = !argument.empty();
  bool needs_escapes = false;
  for (std::size_t at = 0, bytes = 0; at < argument.size(); at += bytes) {
    const Utf8Character character = utf8_character(argument, at);
    bytes = character.bytes;
    const std::string_view text = argument.substr(at, bytes);
    is_all_plain = is_all_plain && bytes == 1 && is_plain(text[0]);
    in_quotes += text == "'" ? "'\\''" : text;
    if (character.code < 0 || is_control(character.code)) {
      needs_escapes = true;
      for (const char byte : text) escaped += fmt::format("\\{:03o}", static_cast<unsigned char>(byte));
    } else {
      escaped.append(text == "'" || text == "\\" ? "\\" : "").append(text);
    }
  }
  if (is_all_plain) return std::string(argument);
  return needs_escapes ? "$'" + escaped + "'" : "'" + in_quotes + "'";
}

}  // namespace

std::string shell_command(const std::vector<std::string>& arguments) {
  std::string line;
  for (const std::string& argument : arguments)
    line.append(line.empty() ? "" : " ").append(shell_word(argument));
  return line;
}

void set_program(const std::string& as_called) {
  program_called = as_called;
  name_program("hyrax-sim", std::filesystem::path(as_called).filename().string());
}

std::string program_command(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), program_called);
  return shell_command(arguments);
}

std::string as_argument(const std::string& path) { return path.starts_with('-') ? "./" + path : path; }

std::string diff_commands(const std::string& scenario_path, const std::string& h5_path) {
  return program_command({"run", as_argument(scenario_path), "-o", "now.h5"}) + "; " +
         program_command({"diff", as_argument(h5_path), "now.h5"});
}

std::string bless_command_for(const std::vector<std::string>& paths, const std::string& golden_folder) {
  const std::string scenario_path = is_folder(paths.front()) ? paths.front() + "/x.json" : paths.front();
  const auto by_path = golden_place(scenario_path, "");
  const auto place = golden_place(scenario_path, golden_folder);
  std::vector<std::string> arguments = {"bless"};
  for (const std::string& path : paths) arguments.push_back(as_argument(path));
  std::string command = program_command(arguments);
  if (!by_path || !place || by_path->h5_path != place->h5_path)
    command += " --golden " + shell_word(golden_folder.empty() ? "golden" : as_argument(golden_folder));
  return command + " --reason \"...\"";
}

}  // namespace hyrax
