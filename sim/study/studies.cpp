#include "sim/study/study.h"

// One line a study, in the order of the help: NAME stands for NAME_study(), defined in the folder NAME.
#define HYRAX_STUDIES(ONE) \
  ONE(speed_error)         \
  ONE(needs)               \
  ONE(hard_cases)          \
  ONE(frame_rate)

namespace hyrax {

#define HYRAX_DECLARE(name) Study name##_study();
HYRAX_STUDIES(HYRAX_DECLARE)

const std::vector<Study>& studies() {
#define HYRAX_MAKE(name) name##_study(),
  static const std::vector<Study> all = {HYRAX_STUDIES(HYRAX_MAKE)};
  return all;
}

}  // namespace hyrax
