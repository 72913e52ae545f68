#include <utility>

#include "tools/app/sweep/sweep_run.h"
#include "tools/run_core/run_core.h"

namespace hyrax {

Command sweep_command() {
  return sweep_command_of([](const Core& core) {
    return SweptCore{.head = {.physics = std::string(core.name), .core = core.record.checksum()},
                     .load =
                         [&core](const std::string& path) {
                           SweepFile file = load_sweep(path);
                           static_cast<void>(run_core(core, path, file.sweep.base));
                           return paper_sweep(core, std::move(file));
                         },
                     .read_contents = paper_contents};
  });
}

}  // namespace hyrax
