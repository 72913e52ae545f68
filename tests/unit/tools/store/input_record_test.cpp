// Inputs as a file has them, and back.
#include "tools/store/input_record.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hyrax {
namespace {

void expect(const Action& action, int kind, double a, double b) {
  const InputRecord record = record_of({5, action});
  EXPECT_EQ(record.frame, 5);
  EXPECT_EQ(record.kind, kind);
  EXPECT_EQ(record.a, a);
  EXPECT_EQ(record.b, b);
  EXPECT_EQ(input_of(record), (Input{5, action}));
}

TEST(InputRecord, HasThePublishedCodesAndNumbers) {
  expect(Fling{{1.0, 2.0}}, 0, 1.0, 2.0);
  expect(Place{{3.0, 4.0}}, 1, 3.0, 4.0);
  expect(Stop{}, 2, 0.0, 0.0);
  expect(Resize{Size{800, 600}, {}}, 3, 800.0, 600.0);
  expect(Resize{{}, Size{64, 32}}, 4, 64.0, 32.0);
  expect(Hitch{0.5}, 5, 0.5, 0.0);
  expect(Grab{}, 6, 0.0, 0.0);
  expect(Release{{6.0, 7.0}}, 7, 6.0, 7.0);
  EXPECT_EQ(input_kind_names()[4], "resize-sprite");
  EXPECT_EQ(input_kind_names()[7], "release");
}

TEST(InputRecord, ThatNoInputHasIsNone) {
  EXPECT_FALSE(input_of({0, 8, 0.0, 0.0}));
  EXPECT_FALSE(input_of({0, 3, 800.5, 600.0}));
  EXPECT_FALSE(input_of({0, 3, -1.0, 600.0}));
  EXPECT_FALSE(input_of({0, 4, 64.0, 1e300}));
  EXPECT_FALSE(input_of({0, 4, std::nan(""), 32.0}));
  EXPECT_FALSE(input_of({0, 5, 0.5, 1.0}));
  EXPECT_FALSE(input_of({0, 6, -0.0, 0.0}));
}

}  // namespace
}  // namespace hyrax
