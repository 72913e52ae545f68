// hyrax-replay without `check`: see HYRAX_REPLAY_CHECK.
#include "tools/hyrax-replay/check.h"

namespace hyrax {

ExitCode check(const Core&, std::vector<std::string>, const std::string&) {
  refuse_input("hyrax-replay check: this build has no check; use hyrax-sim check");
}

}  // namespace hyrax
