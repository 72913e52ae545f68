// Rows as 41 bytes and as columns, walls as bits.
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "sim/motion/state.h"
#include "sim/scenario/schedule.h"
#include "sim/trajectory/columns.h"
#include "sim/trajectory/state_hash.h"
#include "tests/unit/sim/replay/trace_sink.h"

namespace hyrax {
namespace {

std::vector<int> bytes_of(const RowBlock& block, std::size_t first, std::size_t count) {
  std::vector<int> bytes;
  for (std::size_t at = first; at < first + count; ++at)
    bytes.push_back(std::to_integer<int>(block.data()[at]));
  return bytes;
}

void append(RowBlock& block, double x_px) { pack_row(block.extend(1), 0.5, x_px, 2.0, 3.0, 4.0, 8); }

TEST(PackedRow, IsFortyOneBytesInLittleEndianOrder) {
  RowBlock block;
  // 1/64, 1, -2, -0 and the smallest subnormal: sign, exponent and last bit each show their byte.
  pack_row(block.extend(1), 0x1p-6, 1.0, -2.0, -0.0, std::numeric_limits<double>::denorm_min(), 24);
  const std::vector<int> expected = {0, 0, 0, 0, 0, 0, 0x90, 0x3f,  // dt
                                     0, 0, 0, 0, 0, 0, 0xf0, 0x3f,  // x
                                     0, 0, 0, 0, 0, 0, 0x00, 0xc0,  // y
                                     0, 0, 0, 0, 0, 0, 0x00, 0x80,  // vx
                                     1, 0, 0, 0, 0, 0, 0x00, 0x00,  // vy
                                     24};
  EXPECT_EQ(bytes_of(block, 0, kPackedRowBytes), expected);
}

TEST(PackedRow, FollowsTheOneBeforeWithoutAGap) {
  RowBlock block;
  append(block, 1.0);
  append(block, 1.0);
  EXPECT_EQ(bytes_of(block, kPackedRowBytes, kPackedRowBytes), bytes_of(block, 0, kPackedRowBytes));
}

TEST(PackedRow, ReadsBackToTheSameBits) {
  RowBlock block;
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  pack_row(block.extend(1), 0.1, -0.0, not_a_number, 5e-324, -1.7976931348623157e308, 31);
  EXPECT_TRUE(same_row(block.row(0), {0, 0.0, 0.1, -0.0, not_a_number, 5e-324, -1.7976931348623157e308, 31}));
}

TEST(RowBlock, HoldsFourThousandAndNinetySixRows) {
  RowBlock block;
  EXPECT_EQ(block.room(), 4096u);
  for (std::size_t row = 0; row < kBlockRows; ++row) append(block, static_cast<double>(row));
  EXPECT_EQ(block.room(), 0u);
  EXPECT_EQ(block.row(4095).x_px, 4095.0);
}

TEST(RowBlock, AppendsRowsOfAnother) {
  RowBlock from;
  for (const double x_px : {1.0, 2.0, 3.0}) append(from, x_px);
  RowBlock to;
  append(to, 9.0);
  to.append(from, 1, 2);
  ASSERT_EQ(to.size(), 3u);
  EXPECT_EQ(to.row(0).x_px, 9.0);
  EXPECT_EQ(to.row(1).x_px, 2.0);
  EXPECT_EQ(to.row(2).x_px, 3.0);
}

TEST(RowBlock, DropsRowsWhenShrunk) {
  RowBlock block;
  for (const double x_px : {1.0, 2.0, 3.0}) append(block, x_px);
  block.shrink(1);
  append(block, 7.0);
  ASSERT_EQ(block.size(), 2u);
  EXPECT_EQ(block.row(1).x_px, 7.0);
}

TEST(SameBits, DistinguishesSignedZerosAndAcceptsEqualNans) {
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(same_bits(0.0, -0.0));
  EXPECT_TRUE(same_bits(not_a_number, not_a_number));
}

TEST(FiniteState, ChecksEveryField) {
  EXPECT_TRUE(is_finite(State{}));
  for (double Row::*const field : {&Row::x_px, &Row::y_px, &Row::vx_px_per_s, &Row::vy_px_per_s}) {
    Row row;
    row.*field = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(is_finite(state_of(row)));
  }
}

TEST(Columns, GiveBackTheRowsTheyTook) {
  const Row rows[] = {{1, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8}, {9, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 16}};
  Columns columns;
  for (const Row& row : rows) columns.append(row);
  ASSERT_EQ(columns.size(), 2u);
  for (std::size_t row = 0; row < 2; ++row) EXPECT_TRUE(same_row(columns.row(row), rows[row]));
  columns.clear();
  EXPECT_EQ(columns.size(), 0u);
}

TEST(Wall, HasItsOwnBit) {
  std::set<int> seen = {kRestBit};
  for (const Wall wall : kWalls) {
    EXPECT_TRUE(seen.insert(static_cast<int>(wall)).second);
    EXPECT_EQ(kWalls[wall_index(wall)], wall);
    EXPECT_TRUE(touches(static_cast<std::uint8_t>(wall), wall));
    EXPECT_FALSE(touches(static_cast<std::uint8_t>(31 & ~static_cast<int>(wall)), wall));
  }
  EXPECT_EQ(seen, (std::set<int>{1, 2, 4, 8, 16}));
}

}  // namespace
}  // namespace hyrax
