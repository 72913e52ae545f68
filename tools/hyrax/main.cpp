#include <exception>
#include <new>
#include <string>
#include <vector>

#include <windows.h>

#include <shellapi.h>

#include "help_text.h"
#include "sim/core/shipped_core.h"
#include "sim/physics/strict_arithmetic.h"
#include "tools/files/build_info.h"
#include "tools/hyrax/app.h"
#include "tools/hyrax/report.h"
#include "tools/platform/wide_text.h"

namespace hyrax {
namespace {

std::vector<std::string> command_line() {
  int count = 0;
  wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
  std::vector<std::string> arguments;
  for (int word = 1; word < count; ++word) arguments.push_back(to_utf8(words[word]));
  LocalFree(words);
  return arguments;
}

ExitCode run(const Core& core, HINSTANCE instance) {
  const PetOptions options = parse_options(command_line());
  if (options.wants_help || options.wants_version) {
    report(options.wants_help ? std::string(kHelpText) : "hyrax " + std::string(build_info().version));
    return ExitCode::agreed;
  }
  if (const auto fault = arithmetic_fault())
    throw Failure(ExitCode::not_strict_ieee, "hyrax: " + std::string(*fault));
  if (options.only_exits) {
    const PlaybackVerdict verdict = replayed(core, load_for_pet(*options.replay_path));
    report(verdict);
    return verdict.exit_code;
  }
  return App(core, options, instance).run();
}

}  // namespace
}  // namespace hyrax

int WINAPI wWinMain(HINSTANCE instance, HINSTANCE, wchar_t*, int) {
  using namespace hyrax;
  try {
    return static_cast<int>(run(shipped_core(), instance));
  } catch (const Failure& failure) {
    report_error(failure.what());
    return static_cast<int>(failure.exit_code());
  } catch (const std::bad_alloc&) {
    report_error("hyrax: out of memory");
  } catch (const std::exception& error) {
    report_error(std::string("hyrax: internal error: ") + error.what());
  }
  return static_cast<int>(ExitCode::program_fault);
}
