#include "tools/app/sweep/sweep_run.h"

namespace hyrax {

Command sweep_command() {
  return sweep_command_of([](const Core& core) {
    return SweptCore{.head = {.physics = std::string(core.name), .core = core.record.checksum()},
                     .load = [&core](const std::string& path) { return paper_sweep(core, load_sweep(path)); },
                     .read_contents = paper_contents};
  });
}

}  // namespace hyrax
