#include "tools/hyrax-compare/core_file.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <memory>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sim/card/compared_core.h"
#include "tools/files/failure.h"
#include "tools/files/signal_cleanup.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

Failure cannot_start() {
  return {ExitCode::cannot_access,
          std::string("a process for cores cannot be started: ") + std::strerror(errno)};
}

// In memory that both processes have.
std::shared_ptr<PlayWatch> shared_watch() {
  void* const memory =
      mmap(nullptr, sizeof(PlayWatch), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw cannot_start();
  return {static_cast<PlayWatch*>(memory), [](PlayWatch* watch) { munmap(watch, sizeof(PlayWatch)); }};
}

std::string refused_text(const BeforeAfter<std::string>& headers, int core, const std::string& reason) {
  return (core == 0 ? headers.before : headers.after) + ": refused: " + reason;
}

// A text, or a message with the exit code of its failure.
struct Outcome {
  std::string text;
  ExitCode exit_code = ExitCode::agreed;
};

Outcome outcome_of(const std::function<std::string()>& work, const BeforeAfter<std::string>& headers) {
  try {
    return {work()};
  } catch (const CoreRefused& refusal) {
    return {refused_text(headers, refusal.core, refusal.what()), ExitCode::bad_input};
  } catch (const Failure& failure) {
    return {failure.what(), failure.exit_code()};
  } catch (const std::exception& error) {
    return {std::string("hyrax-compare: internal error: ") + error.what(), ExitCode::program_fault};
  }
}

// What a core did to its process.
std::string end_text(int status, unsigned limit_s, const std::string& where) {
  if (WIFEXITED(status)) return "ends the process in " + where;
  const int signal = WTERMSIG(status);
  if (signal == SIGALRM) return fmt::format("takes more than {} s; ended in {}", limit_s, where);
  return fmt::format("crashes in {}: SIG{}", where, sigabbrev_np(signal));
}

}  // namespace

std::string in_core_process(const BeforeAfter<std::string>& headers, unsigned limit_s,
                            const TemporaryFolder& folder,
                            const std::function<std::string(PlayWatch&)>& work) {
  const std::shared_ptr<PlayWatch> shared = shared_watch();
  PlayWatch& watch = *shared;
  const std::string name = "outcome";
  const pid_t child = fork_until_end();
  if (child < 0) throw cannot_start();
  if (child == 0) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
    alarm(limit_s);
    // What a core prints is no part of the card.
    if (const int nowhere = open("/dev/null", O_WRONLY); nowhere >= 0)
      for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
    const Outcome outcome = outcome_of([&] { return work(watch); }, headers);
    watch.is_over =
        outcome_of([&] { return folder.write(name, outcome.text); }, headers).exit_code == ExitCode::agreed;
    _exit(static_cast<int>(outcome.exit_code));  // Without the destructors of cores.
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw cannot_start();
  if (!watch.is_over)
    refuse_input(refused_text(headers, watch.core, end_text(status, limit_s, watch.where())));
  std::string text = read_text_file(folder.path() + "/" + name);
  if (WEXITSTATUS(status) != 0) throw Failure(static_cast<ExitCode>(WEXITSTATUS(status)), text);
  return text;
}

}  // namespace hyrax
