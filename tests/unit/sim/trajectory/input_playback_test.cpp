// The inputs of a frame, applied again.
#include "sim/trajectory/input_playback.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

std::array<bool, 4> change_of(const std::vector<Action>& actions) {
  std::vector<Input> inputs;
  for (const Action& action : actions) inputs.push_back({.frame = 0, .action = action});
  Row row{};
  const InputChange change = InputPlayback(fling_at(60.0, 1), inputs).apply(row);
  return {change.ends_arc, change.grabs, change.sets_position, change.sets_velocity};
}

TEST(InputPlayback, ChangesInAFrameWhatAnyOfItsInputsChanges) {
  const Action actions[] = {Fling{{1.0, 2.0}},          Place{{3.0, 4.0}},  Stop{},
                            Resize{Size{900, 500}, {}}, Hitch{.dt_s = 0.1}, Grab{},
                            Release{{5.0, 6.0}}};
  for (const Action& first : actions)
    for (const Action& second : actions) {
      std::array<bool, 4> either = change_of({first});
      for (std::size_t each = 0; each < either.size(); ++each) either[each] |= change_of({second})[each];
      EXPECT_EQ(change_of({first, second}), either) << name_of(first) << ", " << name_of(second);
    }
}

}  // namespace
}  // namespace hyrax
