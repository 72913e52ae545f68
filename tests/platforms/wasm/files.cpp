// The functions of tools/files that hyrax-replay needs, without <filesystem>, which WASI's C++ library
// lacks. Every path is a scenario file.
#include <cerrno>
#include <cstdio>

#include "tools/files/failure.h"
#include "tools/files/scenario_list.h"
#include "tools/files/text_file.h"

namespace hyrax {

std::vector<std::string> list_scenarios(const std::vector<std::string>& arguments) { return arguments; }

std::string read_text_file(const std::string& path) {
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) fail_to_read(path, errno);
  std::string text;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  std::fclose(file);
  return text;
}

}  // namespace hyrax
