// Floating-point modes changed by another library are restored before the next frame.
#include <gtest/gtest.h>

#if defined(__x86_64__)

#include "sim/physics/strict_arithmetic.h"
#include "tools/hyrax/arithmetic_pin.h"

namespace hyrax {
namespace {

class ForeignModes : public testing::Test {
 protected:
  void TearDown() override { _mm_setcsr(kUsual); }
  static constexpr unsigned kUsual = 0x1F80;
  static constexpr unsigned kFlushToZero = 0x8000;
  static constexpr unsigned kDenormalsAreZero = 0x0040;
  static constexpr unsigned kRoundDown = 0x2000;
};

TEST_F(ForeignModes, ArePutRight) {
  for (const unsigned mode : {kFlushToZero, kDenormalsAreZero, kRoundDown}) {
    _mm_setcsr(kUsual | mode);
    EXPECT_TRUE(arithmetic_fault().has_value()) << mode;  // The control: the mode does harm.
    pin_arithmetic();
    EXPECT_FALSE(arithmetic_fault().has_value()) << mode;
  }
  for (const unsigned traps : {0x0u, 0x1F00u, 0x0F80u}) {
    _mm_setcsr(traps);
    pin_arithmetic();
    EXPECT_EQ(_mm_getcsr(), kUsual);
  }
}

}  // namespace
}  // namespace hyrax

#endif
