#include "tools/hyrax-compare/core_file.h"

#include <filesystem>
#include <iterator>

#include <dlfcn.h>

#include "compile_command.h"
#include "sim/card/core_in_use.h"
#include "tools/files/child_process.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

constexpr double kCompileLimit_s = 300.0;

}  // namespace

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

const CoreFunctions& load_core(const std::string& library, int number, PlayWatch& watch) {
  watch.core = number;
  watch.set_place("its initialisation");
  void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const entry = handle != nullptr ? dlsym(handle, kCoreEntry) : nullptr;
  if (entry == nullptr) throw Failure(ExitCode::cannot_access, library + ": cannot be loaded: " + dlerror());
  require_usual_arithmetic(number, watch.place.data());
  return *reinterpret_cast<CoreEntry*>(entry)(number, &watch.updates);
}

}  // namespace hyrax
