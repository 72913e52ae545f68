// Packed rows, their blocks, and the state hash against the published vectors.
#include "sim/trajectory/state_hash.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/oracle/vectors.h"
#include "tests/unit/sim/replay/trace_sink.h"

namespace hyrax {
namespace {

std::vector<Row> rows_of(const Json& entry) {
  std::vector<Row> rows;
  if (const Json* listed = entry.find("rows")) {
    for (const Json& row : *listed->get<Json::Array>())
      rows.push_back({.dt_s = exact(row, "dt"),
                      .x_px = exact(row, "x"),
                      .y_px = exact(row, "y"),
                      .vx_px_per_s = exact(row, "vx"),
                      .vy_px_per_s = exact(row, "vy"),
                      .contact = static_cast<std::uint8_t>(integer_of(row, "contact"))});
    return rows;
  }
  // Long vectors give a count only; this rule makes their rows.
  for (std::int64_t i = 0; i < integer_of(entry, "count"); ++i) {
    const auto at = static_cast<double>(i);
    rows.push_back({.dt_s = 1.0 / 64.0,
                    .x_px = at,
                    .y_px = at * 0.5,
                    .vx_px_per_s = 0.0 - at,
                    .vy_px_per_s = 1000.0 - at,
                    .contact = static_cast<std::uint8_t>(i % 32)});
  }
  return rows;
}

std::vector<Digest> block_digests(const std::vector<Row>& rows) {
  std::vector<Digest> digests;
  RowBlock block;
  for (const Row& row : rows) {
    block.append(row);
    if (block.room() > 0) continue;
    digests.push_back(digest(block));
    block.shrink(0);
  }
  if (block.size() > 0) digests.push_back(digest(block));
  return digests;
}

std::string state_hash(const std::vector<Row>& rows) {
  StateHash hash;
  for (const Digest& block : block_digests(rows)) hash.add(block);
  return hex(hash.value());
}

TEST(StateHash, AndTheBlockDigestsThatItIsMadeOfAreThePublishedOnes) {
  for (const Json& entry : vectors("state_hash")) {
    const std::vector<Row> rows = rows_of(entry);
    EXPECT_EQ(state_hash(rows), text_of(entry, "state_hash")) << text_of(entry, "name");
    const std::vector<Digest> digests = block_digests(rows);
    const Json::Array& published = *entry.find("block_digests")->get<Json::Array>();
    ASSERT_EQ(digests.size(), published.size()) << text_of(entry, "name");
    for (std::size_t block = 0; block < digests.size(); ++block)
      EXPECT_EQ(hex(digests[block]), *published[block].get<std::string>()) << text_of(entry, "name");
  }
}

TEST(RowBlock, GivesBackTheBitsOfItsRows) {
  RowBlock block;
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const Row row{0, 0.0, 0.1, -0.0, not_a_number, 5e-324, -1.7976931348623157e308, 31};
  block.append(row);
  EXPECT_TRUE(same_row(block.row(0), row));
}

TEST(FiniteState, ChecksEveryField) {
  EXPECT_TRUE(is_finite(State{}));
  for (double State::*const field : {&State::x_px, &State::y_px, &State::vx_px_per_s, &State::vy_px_per_s}) {
    State state;
    state.*field = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(is_finite(state));
  }
}

}  // namespace
}  // namespace hyrax
