#include <gsl/gsl_version.h>
#include <hdf5.h>
#include <xxhash.h>

#include "sim/core/core.h"
#include "sim/core/core_record.h"
#include "sim/physics/strict_arithmetic.h"
#include "sim/trace/step_text.h"
#include "tools/app/command_line/options.h"
#include "tools/files/build_info.h"
#include "tools/files/json.h"

namespace hyrax {
namespace {

// With the instruction sets of this machine.
std::string processor() {
#if defined(__x86_64__)
  std::string text = "x86-64";
  if (__builtin_cpu_supports("avx2")) text += ", avx2";
  if (__builtin_cpu_supports("fma")) text += ", fma (not used: it would change bits)";
  if (__builtin_cpu_supports("avx512f")) text += ", avx512f";
  return text;
#else
  return std::string(build_info().target);
#endif
}

std::string hdf5_version() {
  unsigned major = 0;
  unsigned minor = 0;
  unsigned release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("{}.{}.{}", major, minor, release);
}

// What the build could record of the core's step.
std::string step_fact(const Core& core) {
  const CoreRecord& record = core.record;
  if (!record.why_incomplete.empty()) return fmt::format("not complete: {}", record.why_incomplete);
  return fmt::format("complete, {} paths",
                     read_step(record.step).value().paths_of(CoreFunction::update).size());
}

Json::Object facts(const Core& core) {
  const BuildInfo build = build_info();
  const auto fault = arithmetic_fault();
  return {{"version", build.version},
          {"compiler", build.compiler},
          {"flags", build.flags},
          {"target", build.target},
          {"instruction_set", build.instruction_set},
          {"processor", processor()},
          {"physics", core.name},
          {"step", step_fact(core)},
          {"contacts", core.record.why_incomplete.empty() ? "from the step's comparisons" : "from the rows"},
          {"self_test", fault ? std::string(*fault) : std::string(kStrictArithmetic)},
          {"hdf5", hdf5_version()},
          {"gsl", gsl_version},
          {"xxhash", fmt::format("{}.{}.{}", XXH_VERSION_MAJOR, XXH_VERSION_MINOR, XXH_VERSION_RELEASE)},
          {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)}};
}

ExitCode info(const Core& core, const Printing& printing) {
  const Json::Object all = facts(core);
  if (printing.is_json)
    print_json(all, 1);
  else
    for (const auto& [name, value] : all)
      if (!printing.is_quiet() || name == "self_test")
        print_text("{:<16} {}\n", name, *value.get<std::string>());
  return ExitCode::agreed;
}

}  // namespace

Command info_command() {
  return {.name = "info",
          .summary = "print build, flags, instruction set, library versions and the result of the self-test",
          .example = "hyrax-sim info",
          .needs_strict_ieee = false,
          .declare = with_request<Printing>(
              [](Options& options, Printing& printing) { options.printing(printing); }, info)};
}

}  // namespace hyrax
