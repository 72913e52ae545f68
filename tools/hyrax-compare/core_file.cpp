#include "tools/hyrax-compare/core_file.h"

#include <filesystem>
#include <future>
#include <iterator>
#include <regex>

#include <dlfcn.h>
#include <fmt/format.h>

#include "compile_command.h"
#include "tools/files/child_process.h"
#include "tools/files/failure.h"
#include "tools/files/path.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

constexpr double kCompileLimit_s = 300.0;
constexpr char kProjectHeader[] = HYRAX_SOURCE_DIR "/sim/physics/physics.h";

// The first error among a compiler's messages, "physics.h:41: 'm_w' was not declared in this scope".
std::string first_error(const std::string& messages) {
  static const std::regex error("([^/\n:]*:[0-9]+):[0-9]+: (?:fatal )?error: ([^\n]*)");
  std::smatch found;
  if (std::regex_search(messages, found, error)) return found[1].str() + ": " + found[2].str();
  return messages.substr(0, messages.find('\n'));
}

// The header, without its macros for what includes it: they may have any names.
std::string included_text(const std::string& header, const std::string& text) {
  std::string including =
      fmt::format("#pragma once\n#include \"{}\"\n", std::filesystem::absolute(header).string());
  static const std::regex macro("(?:^|\n)[ \t]*#[ \t]*define[ \t]+([A-Za-z_][A-Za-z_0-9]*)");
  for (std::sregex_iterator found(text.begin(), text.end(), macro), end; found != end; ++found)
    including += fmt::format("#undef {}\n", (*found)[1].str());
  return including;
}

std::string compile_core(const std::string& header, const std::string& text, const TemporaryFolder& folder,
                         const std::string& name) {
  const std::string include_folder = folder.path() + "/" + name;
  std::filesystem::create_directories(include_folder + "/sim/physics");
  static_cast<void>(folder.write(name + "/sim/physics/physics.h", included_text(header, text)));
  std::string library = include_folder + "/core.so";
  const std::string source = HYRAX_SOURCE_DIR;
  std::vector<std::string> command = {"env", "LC_ALL=C"};  // The compiler's messages are read.
  command.insert(command.end(), std::begin(kCompileCommand), std::end(kCompileCommand));
  for (const std::string& argument : {"-I" + include_folder, "-I" + source, std::string("-o"), library,
                                      source + "/sim/card/core_library.cpp"})
    command.push_back(argument);
  const ChildEnd end = run_child(command, "", kCompileLimit_s);
  if (end.exit_code != 0 || end.is_timed_out)
    refuse_input(
        header + ": does not compile: " +
        (end.is_timed_out || end.err.empty() ? end_text(end, kCompileLimit_s) : first_error(end.err)));
  return library;
}

// As a program's build traces its core (tools/cmake/record_core.cmake).
AcceptedCore trace_header(const std::string& header, const std::string& text, const TemporaryFolder& folder,
                          const std::string& name) {
  const std::string trace_folder = folder.path() + "/" + name + "/trace";
  std::filesystem::create_directories(trace_folder);
  const std::string settings = folder.write(
      name + "/trace/settings.cmake",
      fmt::format("include([==[{}]==])\nset(folder [==[{}]==])\nset(header [==[{}]==])\n",
                  HYRAX_RECORD_SETTINGS, trace_folder, std::filesystem::absolute(header).string()));
  const ChildEnd end = run_child(
      {HYRAX_CMAKE, "-D", "settings=" + settings, "-P", HYRAX_SOURCE_DIR "/tools/cmake/record_core.cmake"},
      "", kCompileLimit_s);
  AcceptedCore core;
  core.header = text;
  const std::string step = trace_folder + "/step.txt", why = trace_folder + "/why_incomplete.txt";
  if (is_there(why))
    core.why_incomplete = read_text_file(why);
  else if (is_there(step))
    core.step = read_text_file(step);
  else
    core.why_incomplete = "cannot be traced (" + end_text(end, kCompileLimit_s) + ")";
  return core;
}

CoreFile shipped_file(const CoreRecord& record) {
  CoreFile shipped{.library = HYRAX_SHIPPED_CORE, .core = {}};
  shipped.core.header = record.header;
  shipped.core.step = record.step;
  shipped.core.why_incomplete = record.why_incomplete;
  return shipped;
}

}  // namespace

CoreFile make_core(const std::string& header, const TemporaryFolder& folder, const std::string& name) {
  const std::string text = read_text_file(header);
  auto traced = std::async(std::launch::async, trace_header, header, text, std::cref(folder), name);
  std::string library = compile_core(header, text, folder, name);
  return {std::move(library), traced.get()};
}

CoreFile core_of_project(const CoreRecord& shipped, const TemporaryFolder& folder, const std::string& name) {
  if (read_text_file(kProjectHeader) == shipped.header) return shipped_file(shipped);
  return make_core(kProjectHeader, folder, name);
}

CoreFile core_of_golden(const CoreRecord& shipped, const std::string& golden_folder,
                        const TemporaryFolder& folder, const std::string& name) {
  std::optional<AcceptedCore> accepted = read_accepted_core(golden_folder);
  if (!accepted)
    throw Failure(ExitCode::golden_missing,
                  fmt::format("{}: no accepted core; name a base, or accept this program's core: {}",
                              accepted_core_folder(golden_folder), core_commands({}, golden_folder).accept));
  if (accepted->header == shipped.header && accepted->step == shipped.step) return shipped_file(shipped);
  const std::string header = accepted_core_folder(golden_folder) + "/physics.h";
  CoreFile base = make_core(header, folder, name);
  // The bytes of the header are those that were accepted; what they include, and the compiler's options, may
  // be others.
  if (!accepted->step.empty() && base.core.step != accepted->step)
    refuse_input(
        fmt::format("{}: compiled now, it does not take the accepted step, {}/step.txt ({}); name a base",
                    header, accepted_core_folder(golden_folder),
                    base.core.step.empty() ? base.core.why_incomplete
                                           : "an included header or a compiler option changed"));
  base.core = std::move(*accepted);
  return base;
}

LibraryCore& load_library(const std::string& library, int number, PlayWatch& watch) {
  watch.core = number;
  watch.set_place("its initialisation");
  void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const entry = handle != nullptr ? dlsym(handle, kCoreEntry) : nullptr;
  if (entry == nullptr) throw Failure(ExitCode::cannot_access, library + ": cannot be loaded: " + dlerror());
  require_usual_arithmetic(number, watch.place.data());
  return *reinterpret_cast<CoreEntry*>(entry)(&watch.updates);
}

ComparedCore load_core(const CoreFile& file, int number, PlayWatch& watch) {
  return compared_core(number, load_library(file.library, number, watch), file.core.record(), watch);
}

}  // namespace hyrax
