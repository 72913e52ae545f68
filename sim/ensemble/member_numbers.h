// What the members of a sweep have in common: range and mean of each number, a sample of it, and its
// distribution.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/result/figure.h"
#include "sim/result/table.h"

namespace hyrax {

/// So many values make the points and quantiles of a number.
inline constexpr std::int64_t kSamplesMax = 20'000;

/// The member whose number, and every multiple of it, is in a sample of at most kSamplesMax of `members`:
/// without a common divisor with `members`, so that the sample meets every value of a grid. REQUIRES: members
/// >= 0.
[[nodiscard]] std::int64_t sample_stride(std::int64_t members);

/// One number of every member.
class MemberNumbers {
 public:
  /// @param name as "x" or "contacts.left"; unit as "px", empty if there is none.
  /// @param is_result or else an input.
  /// @param members how many will be added; if they are a sample already, at most kSamplesMax.
  /// @param value_names of the values 0, 1, ...
  MemberNumbers(std::string name, std::string unit, std::string long_name, bool is_result,
                std::int64_t members, std::vector<std::string> value_names = {});

  /// The next member's; NaN: it has none.
  void add(double value);
  /// When all are added, each once more: its interval of the distribution.
  void bin(double value);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& unit() const { return unit_; }
  [[nodiscard]] const std::string& long_name() const { return long_name_; }
  [[nodiscard]] bool is_result() const { return is_result_; }
  [[nodiscard]] std::int64_t known() const { return known_; }
  [[nodiscard]] std::int64_t missing() const { return count_ - known_; }
  /// NaN if no member has one.
  [[nodiscard]] double smallest() const;
  [[nodiscard]] double largest() const;
  [[nodiscard]] double mean() const;
  /// Whether it is the same in all members that have it, within rounding: 1e-9.
  [[nodiscard]] bool is_constant() const;
  /// Of the sample's values, linear between neighbours.
  [[nodiscard]] double quantile(double part) const;
  /// Every K-th member's number, from member 0.
  [[nodiscard]] const std::vector<double>& sample() const { return sample_; }
  /// The share of the members in each interval, which are equally wide, or one a whole number of a small
  /// range.
  [[nodiscard]] Plot histogram() const;

 private:
  std::string name_;
  std::string unit_;
  std::string long_name_;
  bool is_result_;
  std::vector<std::string> value_names_;
  std::int64_t stride_;
  std::int64_t count_ = 0;
  std::int64_t known_ = 0;
  bool is_whole_ = true;
  double smallest_ = 0.0;
  double largest_ = 0.0;
  double mean_ = 0.0;
  std::vector<double> sample_;
  double bins_from_ = 0.0;
  double bin_width_ = 1.0;
  std::vector<std::int64_t> bins_;
};

/// How each result that is no constant is distributed over what was added and binned of `members`.
[[nodiscard]] std::vector<Figure> member_figures(const std::vector<MemberNumbers>& numbers,
                                                 std::int64_t members);

/// Smallest, quantiles of the sample, mean, largest and missing values, one row a number.
[[nodiscard]] Table member_table(const std::vector<MemberNumbers>& numbers);

}  // namespace hyrax
