#include "tools/hyrax-compare/core_file.h"

#include <csignal>
#include <filesystem>
#include <iterator>

#include <dlfcn.h>
#include <unistd.h>

#include "compile_command.h"
#include "sim/card/flings.h"
#include "sim/trajectory/state_hash.h"
#include "tools/files/child_process.h"
#include "tools/files/printable.h"
#include "tools/files/signal_cleanup.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

constexpr double kCompileLimit_s = 300.0;
constexpr double kProbeLimit_s = 60.0;
constexpr std::uint64_t kProbeSeed = 1;
constexpr std::int64_t kProbeFlings = 20;

Failure refused(const std::string& header, const std::string& reason) {
  return {ExitCode::bad_input, header + ": refused: " + reason};
}

// What the handler prints: nothing may be allocated there.
std::string crash_sentence;

void end_as_refused(int signal) {
  const std::size_t length = crash_sentence.size();
  crash_sentence[length - 3] = static_cast<char>('0' + signal / 10);
  crash_sentence[length - 2] = static_cast<char>('0' + signal % 10);
  static_cast<void>(!write(STDERR_FILENO, crash_sentence.data(), length));
  clean_up_for_signal();
  _exit(static_cast<int>(ExitCode::bad_input));
}

}  // namespace

void refuse_on_crash(const std::string& header, unsigned limit_s) {
  crash_sentence = printable(header) + ": refused: crashes, or takes more than " + std::to_string(limit_s) +
                   " s, while it is measured: signal 00\n";
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT, SIGALRM})
    std::signal(signal, end_as_refused);
  alarm(limit_s);
}

std::string compile_core(const std::string& header, const TemporaryFolder& folder, const std::string& name) {
  static_cast<void>(read_text_file(header));
  const std::string include_folder = folder.path() + "/" + name;
  std::filesystem::create_directories(include_folder + "/sim/physics");
  static_cast<void>(folder.write(name + "/sim/physics/physics.h",
                                 "#include \"" + std::filesystem::absolute(header).string() + "\"\n"));
  std::string library = include_folder + "/core.so";
  const std::string source = HYRAX_SOURCE_DIR;
  std::vector<std::string> command(std::begin(kCompileCommand), std::end(kCompileCommand));
  for (const std::string& argument : {"-I" + include_folder, "-I" + source, std::string("-o"), library,
                                      source + "/sim/card/core_library.cpp"})
    command.push_back(argument);
  const ChildEnd end = run_child(command, "", kCompileLimit_s);
  if (end.exit_code != 0 || end.is_timed_out)
    throw Failure(ExitCode::bad_input,
                  header + ": does not compile (" + end_text(end, kCompileLimit_s) + ")\n" + end.err);
  return library;
}

std::string shipped_core_library() { return HYRAX_SHIPPED_CORE; }

const CoreFunctions& load_core(const std::string& library) {
  void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const entry = handle != nullptr ? dlsym(handle, kCoreEntry) : nullptr;
  if (entry == nullptr) throw Failure(ExitCode::cannot_access, library + ": cannot be loaded: " + dlerror());
  return *reinterpret_cast<const CoreFunctions* (*)()>(entry)();
}

std::string probe_text(const CoreFunctions& core) {
  return hex(fling_digest(core, kProbeSeed, kProbeFlings)) + "\n";
}

const CoreFunctions& checked_core(const std::string& library, const std::string& header) {
  const ChildEnd end = run_child({"/proc/self/exe", kProbeOption, library}, "", kProbeLimit_s);
  if (end.exit_code != 0 || end.is_timed_out)
    throw refused(header, "does not play flings to their end: " + end_text(end, kProbeLimit_s) +
                              (end.err.empty() ? "" : "\n" + end.err));
  const CoreFunctions& core = load_core(library);
  if (const char* const defect = core.defect()) throw refused(header, defect);
  if (probe_text(core) != end.out)
    throw refused(header, "does not repeat: flings played by two processes differ");
  return core;
}

}  // namespace hyrax
