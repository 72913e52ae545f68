#include "tools/report/gnuplot.h"

#include <cerrno>
#include <cstring>
#include <sstream>
#include <string_view>

#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/files/atomic_file.h"
#include "tools/files/failure.h"
#include "tools/report/svg.h"

extern char** environ;

namespace hyrax {
namespace {

class Descriptor {
 public:
  Descriptor(int number, const std::string& path) : number_(number) {
    if (number_ < 0) fail_to_write(path, errno);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(number_); }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

// Script and messages stand in files in memory, not in pipes: neither side ever waits for the
// other, however long they are, and no signal comes of a gnuplot that ends early.
class MemoryFile : public Descriptor {
 public:
  explicit MemoryFile(const std::string& path) : Descriptor(memfd_create("gnuplot", MFD_CLOEXEC), path) {}

  void write_all(std::string_view text, const std::string& path) const {
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t count = pwrite(number(), text.data() + at, text.size() - at, static_cast<off_t>(at));
      if (count < 0 && errno != EINTR) fail_to_write(path, errno);
      if (count > 0) at += static_cast<std::size_t>(count);
    }
  }
  [[nodiscard]] std::string text() const {
    std::string text;
    char buffer[4096];
    for (ssize_t count = 0;
         (count = pread(number(), buffer, sizeof buffer, static_cast<off_t>(text.size()))) > 0;)
      text.append(buffer, static_cast<std::size_t>(count));
    return text;
  }
};

class SpawnFiles {
 public:
  SpawnFiles() { posix_spawn_file_actions_init(&actions_); }
  SpawnFiles(const SpawnFiles&) = delete;
  SpawnFiles& operator=(const SpawnFiles&) = delete;
  ~SpawnFiles() { posix_spawn_file_actions_destroy(&actions_); }

  void put(const Descriptor& file, int as_number) {
    posix_spawn_file_actions_adddup2(&actions_, file.number(), as_number);
  }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

[[noreturn]] void fail_to_start(const std::string& path, int error_number) {
  throw Failure(ExitCode::cannot_access,
                path + ": cannot be drawn: " +
                    (error_number == ENOENT
                         ? "gnuplot is not installed; `apt-get install gnuplot-nox`, or tools/run does it"
                         : std::string("gnuplot cannot be started: ") + std::strerror(error_number)));
}

// Starts gnuplot and waits for its end; returns how it ended, as waitpid tells it.
int run_gnuplot(const SpawnFiles& files, const std::string& path) {
  char name[] = "gnuplot";
  char without_user_settings[] = "--default-settings";
  char* const arguments[] = {name, without_user_settings, nullptr};
  pid_t child = 0;
  if (const int error = posix_spawnp(&child, name, files.get(), nullptr, arguments, environ); error != 0)
    fail_to_start(path, error);
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) fail_to_start(path, errno);
  return status;
}

// gnuplot's words in one line.
std::string in_one_line(const std::string& text) {
  std::string line;
  std::istringstream words(text);
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

}  // namespace

void draw_figure(const std::string& path, const std::string& script) {
  AtomicFile file(path);
  const MemoryFile drawing(path);
  const MemoryFile input(path);
  const MemoryFile messages(path);
  input.write_all(script, path);

  SpawnFiles files;
  files.put(input, STDIN_FILENO);
  files.put(drawing, STDOUT_FILENO);
  files.put(messages, STDERR_FILENO);
  if (run_gnuplot(files, path) != 0)
    throw Failure(ExitCode::program_fault,
                  path + ": cannot be drawn: gnuplot says: " + in_one_line(messages.text()));
  const std::string svg = drawing.text();
  if (svg.find("</svg>") == svg.npos)
    throw Failure(ExitCode::program_fault, path + ": cannot be drawn: gnuplot wrote no complete picture");
  file.write(finished_svg(svg, script));
  file.commit();
}

}  // namespace hyrax
