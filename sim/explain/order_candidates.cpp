#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "sim/explain/candidate.h"
#include "sim/explain/statement_text.h"
#include "sim/explain/step_site.h"
#include "sim/motion/listing.h"

namespace hyrax {
namespace {

// Statements `first` .. `end - 1` of a list.
struct StatementRange {
  std::size_t first;
  std::size_t end;
};

// Before `place` in the list as it was.
StepStatements moved(StepStatements list, StatementRange range, std::size_t place) {
  const auto begin = list.begin();
  const auto in = [&](std::size_t index) { return begin + static_cast<std::ptrdiff_t>(index); };
  if (place < range.first)
    std::rotate(in(place), in(range.first), in(range.end));
  else
    std::rotate(in(range.first), in(range.end), in(place));
  return list;
}

bool is_one_operation(const StepStatements& list, StatementRange range) {
  return list[range.first].operation == list[range.end - 1].operation;
}

// A whole operation by its name, a single statement of one by its text.
std::string range_text(const StepStatements& list, StatementRange range) {
  if (range.end - range.first > 1)
    return is_one_operation(list, range) ? std::string(name_of(list[range.first].operation)) : "the walls";
  const Statement& statement = list[range.first];
  return statement.form == Statement::Form::accelerate ? std::string(name_of(statement.operation))
                                                       : statement_text(statement);
}

class OrderCandidates {
 public:
  explicit OrderCandidates(const Constants& golden) : base_(listing(golden)) {}

  std::vector<Candidate> make() {
    constexpr StatementRange kOperations[] = {{0, 1}, {1, 3}, {3, 5}, {5, 6}, {6, 7}, {5, 7}};
    constexpr StatementRange kSingle[] = {{1, 2}, {2, 3}, {3, 4}, {4, 5}};
    for (const StatementRange range : kOperations) add_earlier(range);
    for (const StatementRange range : kSingle) add_earlier(range);
    for (const StatementRange range : kOperations) add_later(range);
    for (const StatementRange range : kSingle) add_later(range);
    add_inner();
    return std::move(candidates_);
  }

 private:
  void add_earlier(StatementRange range) {
    for (std::size_t place = range.first; place-- > 0;)
      add(range, moved(base_, range, place),
          range_text(base_, range) + " before " + place_text({place, place + 1}, range));
  }
  void add_later(StatementRange range) {
    for (std::size_t place = range.end + 1; place <= base_.size(); ++place)
      add(range, moved(base_, range, place),
          range_text(base_, range) + " after " + place_text({place - 1, place}, range));
  }
  // The operation at that place, unless it has two statements that the move parts.
  std::string place_text(StatementRange at, StatementRange range) const {
    for (const StatementRange pair : {StatementRange{1, 3}, StatementRange{3, 5}}) {
      const bool is_whole = range.first >= pair.end ? at.first == pair.first : at.end == pair.end;
      if (at.first >= pair.first && at.end <= pair.end && is_whole &&
          !(range.first >= pair.first && range.end <= pair.end))
        return range_text(base_, pair);
    }
    return range_text(base_, at);
  }
  void add(StatementRange range, StepStatements step, const std::string& detail) {
    const std::string_view operation =
        is_one_operation(base_, range) ? name_of(base_[range.first].operation) : kSeveralOperations;
    candidates_.emplace_back(operation, CauseKind::order, detail, std::move(step));
  }

  // Each statement of a wall before each earlier one, and the second wall of an axis before the first.
  void add_inner() {
    const std::vector<StepSite> all = sites_of(base_);
    for (std::size_t site = 0; site < all.size(); ++site) {
      const StepSite& from = all[site];
      if (from.list == &base_) continue;
      for (std::size_t place = from.index; place-- > 0;) {
        StepStatements step = edited(base_, {site}, [&](const StepSite& at) {
          *at.list = moved(*at.list, {at.index, at.index + 1}, place);
        });
        candidates_.emplace_back(name_of(from.statement().operation), CauseKind::order,
                                 fmt::format("{}{} before {}", from.wall, statement_text(from.statement()),
                                             statement_text((*from.list)[place])),
                                 std::move(step));
      }
    }
  }

  StepStatements base_;
  std::vector<Candidate> candidates_;
};

}  // namespace

std::vector<Candidate> order_candidates(const Constants& golden) { return OrderCandidates(golden).make(); }

}  // namespace hyrax
