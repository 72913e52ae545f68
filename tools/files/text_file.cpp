#include "tools/files/text_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "tools/files/atomic_file.h"
#include "tools/files/failure.h"
#include "tools/files/path.h"

namespace hyrax {
namespace {

// A recorded clock of ten million frames takes half of it; a device may never end.
constexpr std::size_t kTextMax = 256 << 20;

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

[[noreturn]] void fail_to_read(const std::string& path, int error_number) {
  throw Failure(ExitCode::cannot_access, path + ": cannot be read: " + std::strerror(error_number));
}

}  // namespace

std::string read_text_file(const std::string& path) {
  // Nobody may ever write into a named pipe. Those of a shell, as in `<(command)`, have a writer.
  if (is_device_or_pipe(path) && !path.starts_with("/dev/") && !path.starts_with("/proc/"))
    throw Failure(ExitCode::cannot_access, path + ": cannot be read: is a pipe or a device");
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) fail_to_read(path, errno);
  if (is_folder(path)) fail_to_read(path, EISDIR);
  std::string text;
  char part[65536];
  for (std::size_t size = 0; (size = std::fread(part, 1, sizeof part, file.get())) > 0;) {
    text.append(part, size);
    if (text.size() > kTextMax)
      throw Failure(ExitCode::bad_input, path + ": is too large; a text file has at most 256 MiB");
  }
  if (std::ferror(file.get()) != 0) fail_to_read(path, errno);
  return text;
}

void write_text_file(const std::string& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace hyrax
