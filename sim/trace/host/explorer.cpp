#include "sim/trace/host/explorer.h"

#include <algorithm>

#include "sim/trace/host/recorder.h"

namespace hyrax::trace {
namespace {

class Explorer {
 public:
  explicit Explorer(const TracedCore& core) : core_(core), slots_(core.size_bytes / sizeof(Slot)) {
    if (!core.is_trivially_copyable) stop("memory outside the body: class physics is not trivially copyable");
    if (core.size_bytes % sizeof(Slot) != 0) stop(kOtherMember);
    if (slots_.size() > kStepMembersMax) stop("more than 32 members");
    start_path({}, false);
    call(CoreFunction::construct);
    for (const Slot& slot : slots_)
      if (!slot.is_number()) stop(kOtherMember);
    find_members();
  }

  // In the order of TracedStep::members.
  [[nodiscard]] std::vector<NumberKind> members() const {
    std::vector<NumberKind> kinds;
    for (const std::size_t slot : order_) kinds.push_back(before_[slot].kind());
    return kinds;
  }

  std::vector<StepPath> paths_of(CoreFunction function) {
    const auto run = [&] {
      if (function != CoreFunction::construct) slots_ = before_;
      call(function);
      std::vector<Index> members;
      for (const std::size_t slot : order_) members.push_back(slots_[slot].index());
      return members;
    };
    return trace::paths_of(run, paths_);
  }

 private:
  static constexpr char kOtherMember[] =
      "memory outside the body: a member that is not double, float, int or bool";

  void call(CoreFunction function) {
    const auto& names = kArgumentNames[static_cast<std::size_t>(function)];
    const bool is_update = function == CoreFunction::update;
    std::array<Real, 4> numbers;
    std::array<Whole, 4> sizes;
    for (std::size_t i = 0; i < 4; ++i) {
      if (is_update ? i == 0 : !names[i].empty())
        numbers[i] = Real::of(record_argument(NumberKind::real, std::string(names[i])));
      if (is_update) sizes[i] = Whole::of(record_argument(NumberKind::whole, std::string(names[i + 1])));
    }
    core_.call(function, slots_.data(), numbers.data(), sizes.data());
  }

  // Gives each member a name of its own, and sees which of them x(), y(), vx() and vy() return.
  void find_members() {
    before_ = slots_;
    name_members([](std::size_t slot) { return "slot_" + std::to_string(slot); });
    std::vector<bool> is_found(before_.size());
    for (const Real& number : core_.read(before_.data())) {
      const auto slot = std::find_if(before_.begin(), before_.end(), [&](const Slot& member) {
        return number.expression == member.expression ||
               number.expression == record(Operator::to_real, NumberKind::real, member.expression);
      });
      if (slot == before_.end() || is_found[static_cast<std::size_t>(slot - before_.begin())])
        stop("memory outside the body: x(), y(), vx() and vy() are not four members");
      order_.push_back(static_cast<std::size_t>(slot - before_.begin()));
      is_found[order_.back()] = true;
    }
    for (std::size_t slot = 0; slot < before_.size(); ++slot)
      if (!is_found[slot]) order_.push_back(slot);
    name_members([&](std::size_t slot) {
      return member_name(
          static_cast<std::size_t>(std::find(order_.begin(), order_.end(), slot) - order_.begin()));
    });
  }

  template <class Name>
  void name_members(const Name& name) {
    for (std::size_t slot = 0; slot < before_.size(); ++slot)
      before_[slot].expression = record_argument(before_[slot].kind(), name(slot));
  }

  const TracedCore& core_;
  std::vector<Slot> slots_;
  std::vector<Slot> before_;        // Every member as an argument.
  std::vector<std::size_t> order_;  // Slots, in the order of the members.
  std::size_t paths_ = 0;
};

}  // namespace

TracedStep trace_core(const TracedCore& core) {
  start_recording();
  const auto paths = [&core] {
    Explorer explorer(core);
    TracedStep step;
    step.members = explorer.members();
    for (std::size_t function = 0; function < kCoreFunctions; ++function)
      step.paths[function] = explorer.paths_of(static_cast<CoreFunction>(function));
    return step;
  };
  TracedStep step = paths();
  // Static variables that a path changed are seen by the next one.
  if (step != paths()) stop(kMemoryOutside);
  step.expressions = recorded_expressions();
  step.comparisons = recorded_comparisons();
  return step;
}

}  // namespace hyrax::trace
