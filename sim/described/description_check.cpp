#include <algorithm>
#include <array>
#include <string>

#include "sim/described/described_run.h"
#include "sim/described/scripted_body.h"

namespace hyrax {
namespace {

/// A row's bits, without time.
struct RowBits {
  std::vector<Word> state = {};
  std::vector<std::uint8_t> contacts = {};

  RowBits(const Description& description, const ScriptedBody& body)
      : state(description.state.values.size()), contacts(description.contacts.size()) {
    body.body().read(SettableList::state, state);
    body.contacts(contacts);
  }
  /// The first value or contact that differs in another row; empty: none.
  [[nodiscard]] std::string difference(const Description& description, const RowBits& other) const {
    for (std::size_t place = 0; place < state.size(); ++place)
      if (state[place] != other.state[place]) return description.state.values[place].name;
    for (std::size_t place = 0; place < contacts.size(); ++place)
      if (contacts[place] != other.contacts[place]) return "the contact " + description.contacts[place];
    return {};
  }
};

std::string at_row(std::int64_t row) { return " at row " + std::to_string(row); }

/// Every value of the list.
std::vector<std::optional<Word>> values_of(const Description& description, DescribedBody& body,
                                           SettableList list) {
  std::vector<Word> words(list_of(description, list).values.size());
  body.read(list, words);
  return {words.begin(), words.end()};
}

class DescriptionCheck {
 public:
  DescriptionCheck(const FrameScript& script, std::int64_t rows_max)
      : script_(script), description_(script.core.description), rows_(std::min(script.steps, rows_max)) {}

  /// Two bodies, one after the other in each frame; in the first one, what it was given and its parameters.
  std::optional<std::string> second_run_fault() {
    std::optional<std::string> fault;
    std::optional<ScriptedBody> first;
    std::optional<ScriptedBody> second;
    std::vector<std::optional<Word>> parameters;
    for (std::int64_t row = 0; row <= rows_; ++row) {
      if (!advance(first)) break;
      const RowBits bits(description_, *first);
      if (!fault) fault = given_fault(*first, row);
      const auto now = values_of(description_, first->body(), SettableList::parameters);
      if (row > 0 && !fault) fault = parameter_fault(parameters, now, row);
      parameters = now;
      if (const std::string difference = advance_and_compare(second, bits); !difference.empty())
        return "a second run is not the same: " + difference + " differs" + at_row(row) +
               "; has the core static state?";
    }
    return fault;
  }

  /// Bodies made from that of the run at some rows. They go on beside it, and must give its rows.
  std::optional<std::string> companion_fault(bool is_copy) {
    std::optional<ScriptedBody> original;
    Companion by_row;
    Companion by_change;
    std::int64_t changes = 0;
    for (std::int64_t row = 0; row <= rows_; ++row) {
      if (!advance(original)) break;
      const RowBits bits(description_, *original);
      for (Companion* companion : {&by_row, &by_change})
        if (auto fault = row_fault(*companion, bits, row, is_copy)) return fault;
      const auto is_power_of_2 = [](std::int64_t n) { return (n & (n - 1)) == 0; };
      if (is_power_of_2(row))
        if (auto fault = make_companion(by_row, *original, is_copy)) return fault;
      if (original->was_changed() && is_power_of_2(++changes))
        if (auto fault = make_companion(by_change, *original, is_copy)) return fault;
    }
    return {};
  }

  /// One body at a time, for which at each of the rows a fresh one takes over, set as it was; beside it one
  /// without a stop.
  std::optional<std::string> resumed_fault(const std::vector<std::int64_t>& stops) {
    std::optional<ScriptedBody> whole, resumed;
    std::int64_t stop = -1;
    for (std::int64_t row = 0; row <= rows_; ++row) {
      if (!advance(whole)) break;
      if (const std::string difference = advance_and_compare(resumed, RowBits(description_, *whole));
          !difference.empty()) {
        if (stop < 0) return {};  // Without a stop a second run is not the same.
        return "stopped at row " + std::to_string(stop) + " and resumed, " + difference + " differs" +
               at_row(row);
      }
      if (std::ranges::find(stops, row) == stops.end()) continue;
      stop = row;
      Companion next;
      if (auto fault = make_companion(next, *resumed, !description_.undeclared.empty())) return fault;
      resumed.emplace(std::move(*next.body));
    }
    return {};
  }

 private:
  struct Companion {
    std::optional<ScriptedBody> body = {};
    std::int64_t made_at = 0;
  };

  /// To the next row, at first to row 0. Whether there is one: a run that ends is not held to it.
  bool advance(std::optional<ScriptedBody>& body) const {
    return !thrown_by([&] {
      if (!body)
        body.emplace(script_);
      else
        body->play_frame();
      static_cast<void>(RowBits(description_, *body));
    });
  }
  /// The first that differs from the other's row; empty: none.
  std::string advance_and_compare(std::optional<ScriptedBody>& body, const RowBits& other) const {
    return advance(body) ? other.difference(description_, RowBits(description_, *body))
                         : "whether it goes on";
  }

  std::optional<std::string> given_fault(const ScriptedBody& body, std::int64_t row) const {
    if (!body.not_held()) return {};
    const std::string& name =
        list_of(description_, body.not_held()->list).values[body.not_held()->place].name;
    return "the core does not hold the value of " + name + " that is set " +
           (row == 0 ? std::string("before row 0") : "in frame " + std::to_string(row - 1)) +
           ": its getter gives another";
  }

  std::optional<std::string> parameter_fault(const std::vector<std::optional<Word>>& before,
                                             const std::vector<std::optional<Word>>& now,
                                             std::int64_t row) const {
    const auto place =
        static_cast<std::size_t>(std::mismatch(now.begin(), now.end(), before.begin()).first - now.begin());
    if (place == now.size()) return {};
    return "the parameter " + description_.parameters.values[place].name + " changes" + at_row(row) +
           "; what changes in a run is state";
  }

  std::optional<std::string> make_companion(Companion& companion, const ScriptedBody& original,
                                            bool is_copy) const {
    companion.made_at = original.row();
    companion.body.reset();
    std::optional<std::string> fault;
    const std::optional<std::string> thrown = thrown_by([&] {
      const std::string other = description_difference(description_, original.body().describe());
      if (!other.empty()) fault = "the lists are not the same in every call: " + other + ",";
      companion.body.emplace(original, is_copy ? original.body().copy() : script_.core.make());
      if (!is_copy && !fault) fault = setter_fault(original.body(), companion.body->body());
    });
    if (thrown)
      return std::string(is_copy ? "a copy made" : "a core set") + at_row(original.row()) +
             " throws: " + *thrown;
    if (fault) *fault += at_row(original.row());
    return fault;
  }

  /// Sets all lists of a body as those of another.
  std::optional<std::string> setter_fault(DescribedBody& from, DescribedBody& to) const {
    constexpr std::array kLists = {SettableList::parameters, SettableList::inputs, SettableList::state};
    std::array<std::vector<std::optional<Word>>, kLists.size()> given;
    const auto set = [&](std::size_t lists) {
      for (std::size_t list = 0; list < lists; ++list) to.set(kLists[list], given[list]);
    };
    for (std::size_t list = 0; list < kLists.size(); ++list)
      given[list] = values_of(description_, from, kLists[list]);
    set(kLists.size());
    for (std::size_t list = 0; list < kLists.size(); ++list) {
      const auto now = values_of(description_, to, kLists[list]);
      const auto place = std::mismatch(now.begin(), now.end(), given[list].begin()).first - now.begin();
      if (place == std::ssize(now)) continue;
      // The value was held until this one was set, in the order of all.
      std::string changed_by;
      bool was_held = true;
      for (std::size_t last = list; last < kLists.size(); ++last)
        for (std::ptrdiff_t end = last == list ? place : 0; end < std::ssize(given[last]); ++end) {
          set(last);
          auto part = given[last];
          std::fill(part.begin() + end + 1, part.end(), std::nullopt);
          to.set(kLists[last], part);
          const auto at = static_cast<std::size_t>(place);
          const bool is_held = values_of(description_, to, kLists[list])[at] == given[list][at];
          if (was_held && !is_held) changed_by = name_of(kLists[last], end);
          was_held = is_held;
        }
      const std::string name = name_of(kLists[list], place);
      if (changed_by.empty() || changed_by == name)
        return "the setter of " + name + " does not give back what its getter gave";
      return "the setter of " + changed_by.append(" changes ").append(name) + ", which is set before it,";
    }
    return {};
  }
  std::string name_of(SettableList list, std::ptrdiff_t place) const {
    return list_of(description_, list).values[static_cast<std::size_t>(place)].name;
  }

  std::optional<std::string> row_fault(Companion& companion, const RowBits& bits, std::int64_t row,
                                       bool is_copy) const {
    if (!companion.body) return {};
    const std::string difference = advance_and_compare(companion.body, bits);
    if (difference.empty()) return {};
    const std::string from = std::to_string(companion.made_at) + ", " + difference + " differs" + at_row(row);
    return is_copy ? "a copy does not go on as its original: copied at row " + from +
                         "; does a member point into the core?"
                   : "the state is not complete: set from row " + from +
                         "; a member that changes is not declared";
  }

  const FrameScript& script_;
  const Description& description_;
  std::int64_t rows_;
};

}  // namespace

std::optional<std::string> description_fault(const DescribedCore& core, const DescribedScenario& scenario,
                                             std::int64_t rows_max, const DescribedSummary* played) {
  const FrameScript script(core, scenario);
  const std::int64_t rows = played != nullptr ? played->steps : script.steps;
  DescriptionCheck check(script, std::min(rows, rows_max));
  std::optional<std::string> fault = check.second_run_fault();
  // What is kept from the first run on, both of those bodies have in common.
  if (!fault && played != nullptr && rows <= rows_max &&
      play(core, scenario, {}).state_hash != played->state_hash)
    fault = "a second run is not the same: its state hash differs; has the core static state?";
  if (!fault) fault = check.companion_fault(true);
  if (!fault && core.description.undeclared.empty()) fault = check.companion_fault(false);
  return fault;
}

std::optional<std::string> resumed_fault(const DescribedCore& core, const DescribedScenario& scenario,
                                         std::int64_t rows_max) {
  const FrameScript script(core, scenario);
  std::vector<std::int64_t> stops = {script.steps / 3, 2 * script.steps / 3};
  for (const std::int64_t frame : script.event_frames) {
    if (frame == 0) continue;
    stops.push_back(frame);
    break;
  }
  return DescriptionCheck(script, rows_max).resumed_fault(stops);
}

}  // namespace hyrax
