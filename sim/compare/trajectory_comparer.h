// Two recorded trajectories, value by value, within tolerances.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "sim/compare/comparison.h"
#include "sim/trajectory/row.h"

namespace hyrax {

/// A value agrees if its bits do or any given tolerance is met. Contacts must always agree, a NaN agrees with
/// nothing, and an infinity with itself only.
struct Tolerance {
  std::optional<double> abs;
  std::optional<double> rel;  ///< Of the larger magnitude.
  std::optional<std::int64_t> ulps;
  [[nodiscard]] bool is_exact() const { return !abs && !rel && !ulps; }
  [[nodiscard]] bool accepts(double a, double b) const;
};

/// The first quantity of a contact that differs by more than the tolerance; nothing where none does.
/// REQUIRES: lists of the same contacts, at the same steps.
[[nodiscard]] std::optional<Divergence> first_difference(const std::vector<Contact>& a,
                                                         const std::vector<Contact>& b,
                                                         const Tolerance& tolerance = {});

/// The largest difference of a field, within the tolerance or not: the first NaN, else the first of the
/// largest magnitude.
struct WorstDifference {
  std::int64_t step = 0;
  double a = 0.0;
  double b = 0.0;
  [[nodiscard]] double abs() const { return std::fabs(a - b); }
};

class TrajectoryComparer {
 public:
  /// @param other_walls whose contacts have other sources in the rows: these set no class.
  explicit TrajectoryComparer(Tolerance tolerance, int other_walls = 0)
      : tolerance_(tolerance), distance_(other_walls) {}

  /// REQUIRES: rows of the same number, in order of steps.
  void compare(const Row& a, const Row& b);
  /// All contacts; after the rows.
  void compare(const std::vector<Contact>& a, const std::vector<Contact>& b);

  /// By the order of kRowFields; nothing where not one bit differs.
  [[nodiscard]] const std::array<std::optional<WorstDifference>, kRowFields.size()>& worst() const {
    return worst_;
  }
  [[nodiscard]] const std::optional<Divergence>& first() const { return first_; }
  [[nodiscard]] const ContactChanges& contacts() const { return contacts_; }
  /// Of the rows, within the tolerance or not.
  [[nodiscard]] const RunDistance& distance() const { return distance_; }

 private:
  Tolerance tolerance_;
  std::array<std::optional<WorstDifference>, kRowFields.size()> worst_;
  std::optional<Divergence> first_;
  ContactChanges contacts_;
  RunDistance distance_;
};

}  // namespace hyrax
