#include "tools/recorder/recording.h"

#include <algorithm>

namespace hyrax {
namespace {

char name_character(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<char>(c - 'A' + 'a');
  const bool is_allowed = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
  return is_allowed ? c : '-';
}

}  // namespace

std::string numbered_path(const std::string& path, std::size_t number) {
  if (number == 1) return path;
  const FileName name = file_name(path);
  std::string numbered(name.folder);
  numbered.append(name.stem).append("-").append(std::to_string(number)).append(name.extension);
  return numbered;
}

std::string free_path(const std::string& path) {
  std::size_t number = 1;
  while (is_there(numbered_path(path, number))) ++number;
  return numbered_path(path, number);
}

std::string scenario_name_of(const std::string& path) {
  std::string name;
  for (const char c : file_name(path).stem) name += name_character(c);
  name.resize(std::min<std::size_t>(name.size(), kNameLengthMax));
  return name.empty() ? "recording" : name;
}

}  // namespace hyrax
