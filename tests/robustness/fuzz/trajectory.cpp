// The reader of trajectory files, as `diff` and `drift` use it: the input is an HDF5 file.
#include <algorithm>

#include "tests/robustness/fuzz/fuzz_target.h"
#include "tests/robustness/fuzz/input_file.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {
namespace {

void read_all(const std::string& path) {
  constexpr std::int64_t kBatch = 4096;
  const TrajectoryFile file = TrajectoryFile::open(path);
  for (std::int64_t first = 0; first < file.row_count(); first += kBatch)
    static_cast<void>(file.rows(first, std::min(kBatch, file.row_count() - first)));
  static_cast<void>(file.contacts());
  static_cast<void>(file.contacts_total());
  static_cast<void>(file.inputs());
  static_cast<void>(file.provenance());
}

}  // namespace
}  // namespace hyrax

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hyrax;
  const InputFile file(text_of(data, size));
  static_cast<void>(accepts([&] { read_all(file.path()); }));
  return 0;
}
