// Two runs in one picture: both paths, both sprites where they are farthest apart, magnified, and their
// distance over time.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim/result/figure.h"
#include "sim/trajectory/row.h"

namespace hyrax {

/// Gathers pairs of rows for a figure. Of a long run only so many pairs are kept that a picture can show, of
/// neighbours the one of the largest distance. Memory is bounded.
class Overlay {
 public:
  static constexpr std::size_t kPairsMax = 20'000;
  static_assert(kPairsMax % 2 == 0);  // Two become one.

  /// Pairs in order of time. One that is not finite is left out.
  void add(const Row& a, const Row& b);

  struct Texts {
    std::string title;
    std::string subtitle;
    std::string a;  ///< Names of the runs.
    std::string b;
    Size window;  ///< At the start: drawn as walls,
    Size sprite;  ///< whose centre the paths are of.
  };
  [[nodiscard]] Figure figure(const Texts& texts) const;

 private:
  struct Pair {
    double t_s = 0.0;
    Position a;
    Position b;
    double px = 0.0;
  };

  std::vector<Pair> kept_;
  std::size_t stride_ = 1;  // So many pairs become one.
  std::size_t seen_ = 0;    // Of the stride that is not complete.
  Pair farthest_;           // Of these.
  std::optional<Pair> start_, first_difference_, end_;
};

}  // namespace hyrax
