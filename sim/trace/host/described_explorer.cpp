#include "sim/trace/host/described_explorer.h"

#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "sim/trace/decision_tree.h"
#include "sim/trace/host/recorder.h"

namespace hyrax::trace {
namespace {

constexpr std::int64_t kCasesMax = 16;
constexpr std::string_view kUndeclared = "undeclared ";  // No name of a value has a blank.

using Bytes = std::vector<std::byte>;

[[noreturn]] void stop_because(const std::string& why) { stop(why.c_str()); }

[[noreturn]] void refuse_change() {
  stop("a member that is not declared changes, and is no recorded number");
}

Index whole(std::int64_t number) { return record_constant(NumberKind::whole, static_cast<double>(number)); }

Slot slot_at(const Bytes& memory, std::size_t at) {
  Slot slot{};
  std::memcpy(&slot, memory.data() + at, sizeof slot);
  return slot;
}

// Where recording numbers are in the memory of a core.
std::vector<std::size_t> slots_in(const Bytes& memory) {
  std::vector<std::size_t> slots;
  for (std::size_t at = 0; at + sizeof(Slot) <= memory.size();) {
    const bool is_number = slot_at(memory, at).is_number();
    if (is_number) slots.push_back(at);
    at += is_number ? sizeof(Slot) : sizeof(double);
  }
  return slots;
}

class DescribedExplorer final : public DescribedPass {
 public:
  explicit DescribedExplorer(const DescribedCalls& core) : core_(core) {
    if (!core.is_trivially_copyable)
      stop("memory outside the body: struct hyrax_core is not trivially copyable");
    if (core.align_bytes > __STDCPP_DEFAULT_NEW_ALIGNMENT__)
      stop("struct hyrax_core has a larger alignment than memory from new");
    if (!core.reads_alone) stop("contacts, outputs or properties may change the core: they are not const");
    body_.resize(core.size_bytes);
    construct(initial_);
    Bytes other;
    construct(other);
    if (initial_ != other) stop("memory outside the body: a pointer, or a member without a value");
    core.actions(body_.data(), *this);
  }

  TracedStep trace() {
    TracedStep step;
    std::size_t changed_before = 0;
    do {
      changed_before = changed_.size();
      step.paths.clear();
      std::size_t paths = 0;
      for (std::size_t function = 0; function < functions_.size(); ++function)
        step.paths.push_back(paths_of([&] { return run(function); }, paths));
      // What such a member holds is not known: it is an argument, on which no step may depend.
      for (const auto& [at, kind] : changed_) {
        const Slot slot{.value = 0.0,
                        .expression = record_argument(kind, std::string(kUndeclared) + std::to_string(at)),
                        .tag = 0};
        std::memcpy(initial_.data() + at, &slot, offsetof(Slot, tag));
      }
    } while (changed_.size() != changed_before);
    step.members = kinds_;
    step.members.resize(names_.size(), NumberKind::whole);
    step.member_names = names_;
    step.function_names = functions_;
    return step;
  }

  void enter(std::string_view part) override {
    ends_.push_back(name_.size());
    if (!name_.empty()) name_ += '.';
    name_ += part;
  }
  void enter(std::size_t place) override { enter(std::to_string(place)); }
  void leave() override {
    name_.resize(ends_.back());
    ends_.pop_back();
  }
  void refuse(std::string_view name, std::string_view why) override {
    stop_because(std::string(name).append(why));
  }

  [[nodiscard]] bool is_setting() const override { return is_setting_; }
  Index given(NumberKind kind) override {
    if (given_.size() == kStepMembersMax) stop("more than 32 values");
    names_.push_back(name_);
    kinds_.push_back(kind);
    before_set_ = body_;
    return given_.emplace_back(record_argument(kind, name_));
  }
  std::int64_t given(std::int64_t low, std::int64_t high) override {
    constexpr std::int64_t kMagnitudeMax = std::int64_t{1} << 31;
    if (low < -kMagnitudeMax || high > kMagnitudeMax || high < low || high - low >= kCasesMax)
      stop_because(name_ +
                   " is no double, float, int or bool, and has no limits or names of at most 16 values");
    const std::int64_t number = one_of(low, high, given(NumberKind::whole));
    given_.back() = whole(number);
    return number;
  }
  void end_set(std::size_t native_bytes) override {
    const auto differs = [&](std::size_t at) { return body_[at] != before_set_[at]; };
    std::size_t first = 0, end = body_.size();
    while (first < end && !differs(first)) ++first;
    while (end > first && !differs(end - 1)) --end;
    bool sets_one = end - first <= native_bytes;
    if (native_bytes == 0)
      for (const std::size_t at : slots_in(body_))
        if (first >= at && end <= at + sizeof(Slot) && slot_at(body_, at).expression == given_.back()) {
          declared_.insert(at);
          sets_one = true;
        }
    if (!sets_one) stop_because(name_ + ": its setter does not set one member alone");
  }
  void read(Index value) override { read_.push_back(value); }
  void read(std::int64_t value, std::int64_t low, std::int64_t high) override {
    if (value < low || value > high) stop_because(name_ + " leaves its limits");
    read(whole(value));
  }
  void end_parameters() override {
    if (is_setting_) parameters_ = given_.size();
  }
  void add_contact(std::string_view name, bool is_touched) override {
    contacts_.emplace_back(name);
    read(whole(is_touched ? 1 : 0));
  }

  bool wants_action(std::string_view name, std::span<const std::string_view> arguments) override {
    if (wanted_ != 0) return ++next_ == wanted_;
    std::string text(name);
    for (const std::string_view argument : arguments)
      text.append(text.size() == name.size() ? "(" : ", ").append(argument);
    functions_.push_back(text + (arguments.empty() ? "()" : ")"));
    return false;
  }
  Index argument(NumberKind kind, std::string_view name) override {
    const std::string& function = functions_[wanted_];
    return record_argument(kind, function.substr(0, function.find('(') + 1).append(name) + ")");
  }

 private:
  void construct(Bytes& bytes) const {
    bytes.resize(core_.size_bytes);
    core_.construct(bytes.data());
  }

  // Which of these the number is on the path that is taken.
  static std::int64_t one_of(std::int64_t low, std::int64_t high, Index number) {
    while (low < high && !decide(Relation::equal, number, whole(low))) ++low;
    return low;
  }

  void pass_values(bool is_setting) {
    is_setting_ = is_setting;
    if (is_setting) {
      names_.clear();
      kinds_.clear();
      given_.clear();
    }
    read_.clear();
    core_.values(body_.data(), *this);
  }

  // What the function makes of every member on the path that is taken.
  std::vector<Index> run(std::size_t function) {
    body_ = initial_;
    pass_values(true);
    const Bytes before = body_;
    pass_values(false);
    for (std::size_t value = 0; value < given_.size(); ++value)
      if (read_[value] != given_[value])
        stop_because(names_[value] + ": its getter does not give what its setter was given");
    call(function);
    pass_values(false);
    for (std::size_t value = 0; value < parameters_; ++value)
      if (read_[value] != given_[value]) stop_because("the parameter " + names_[value] + " changes");
    if (function == 0) {
      contacts_.clear();
      core_.contacts(body_.data(), *this);
      if (contacts_.size() > kStepContactsMax) stop("more than 32 contacts");
    }
    std::vector<Index> ends = read_;
    ends.resize(given_.size() + contacts_.size(), whole(0));
    find_changes(before);
    names_.insert(names_.end(), contacts_.begin(), contacts_.end());
    return ends;
  }

  void call(std::size_t function) {
    if (function == 0) return core_.step(body_.data(), Real::of(record_argument(NumberKind::real, "dt")));
    wanted_ = function;
    next_ = 0;
    core_.actions(body_.data(), *this);
  }

  // Of members that are not declared. Ends as after `before`.
  void find_changes(const Bytes& before) {
    const std::vector<std::size_t> slots = slots_in(before);
    if (slots != slots_in(body_)) refuse_change();
    for (const std::size_t at : slots) {
      if (!declared_.contains(at) && std::memcmp(body_.data() + at, before.data() + at, sizeof(Slot)) != 0)
        changed_[at] = slot_at(body_, at).kind();
      std::memcpy(body_.data() + at, before.data() + at, sizeof(Slot));
    }
    pass_values(true);
    if (body_ != before) refuse_change();
  }

  const DescribedCalls& core_;
  Bytes initial_ = {};
  Bytes body_ = {};  // As it goes on.
  Bytes before_set_ = {};
  std::set<std::size_t> declared_ = {};             // Where in the body values are recording numbers.
  std::map<std::size_t, NumberKind> changed_ = {};  // Where such numbers change that are not declared.

  std::string name_ = {};  // Of the value that is passed.
  std::vector<std::size_t> ends_ = {};
  bool is_setting_ = false;
  std::vector<std::string> names_ = {};  // Of values, then of contacts.
  std::vector<std::string> contacts_ = {};
  std::vector<NumberKind> kinds_ = {};
  std::vector<Index> given_ = {};
  std::vector<Index> read_ = {};
  std::size_t parameters_ = 0;                     // How many of the values they are.
  std::vector<std::string> functions_ = {"step"};  // With the names of their arguments.
  std::size_t wanted_ = 0;                         // Of the functions; 0: actions are listed.
  std::size_t next_ = 0;
};

void require_declared(const TracedStep& step) {
  std::vector<bool> needed(step.expressions.size());
  for (const std::vector<StepPath>& paths : step.paths)
    for (const StepPath& path : paths) add_ends(step, path, needed);
  add_operands(step, needed);
  for (std::size_t index = 0; index < needed.size(); ++index)
    if (needed[index] && step.expressions[index].name.starts_with(kUndeclared))
      stop("a member that is not declared changes, and decides what the step does");
}

}  // namespace

TracedStep trace_described(const DescribedCalls& core) {
  start_recording();
  DescribedExplorer explorer(core);
  TracedStep step = explorer.trace();
  // Static variables that a path changed are seen by the next one.
  if (step != explorer.trace()) stop(kMemoryOutside);
  step.expressions = recorded_expressions();
  step.comparisons = recorded_comparisons();
  require_declared(step);
  return step;
}

}  // namespace hyrax::trace
