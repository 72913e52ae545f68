#include "tools/files/text_file.h"

#include <cerrno>
#include <cstdio>
#include <memory>

#include "tools/files/failure.h"
#include "tools/platform/atomic_file.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

// A recorded clock of ten million frames takes half of it; a device may never end.
constexpr std::size_t kTextMax = 256 << 20;

}  // namespace

void read_pieces(const std::string& path, const std::function<void(std::string_view piece)>& take) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(open_file(path, "rb"), std::fclose);
  if (!file) fail_to_read(path, errno);
  if (is_folder(path)) fail_to_read(path, EISDIR);
  constexpr std::size_t kPiece = 65536;  // A stack may be as small.
  const auto piece = std::make_unique_for_overwrite<char[]>(kPiece);
  while (const std::size_t size = std::fread(piece.get(), 1, kPiece, file.get())) take({piece.get(), size});
  if (std::ferror(file.get()) != 0) fail_to_read(path, errno);
}

std::string read_text_file(const std::string& path) {
  // Nobody may ever write into a named pipe. Those of a shell, as in `<(command)`, have a writer.
  if (is_device_or_pipe(path) && !path.starts_with("/dev/") && !path.starts_with("/proc/"))
    throw Failure(ExitCode::cannot_access, path + ": cannot be read: is a pipe or a device");
  std::string text;
  read_pieces(path, [&](std::string_view piece) {
    text.append(piece);
    if (text.size() > kTextMax) refuse_input(path + ": is too large; a text file has at most 256 MiB");
  });
  if (text.starts_with("version https://git-lfs.github.com/spec/"))
    refuse_input(path + ": is a Git LFS pointer to the file; to fetch that: git lfs pull");
  return text;
}

void write_text_file(const std::string& path, std::string_view text, bool may_replace) {
  AtomicFile file(path);
  file.write(text);
  if (may_replace)
    file.commit();
  else
    file.commit_as_new();
}

}  // namespace hyrax
