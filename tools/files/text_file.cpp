#include "tools/files/text_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <sys/stat.h>

#include "tools/files/atomic_file.h"
#include "tools/files/failure.h"

namespace hyrax {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

bool is_folder(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

[[noreturn]] void fail_to_read(const std::string& path, int error_number) {
  throw Failure(ExitCode::cannot_access, path + ": cannot be read: " + std::strerror(error_number));
}

}  // namespace

std::string read_text_file(const std::string& path) {
  if (is_folder(path)) fail_to_read(path, EISDIR);
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) fail_to_read(path, errno);
  std::string text;
  char part[65536];
  for (std::size_t size = 0; (size = std::fread(part, 1, sizeof part, file.get())) > 0;)
    text.append(part, size);
  if (std::ferror(file.get()) != 0) fail_to_read(path, errno);
  return text;
}

void write_text_file(const std::string& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace hyrax
