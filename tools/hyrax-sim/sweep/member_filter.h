// `--where`: which members of a sweep are listed.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/store/ensemble_file.h"

namespace hyrax {

/// Comparisons `FIELD (< <= > >= == !=) NUMBER`, joined by `and` and `or`; `and` binds first. A field is a
/// column of the result file: `x`, `contacts.ground`, `start.vx_px_per_s`. A value that is NaN meets `!=`
/// only.
class MemberFilter {
 public:
  /// ERRORS: Failure(bad_input) "hyrax-sim sweep: --where: ...".
  MemberFilter(std::string_view expression, const std::vector<EnsembleColumn>& columns);

  /// Calls `take` with every member of the file that meets the expression, in order.
  void list(const EnsembleReader& file, const std::function<void(std::int64_t member)>& take) const;

 private:
  enum class Order : std::uint8_t { less, less_equal, greater, greater_equal, equal, not_equal };
  struct Comparison {
    std::size_t column = 0;
    std::size_t offset = 0;  ///< In the row, in values.
    Order order = Order::less;
    SweepNumber number;
  };
  using Rows = std::vector<std::vector<std::byte>>;

  [[nodiscard]] bool meets(const Comparison& comparison, const EnsembleColumn& column,
                           const std::byte* row) const;
  [[nodiscard]] bool meets(const std::vector<EnsembleColumn>& columns, const Rows& rows,
                           std::size_t row) const;

  /// One of these, of which all.
  std::vector<std::vector<Comparison>> any_of_;
};

}  // namespace hyrax
