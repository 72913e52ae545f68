// A sink that records everything it receives, and how two such traces differ.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "sim/trajectory/row_sink.h"
#include "sim/trajectory/run_summary.h"

namespace hyrax {

inline bool same_row(const Row& a, const Row& b) {
  return a.step == b.step && same_bits(a.t_s, b.t_s) && same_bits(a.dt_s, b.dt_s) &&
         same_bits(a.x_px, b.x_px) && same_bits(a.y_px, b.y_px) && same_bits(a.vx_px_per_s, b.vx_px_per_s) &&
         same_bits(a.vy_px_per_s, b.vy_px_per_s) && a.contact == b.contact;
}

inline bool same_contact(const Contact& a, const Contact& b) {
  return a.step == b.step && a.last_step == b.last_step && a.wall == b.wall && same_bits(a.t_s, b.t_s) &&
         same_bits(a.x_px, b.x_px) && same_bits(a.y_px, b.y_px) &&
         same_bits(a.vx_before_px_per_s, b.vx_before_px_per_s) &&
         same_bits(a.vy_before_px_per_s, b.vy_before_px_per_s) &&
         same_bits(a.vx_after_px_per_s, b.vx_after_px_per_s) &&
         same_bits(a.vy_after_px_per_s, b.vy_after_px_per_s) && same_bits(a.overshoot_px, b.overshoot_px);
}

inline std::ostream& operator<<(std::ostream& out, const Row& row) {
  return out << std::hexfloat << "row " << row.step << ": t " << row.t_s << " dt " << row.dt_s << " x "
             << row.x_px << " y " << row.y_px << " vx " << row.vx_px_per_s << " vy " << row.vy_px_per_s
             << " contact " << static_cast<int>(row.contact);
}

inline std::ostream& operator<<(std::ostream& out, const Contact& contact) {
  return out << std::hexfloat << "steps " << contact.step << " .. " << contact.last_step << ": wall "
             << static_cast<int>(contact.wall) << " t " << contact.t_s << " x " << contact.x_px << " y "
             << contact.y_px << " before " << contact.vx_before_px_per_s << ", " << contact.vy_before_px_per_s
             << " after " << contact.vx_after_px_per_s << ", " << contact.vy_after_px_per_s << " overshoot "
             << contact.overshoot_px;
}

/// Every field of a summary, doubles to the bit: a field that is added to it must be added here.
inline std::string text_of(const RunSummary& summary) {
  const auto& [steps, computed, simulated_s, contacts, bounces, resting_from, clamped, rest_steps, final,
               at_rest_since_s, periodic_from, period, hash, non_finite, out_of_bounds, had_gravity, had_drag,
               had_friction] = summary;
  std::ostringstream out;
  out << std::hexfloat << steps << " steps, " << computed << " computed, " << simulated_s << " s, contacts";
  for (const Wall wall : kWalls)
    out << " " << contacts[wall] << " of " << clamped[wall] << " steps, bounces " << bounces[wall];
  out << ", resting contact from " << resting_from.value_or(-1) << ", " << rest_steps << " rest steps, final "
      << final << ", at rest since " << at_rest_since_s.value_or(-1.0) << ", periodic from "
      << periodic_from.value_or(-1) << " by " << period << ", hash " << hex(hash) << ", non-finite at "
      << non_finite.value_or(-1) << ", out of bounds at " << out_of_bounds.value_or(-1) << ", had "
      << had_gravity << had_drag << had_friction;
  return out.str();
}

/// Where two sequences differ first.
template <class Element, class Same>
testing::AssertionResult same_sequence(const std::vector<Element>& a, const std::vector<Element>& b,
                                       const Same& same) {
  for (std::size_t at = 0; at < a.size() && at < b.size(); ++at)
    if (!same(a[at], b[at])) return testing::AssertionFailure() << a[at] << "\nis not\n" << b[at];
  if (a.size() != b.size()) return testing::AssertionFailure() << a.size() << " are not " << b.size();
  return testing::AssertionSuccess();
}

inline testing::AssertionResult same_rows(const std::vector<Row>& a, const std::vector<Row>& b) {
  return same_sequence(a, b, same_row);
}
inline testing::AssertionResult same_contacts(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  return same_sequence(a, b, same_contact);
}

class TraceSink : public RowSink {
 public:
  struct BlockSeen {
    std::int64_t first_step;
    Digest digest;
    bool operator==(const BlockSeen&) const = default;
    friend std::ostream& operator<<(std::ostream& out, const BlockSeen& seen) {
      return out << "block from " << seen.first_step << ": " << hex(seen.digest);
    }
  };

  TraceSink() = default;
  explicit TraceSink(Wants wants) : wants_(wants) {}

  Wants wants() const override { return wants_; }

  void row(const Row& row) override { rows_.push_back(row); }
  void contact_began(const Contact& contact) override {
    constexpr std::size_t kMany = 10'000;
    if (contacts_.size() == kMany) contacts_.reserve(kContactsRecordedMax);  // A long list is not moved.
    contacts_.push_back(contact);
  }
  void contact_ended(std::int64_t index, std::int64_t last_step) override {
    Contact& contact = contacts_.at(static_cast<std::size_t>(index));
    EXPECT_EQ(contact.last_step, contact.step) << "contact " << index << " ended twice";
    EXPECT_GT(last_step, contact.step) << "contact " << index << " of one step was reported again";
    contact.last_step = last_step;
  }
  void block(const Block& block, std::int64_t count) override {
    const std::int64_t first_step = block.keyframe.row.step;
    for (std::int64_t i = 0; i < count; ++i)
      blocks_.push_back({first_step + i * static_cast<std::int64_t>(kBlockRows), block.digest});
  }

  const std::vector<Row>& rows() const { return rows_; }
  const std::vector<Contact>& contacts() const { return contacts_; }
  /// Every block, with repetitions listed one by one.
  const std::vector<BlockSeen>& blocks() const { return blocks_; }

 private:
  Wants wants_{.rows_every = 1, .contacts = true, .blocks = true};
  std::vector<Row> rows_;
  std::vector<Contact> contacts_;
  std::vector<BlockSeen> blocks_;
};

inline testing::AssertionResult same_trace(const TraceSink& a, const TraceSink& b) {
  if (const auto rows = same_rows(a.rows(), b.rows()); !rows) return rows;
  if (const auto contacts = same_contacts(a.contacts(), b.contacts()); !contacts) return contacts;
  return same_sequence(a.blocks(), b.blocks(), std::equal_to<>());
}

}  // namespace hyrax
