#include "tools/app/command_line/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

// The text as a number, whatever the locale; nothing if it is no number, or out of range.
template <class Number>
std::optional<Number> parse_number(const std::string& text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

// Reads a number `low` .. `high`.
template <class Number>
std::function<void(const std::string&)> reader(std::optional<Number>& into, const std::string& names,
                                               Number low, Number high, const std::string& rule) {
  return [=, &into](const std::string& value) {
    into = parse_number<Number>(value);
    if (!into || !(*into >= low && *into <= high))
      refuse_input(fmt::format("{}: must be a {} (found {})", names, rule, value));
  };
}

// Two columns; names too wide for the first one get a line of their own.
std::string help_line(const std::string& names, const std::string& help) {
  constexpr std::size_t kColumn = 30;
  constexpr std::size_t kHelpWidth = 70;
  const std::string gap(kColumn, ' ');
  std::string text = "  " + names;
  text += text.size() < kColumn ? std::string(kColumn - text.size(), ' ') : "\n" + gap;
  std::istringstream lines(help);
  for (std::string line, begin; std::getline(lines, line); begin = "\n" + gap) {
    text += begin;
    for (std::size_t end = 0; line.size() > kHelpWidth; line.erase(0, end + 1)) {
      end = line.rfind(' ', kHelpWidth);
      if (end == std::string::npos) break;
      text += line.substr(0, end) + "\n" + gap;
    }
    text += line;
  }
  return text + "\n";
}

std::string with_argument(const OptionText& text) {
  return text.value.empty() ? text.names : text.names + " " + text.value;
}

}  // namespace

void refuse_usage(const std::string& command, const std::string& what) {
  refuse_input(command + ": " + what + "; see `" + command + " --help`");
}

bool Options::Option::is_named(std::string_view name) const {
  return fmt::format(",{},", text.names).find(fmt::format(",{},", name)) != std::string::npos;
}

void Options::add(const OptionText& text, Kind kind, std::function<void(const std::string& value)> set) {
  options_.push_back({text, kind, std::move(set)});
}

void Options::files(std::vector<std::string>& into, const OptionText& text, int least, int most,
                    const std::string& when_missing) {
  files_ = &into;
  files_text_ = text;
  when_missing_ = when_missing;
  least_ = least;
  most_ = most;
}

void Options::flag(bool& into, const OptionText& text) {
  add(text, Kind::flag, [&into](const std::string&) { into = true; });
}

void Options::text(std::string& into, const OptionText& text) {
  add(text, Kind::once, [&into](const std::string& value) { into = value; });
}

void Options::texts(std::vector<std::string>& into, const OptionText& text) {
  add(text, Kind::repeated, [&into](const std::string& value) { into.push_back(value); });
}

void Options::number(std::optional<double>& into, const OptionText& text, double low) {
  add(text, Kind::once,
      reader(into, text.names, low, std::numeric_limits<double>::max(),
             fmt::format("number of at least {}", low)));
}

void Options::integer(std::optional<std::int64_t>& into, const OptionText& text, std::int64_t low,
                      std::int64_t high) {
  add(text, Kind::once, reader(into, text.names, low, high, fmt::format("whole number {} .. {}", low, high)));
}

void Options::seed(std::optional<std::uint64_t>& into, const OptionText& text) {
  constexpr std::uint64_t kHigh = std::numeric_limits<std::uint64_t>::max();
  add(text, Kind::once,
      reader(into, text.names, std::uint64_t{0}, kHigh, fmt::format("whole number 0 .. {}", kHigh)));
}

void Options::time(std::optional<double>& into_s, const OptionText& text) {
  add(text, Kind::once, [&into_s, names = text.names](const std::string& value) {
    constexpr std::string_view kUnits = "smh";
    const std::size_t unit = kUnits.find(value.back());
    const auto number =
        parse_number<double>(unit == std::string::npos ? value : value.substr(0, value.size() - 1));
    const double time_s = number.value_or(0.0) * (unit == 1 ? 60.0 : unit == 2 ? 3600.0 : 1.0);
    if (!(time_s > 0.0) || !std::isfinite(time_s))
      refuse_input(names + ": must be a time above 0, as 60s, 5m or 2h (found " + value + ")");
    into_s = time_s;
  });
}

void Options::add_choice(OptionText text, Kind option_kind, const std::vector<std::string>& allowed,
                         const std::string& kind, std::function<void(const std::string& value)> set) {
  const std::string names = text.names;
  if (allowed.size() > 1 && text.value.find('|') == std::string::npos)
    text.help += fmt::format(":\n{}", fmt::join(allowed, ", "));
  add(text, option_kind, [=](const std::string& value) {
    if (std::find(allowed.begin(), allowed.end(), value) == allowed.end())
      refuse_input(names + ": " + unknown_word(kind, value, {allowed.begin(), allowed.end()}));
    set(value);
  });
}

void Options::choice(std::string& into, const OptionText& text, const std::vector<std::string>& allowed) {
  add_choice(text, Kind::once, allowed, "value", [&into](const std::string& value) { into = value; });
}

void Options::choices(std::vector<std::string>& into, const OptionText& text,
                      const std::vector<std::string>& allowed, const std::string& kind) {
  add_choice(text, Kind::repeated, allowed, kind,
             [&into](const std::string& value) { into.push_back(value); });
}

void Options::removed(const std::string& names, const std::string& instead) {
  add({names, "", instead}, Kind::removed, {});
}

void Options::printing(Printing& into, const std::string& verbose_help) {
  flag(into.is_json, {"--json", "", "one JSON document instead of the text"});
  const auto detail = [&](const OptionText& text, Printing::Detail value) {
    add(text, Kind::flag, [&into, value](const std::string&) { into.detail = value; });
  };
  detail({"-q,--quiet", "", "print errors and verdicts only"}, Printing::Detail::verdict);
  detail({"-v,--verbose", "", verbose_help}, Printing::Detail::all);
}

std::vector<std::string_view> Options::names() const {
  std::vector<std::string_view> names;
  for (const Option& option : options_) {
    if (!option.is_listed()) continue;
    const std::string_view all = option.text.names;
    names.push_back(all.substr(all.rfind(',') + 1));
  }
  names.push_back("--help");
  return names;
}

Options::Option& Options::find(const std::string& name) {
  const auto option =
      std::find_if(options_.begin(), options_.end(), [&](const Option& each) { return each.is_named(name); });
  if (option == options_.end()) refuse_input(unknown_word("option", name, names()));
  return *option;
}

bool Options::parse(const std::string& command, const std::vector<std::string>& arguments) {
  try {
    return read(arguments);
  } catch (const Failure& failure) {
    refuse_usage(command, failure.what());
  }
}

bool Options::read(const std::vector<std::string>& arguments) {
  std::vector<std::string> files;
  for (auto argument = arguments.begin(); argument != arguments.end(); ++argument) {
    if (*argument == "--") {
      files.insert(files.end(), argument + 1, arguments.end());
      break;
    }
    if (*argument == "-h" || *argument == "--help") return false;
    if (argument->size() < 2 || argument->front() != '-')
      files.push_back(*argument);
    else
      argument = read_option(argument, arguments.end() - 1);
  }
  set_files(std::move(files));
  return true;
}

Options::Argument Options::read_option(Argument argument, Argument last) {
  const bool is_long = argument->starts_with("--");
  const std::size_t name_end = is_long ? std::min(argument->find('='), argument->size()) : 2;
  const std::string name = argument->substr(0, name_end);
  Option& option = find(name);
  if (option.kind == Kind::removed) refuse_input(name + ": was removed; " + option.text.help);
  const bool has_value = name_end < argument->size();
  if (option.kind == Kind::flag) {
    if (has_value) refuse_input(name + ": takes no value (found " + *argument + ")");
    option.set("");
    return argument;
  }
  if (!has_value && argument == last) refuse_input(name + ": value is missing: " + option.text.value);
  if (option.kind == Kind::once && std::exchange(option.is_given, true)) refuse_input(name + ": given twice");
  const std::string value = has_value ? argument->substr(name_end + (is_long ? 1 : 0)) : *++argument;
  if (value.empty()) refuse_input(name + ": must not be empty");
  option.set(value);
  return argument;
}

void Options::set_files(std::vector<std::string> files) const {
  const auto count = static_cast<std::int64_t>(files.size());
  if (files_ == nullptr && count > 0) refuse_input(files.front() + ": this command takes no files");
  if (count < least_ && !when_missing_.empty()) refuse_input(when_missing_);
  if (count < least_)
    refuse_input(fmt::format("{}: at least {} needed (found {})", files_text_.names, least_, count));
  if (most_ >= 0 && count > most_)
    refuse_input(fmt::format("{}: at most {} allowed (found {})", files_text_.names, most_, count));
  if (std::find(files.begin(), files.end(), "") != files.end())
    refuse_input(files_text_.names + ": must not be empty");
  if (files_ != nullptr) *files_ = std::move(files);
}

std::string Options::help(const std::string& command) const {
  std::string usage = "Usage: " + command + " [OPTION]...";
  std::string text;
  if (files_ != nullptr) {
    const bool is_list = most_ < 0;
    usage +=
        (least_ == 0 ? " [" + files_text_.names + "]" : " " + files_text_.names) + (is_list ? "..." : "");
    text = "\nArguments:\n" + help_line(files_text_.names, files_text_.help);
  }
  text += "\nOptions:\n";
  for (const Option& option : options_)
    if (option.is_listed()) text += help_line(with_argument(option.text), option.text.help);
  return usage + "\n" + text + help_line("-h,--help", "print this help");
}

}  // namespace hyrax
