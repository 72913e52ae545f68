#include "tools/store/build_facts.h"

#include <fmt/format.h>
#include <xxhash.h>

#include "sim/physics/strict_arithmetic.h"
#include "tools/files/build_info.h"
#include "tools/platform/guarded_child.h"
#include "tools/store/hdf5.h"

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

}  // namespace

Json::Object build_facts() {
  const BuildInfo build = build_info();
  return {{"version", build.version},
          {"compiler", build.compiler},
          {"flags", build.flags},
          {"target", build.target},
          {"instruction_set", build.instruction_set},
          {"processor", processor()}};
}

Json::Object library_facts() {
  const auto fault = arithmetic_fault();
  Json::Object facts = {
      {"self_test", fault ? std::string(*fault) : std::string(kStrictArithmetic)},
      {"hdf5", hdf5_version()},
      {"xxhash", fmt::format("{}.{}.{}", XXH_VERSION_MAJOR, XXH_VERSION_MINOR, XXH_VERSION_RELEASE)},
      {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)}};
  if (!guards_work())
    facts.emplace_back(
        "not_guarded",
        "a damaged HDF5 file, or a run that crashes or does not end, ends or stops this program");
  return facts;
}

void write_provenance(hid_t file) {
  const BuildInfo build = build_info();
  const std::string program = "hyrax-sim " + std::string(build.version);
  const std::array<std::string_view, kProvenanceNames.size()> values = {
      program, build.compiler, build.flags, build.target, build.instruction_set, kStrictArithmetic};
  const h5::Handle group = h5::create_group(file, "provenance");
  for (std::size_t index = 0; index < values.size(); ++index)
    h5::write_attribute(group, kProvenanceNames[index], values[index]);
}

Provenance read_provenance(hid_t file) {
  const h5::Handle group(H5Gopen2(file, "provenance", H5P_DEFAULT), H5Gclose);
  Provenance provenance;
  for (std::size_t index = 0; index < provenance.size(); ++index)
    provenance[index] = h5::read_text_attribute(group, kProvenanceNames[index]);
  return provenance;
}

void write_core_name(hid_t file, const std::string& checksum) {
  if (!checksum.empty()) h5::write_attribute(file, kCoreAttribute, checksum);
}

std::string read_core_name(hid_t file) { return h5::read_text_attribute(file, kCoreAttribute).value_or(""); }

}  // namespace hyrax
