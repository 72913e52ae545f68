// What the lists of a core's header are compiled with: visitors that are called as see(NAME, ...), and a
// body.
//
// Names are asked for once, when a core is described; after that values are read and set by their place.
#pragma once

#include <bit>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/described/described_core.h"
#include "sim/described/see_forms.h"

// Brought into the global namespace after a core's header: ::hyrax_core is this one only if the header has
// none.
namespace hyrax_missing {
struct hyrax_core;
}  // namespace hyrax_missing

namespace hyrax::see {

/// Lists what is declared.
template <bool kIsOutput>
class Describer : public SeeValues<Describer<kIsOutput>, kIsOutput> {
 public:
  [[nodiscard]] ValueList& list() { return list_; }
  [[nodiscard]] std::vector<std::string>& undeclared_names() { return undeclared_names_; }

  void enter(std::string_view part) {
    ends_.push_back(name_.size());
    if (!name_.empty()) name_ += '.';
    name_ += part;
  }
  void enter(std::size_t place) { enter(std::string_view(std::to_string(place))); }
  void leave() {
    name_.resize(ends_.back());
    ends_.pop_back();
  }
  void enter_range(std::size_t length) { list_.ranges.push_back({name_, length}); }
  void undeclared(std::string_view name) {
    enter(name);
    undeclared_names_.push_back(name_);
    leave();
  }

  template <class V, class Get, class Set, class Note>
  void value(const Get& get, const Set& /*set*/, const Note& note) {
    ValueInfo info = {.name = name_, .type = value_type<V>(), .unit = unit_of(name_)};
    info.is_enum = std::is_enum_v<V>;
    if constexpr (!kIsOutput) info.initial = word_of<V>(get());
    if constexpr (std::is_same_v<Note, Names>)
      for (const NameText& name : note.names) info.names.emplace_back(name.text);
    else if constexpr (!std::is_same_v<Note, NoNote>)
      info.limits = {word_of(static_cast<V>(note.low)), word_of(static_cast<V>(note.high))};
    list_.values.push_back(std::move(info));
  }

 private:
  ValueList list_ = {};
  std::vector<std::string> undeclared_names_ = {};
  std::string name_ = {};
  std::vector<std::size_t> ends_ = {};
};

[[noreturn]] inline void throw_list_changed(std::string_view list) {
  throw std::runtime_error("the list of " + std::string(list) + " is not as long as in the description");
}

/// Goes along a list that is described.
class Places {
 public:
  explicit Places(const ValueList& list) : list_(list), count_(list.values.size()) {}
  void enter(std::string_view /*part*/) {}
  void enter(std::size_t /*place*/) {}
  void leave() {}
  void enter_range(std::size_t length) {
    if (range_ == list_.ranges.size()) throw_list_changed("values");
    const RangeInfo& range = list_.ranges[range_++];
    if (range.length != length) throw RangeLengthChanged(range.name, range.length, length);
  }
  void finish() const {
    if (place_ != count_ || range_ != list_.ranges.size()) throw_list_changed("values");
  }

 protected:
  std::size_t next() {
    if (place_ == count_) throw_list_changed("values");
    return place_++;
  }

 private:
  const ValueList& list_;
  const std::size_t count_;
  std::size_t place_ = 0;
  std::size_t range_ = 0;
};

template <bool kIsOutput>
class Reader : public SeeValues<Reader<kIsOutput>, kIsOutput>, public Places {
 public:
  Reader(const ValueList& list, std::span<Word> words) : Places(list), words_(words) {}
  template <class V, class Get, class Set, class Note>
  void value(const Get& get, const Set& /*set*/, const Note& /*note*/) {
    const Word word = word_of<V>(get());
    if constexpr (std::is_floating_point_v<V>)
      if (!is_finite(word)) all_are_finite_ = false;
    words_[next()] = word;
  }
  [[nodiscard]] bool all_are_finite() const { return all_are_finite_; }

 private:
  std::span<Word> words_;
  bool all_are_finite_ = true;
};

class Setter : public SeeValues<Setter, false>, public Places {
 public:
  Setter(const ValueList& list, std::span<const std::optional<Word>> words) : Places(list), words_(words) {}
  template <class V, class Get, class Set, class Note>
  void value(const Get& /*get*/, const Set& set, const Note& /*note*/) {
    if (const std::optional<Word>& word = words_[next()]) set(value_of<V>(*word));
  }

 private:
  std::span<const std::optional<Word>> words_;
};

class ActionDescriber : public SeeActions<ActionDescriber> {
 public:
  std::vector<ActionInfo> list = {};

  template <class Arguments, class F>
  void action(std::string_view name, F& /*act*/, std::span<const NameText> names) {
    ActionInfo& info = list.emplace_back(ActionInfo{.name = std::string(name)});
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (info.arguments.push_back({.name = names[I].text,
                                 .type = value_type<std::tuple_element_t<I, Arguments>>(),
                                 .unit = unit_of(names[I].text),
                                 .is_enum = std::is_enum_v<std::tuple_element_t<I, Arguments>>}),
       ...);
    }
    (std::make_index_sequence<std::tuple_size_v<Arguments>>());
  }
};

class ActionCaller : public SeeActions<ActionCaller> {
 public:
  ActionCaller(std::size_t wanted, std::span<const Word> given) : wanted_(wanted), given_(given) {}

  template <class Arguments, class F>
  void action(std::string_view /*name*/, F& act, std::span<const NameText> /*names*/) {
    if (next_++ != wanted_) return;
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      Arguments arguments(value_of<std::tuple_element_t<I, Arguments>>(given_[I])...);
      static_cast<void>(std::apply(act, arguments));
    }
    (std::make_index_sequence<std::tuple_size_v<Arguments>>());
  }
  void finish() const {
    if (next_ <= wanted_) throw_list_changed("actions");
  }

 private:
  std::size_t wanted_;
  std::span<const Word> given_;
  std::size_t next_ = 0;
};

/// Contacts and properties: conditions with names, or their values alone.
class Conditions {
 public:
  Conditions() = default;
  explicit Conditions(std::span<std::uint8_t> flags) : flags_(flags), reads_(true) {}
  Conditions(const Conditions&) = delete;
  Conditions& operator=(const Conditions&) = delete;

  [[nodiscard]] std::vector<PropertyInfo>& list() { return list_; }

  void add(std::string_view name, bool is_always, bool condition) {
    if (!reads_) return list_.push_back({std::string(name), is_always});
    if (next_ == flags_.size()) throw_list_changed("conditions");
    flags_[next_++] = condition ? 1 : 0;
  }
  void finish() const {
    if (next_ != flags_.size()) throw_list_changed("conditions");
  }

 private:
  std::vector<PropertyInfo> list_ = {};
  std::span<std::uint8_t> flags_ = {};
  std::size_t next_ = 0;
  bool reads_ = false;
};
struct ContactConditions : Conditions {
  using Conditions::Conditions;
  template <class T>
  void operator()(std::string_view name, T&& condition) {
    add(name, true, static_cast<bool>(condition));
  }
  template <class... Given>
  requires(!kIsNamed<Given...>) void operator()(Given&&... /*given*/) {
    static_assert(kNever<Given...>, "hyrax: a contact is see(NAME, CONDITION)");
  }
};
struct PropertyConditions : Conditions {
  using Conditions::Conditions;
  template <class... Given>
  void always(Given&&... given) {
    property(true, given...);
  }
  template <class... Given>
  void sometimes(Given&&... given) {
    property(false, given...);
  }
  template <class Name, class... Given>
  void operator()(const Name& name, Given&&... /*given*/) {
    property(true, name);
  }

 private:
  template <class T>
  void property(bool is_always, std::string_view name, T& condition) {
    add(name, is_always, static_cast<bool>(condition));
  }
  template <class... Given>
  requires(!kIsNamed<Given...>) void property(bool /*is_always*/, Given&... /*given*/) {
    static_assert(kNever<Given...>,
                  "hyrax: a property is see.always(NAME, CONDITION) or see.sometimes(NAME, CONDITION)");
  }
};

/// Takes any list, so that one that the visitors cannot pass is found.
struct AnyVisitor {};

// A list is wrong that is const for its visitor, or that cannot be called: `Found` then has the name twice
// and &Found is ambiguous, whatever the access.
// NOLINTBEGIN(bugprone-macro-parentheses): no type is in parentheses.
#define HYRAX_LIST(name, Visitor)                                                 \
  template <class C>                                                              \
  concept Has_##name = requires(C & core, Visitor & see) {                        \
    core.name(see);                                                               \
  };                                                                              \
  struct Another_##name {                                                         \
    void name();                                                                  \
  };                                                                              \
  template <class C>                                                              \
  struct Found_##name : C, Another_##name {};                                     \
  template <class C>                                                              \
  concept Hides_##name = std::is_class_v<C> && !std::is_final_v<C> && !requires { \
    &C::name;                                                                     \
  }                                                                               \
  &&!requires { typename C::name; }                                               \
  &&!requires { &Found_##name<C>::name; };                                        \
  template <class C>                                                              \
  concept IsWrong_##name = requires(C & core, const AnyVisitor& see) {            \
    core.template name<AnyVisitor>(see);                                          \
  }                                                                               \
  || (!Has_##name<C> && (Hides_##name<C> || requires(C & core, AnyVisitor & see) { core.name(see); }))
// NOLINTEND(bugprone-macro-parentheses)
HYRAX_LIST(state, Describer<false>);
HYRAX_LIST(inputs, Describer<false>);
HYRAX_LIST(parameters, Describer<false>);
HYRAX_LIST(actions, ActionDescriber);
HYRAX_LIST(contacts, ContactConditions);
HYRAX_LIST(outputs, Describer<true>);
HYRAX_LIST(properties, PropertyConditions);
#undef HYRAX_LIST

#define HYRAX_MISSPELT(wrong, right)                                          \
  static_assert(!(requires(C & core, AnyVisitor & see) { core.wrong(see); }), \
                "hyrax_core: the list " #wrong "(see) is named " #right)
#define HYRAX_PUBLIC(name)          \
  static_assert(!IsWrong_##name<C>, \
                "hyrax_core: the list " #name " is public template <class See> void " #name "(See&& see)")

/// Refuses what is no core, each fault in a sentence.
template <class C>
[[nodiscard]] consteval bool is_core() {
  if constexpr (std::is_same_v<C, hyrax_missing::hyrax_core>) {
    static_assert(kNever<C>, "hyrax_core: the header has no global struct hyrax_core");
    return false;
  } else {
    static_assert(std::is_default_constructible_v<C>, "hyrax_core: has no default constructor");
    static_assert(std::is_copy_constructible_v<C>, "hyrax_core: is not copyable");
    static_assert(
        requires(C & core) { core.step(1.0); }, "hyrax_core: has no public void step(double dt_s)");
    HYRAX_PUBLIC(state);
    static_assert(Has_state<C>, "hyrax_core: has no template <class See> void state(See&& see)");
    // No other list can be found: no member function template can, but by its name.
    HYRAX_MISSPELT(states, state);
    HYRAX_MISSPELT(input, inputs);
    HYRAX_MISSPELT(controls, inputs);
    HYRAX_MISSPELT(parameter, parameters);
    HYRAX_MISSPELT(params, parameters);
    HYRAX_MISSPELT(constants, parameters);
    HYRAX_MISSPELT(settings, parameters);
    HYRAX_MISSPELT(action, actions);
    HYRAX_MISSPELT(commands, actions);
    HYRAX_MISSPELT(contact, contacts);
    HYRAX_MISSPELT(collisions, contacts);
    HYRAX_MISSPELT(collision, contacts);
    HYRAX_MISSPELT(touches, contacts);
    HYRAX_MISSPELT(output, outputs);
    HYRAX_MISSPELT(observables, outputs);
    HYRAX_MISSPELT(property, properties);
    HYRAX_MISSPELT(invariants, properties);
    HYRAX_MISSPELT(checks, properties);
    HYRAX_PUBLIC(inputs);
    HYRAX_PUBLIC(parameters);
    HYRAX_PUBLIC(actions);
    HYRAX_PUBLIC(contacts);
    HYRAX_PUBLIC(outputs);
    HYRAX_PUBLIC(properties);
    return std::is_default_constructible_v<C> && std::is_copy_constructible_v<C> && Has_state<C> &&
           requires(C & core) {
      core.step(1.0);
    };
  }
}
#undef HYRAX_MISSPELT
#undef HYRAX_PUBLIC

/// What a core declares; its name is left out.
template <class C>
[[nodiscard]] Description describe(C& core) {
  Description description;
  Describer<false> state;
  core.state(state);
  description.state = std::move(state.list());
  description.undeclared = std::move(state.undeclared_names());
  if constexpr (Has_inputs<C>) {
    Describer<false> inputs;
    core.inputs(inputs);
    description.inputs = std::move(inputs.list());
  }
  if constexpr (Has_parameters<C>) {
    Describer<false> parameters;
    core.parameters(parameters);
    description.parameters = std::move(parameters.list());
  }
  if constexpr (Has_outputs<C>) {
    Describer<true> outputs;
    core.outputs(outputs);
    description.outputs = std::move(outputs.list());
  }
  if constexpr (Has_actions<C>) {
    ActionDescriber actions;
    core.actions(actions);
    description.actions = std::move(actions.list);
  }
  if constexpr (Has_contacts<C>) {
    ContactConditions contacts;
    core.contacts(contacts);
    for (PropertyInfo& contact : contacts.list()) description.contacts.push_back(std::move(contact.name));
  }
  if constexpr (Has_properties<C>) {
    PropertyConditions properties;
    core.properties(properties);
    description.properties = std::move(properties.list());
  }
  return description;
}

/// Passes over a list with the visitor that `make_visitor` makes of its values.
template <class Core>
void visit(Core& core, SettableList list, const Description& description, const auto& make_visitor) {
  if (list == SettableList::state) {
    auto visitor = make_visitor(description.state);
    core.state(visitor);
    visitor.finish();
  } else if (list == SettableList::inputs) {
    auto visitor = make_visitor(description.inputs);
    if constexpr (Has_inputs<Core>) core.inputs(visitor);
    visitor.finish();
  } else {
    auto visitor = make_visitor(description.parameters);
    if constexpr (Has_parameters<Core>) core.parameters(visitor);
    visitor.finish();
  }
}

/// 0 or 1 for each contact. REQUIRES: as many as the description has.
template <class Core>
void read_contacts(Core& core, std::span<std::uint8_t> flags) {
  ContactConditions visitor(flags);
  if constexpr (Has_contacts<Core>) core.contacts(visitor);
  visitor.finish();
}

}  // namespace hyrax::see

namespace hyrax {

/// A body of the class Core.
template <class Core>
class DescribedBodyOf final : public DescribedBody {
 public:
  DescribedBodyOf() = default;

  [[nodiscard]] static const Description& description() {
    // It may be too large for the stack.
    static const Description description = see::describe(*std::make_unique<Core>());
    return description;
  }

  [[nodiscard]] std::unique_ptr<DescribedBody> copy() const override {
    return std::unique_ptr<DescribedBody>(new DescribedBodyOf(core_));
  }
  void step(double dt_s) override { static_cast<void>(core_.step(dt_s)); }
  void play(const std::function<void()>& after_step, MadeRows& rows) override {
    if (after_step) return play(core_, rows, after_step);
    if constexpr (std::is_trivially_copyable_v<Core> && std::is_copy_assignable_v<Core> &&
                  sizeof(Core) <= kPlayedByCopyMax_bytes) {
      Core core = core_;  // Which nothing else can change: it can stay in registers.
      play(core, rows, [] {});
      core_ = core;
    } else {
      play(core_, rows, [] {});
    }
  }
  void add_row(bool has_contacts, MadeRows& rows) override { add_row(core_, has_contacts, rows); }
  void read(SettableList list, std::span<Word> words) override {
    see::visit(core_, list, description_,
               [&](const ValueList& values) { return see::Reader<false>(values, words); });
  }
  void set(SettableList list, std::span<const std::optional<Word>> words) override {
    see::visit(core_, list, description_,
               [&](const ValueList& values) { return see::Setter(values, words); });
  }
  void act(std::size_t action, std::span<const Word> arguments) override {
    see::ActionCaller visitor(action, arguments);
    if constexpr (see::Has_actions<Core>) core_.actions(visitor);
    visitor.finish();
  }
  [[nodiscard]] Description describe() const override { return see::describe(core_); }
  void contacts(std::span<std::uint8_t> flags) const override { see::read_contacts(core_, flags); }

 private:
  static constexpr std::size_t kPlayedByCopyMax_bytes = 4096;

  explicit DescribedBodyOf(const Core& core) : core_(core) {}

  template <class T>
  static std::span<T> row_of(std::vector<T>& list, std::size_t width, std::size_t row) {
    return std::span(list).subspan(row * width, width);
  }
  void play(Core& core, MadeRows& rows, const auto& after_step) const {
    for (const double dt_s : rows.dt_s) {
      static_cast<void>(core.step(dt_s));
      after_step();
      add_row(core, true, rows);
    }
  }
  void add_row(Core& core, bool has_contacts, MadeRows& rows) const {
    const std::span<Word> words = row_of(rows.words, 1 + description_.state.values.size(), rows.count);
    words.front() = std::bit_cast<Word>(rows.dt_s[rows.count]);
    see::Reader<false> state(description_.state, words.subspan(1));
    core.state(state);
    state.finish();
    rows.all_are_finite &= state.all_are_finite();
    if constexpr (see::Has_outputs<Core>) {
      see::Reader<true> visitor(description_.outputs,
                                row_of(rows.outputs, description_.outputs.values.size(), rows.count));
      core.outputs(visitor);
      visitor.finish();
    }
    if constexpr (see::Has_contacts<Core>) {
      const std::span<std::uint8_t> flags = row_of(rows.contacts, description_.contacts.size(), rows.count);
      if (has_contacts)
        see::read_contacts(core, flags);
      else
        std::fill(flags.begin(), flags.end(), std::uint8_t{0});
    }
    if constexpr (see::Has_properties<Core>) {
      see::PropertyConditions visitor(row_of(rows.properties, description_.properties.size(), rows.count));
      core.properties(visitor);
      visitor.finish();
    }
    ++rows.count;
  }

  const Description& description_ = description();
  mutable Core core_ = Core();  // Its lists need not be const.
};

/// A core of the class Core. ERRORS: what its constructor, getters and conditions throw.
template <class Core>
[[nodiscard]] DescribedCore described_core_of(std::string_view name, const CoreRecord& record) {
  DescribedCore core;
  if constexpr (see::is_core<Core>()) {
    core.description = DescribedBodyOf<Core>::description();
    core.description.core = name;
    core.record = record;
    core.make = []() -> std::unique_ptr<DescribedBody> { return std::make_unique<DescribedBodyOf<Core>>(); };
  }
  return core;
}

}  // namespace hyrax
