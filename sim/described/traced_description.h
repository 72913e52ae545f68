// A core that describes itself, compiled with recording numbers in place of `double`, `float`, `int` and
// `bool`: what is asked of it when its step is traced (sim/trace/host).
#pragma once

#include <new>

#include "sim/described/see_forms.h"
#include "sim/trace/host/described_explorer.h"

namespace hyrax::see {

template <NumberKind kKind>
inline constexpr bool kIsRecording<trace::Number<kKind>> = true;
template <>
inline constexpr bool kIsRecording<trace::Truth> = true;

template <class V>
constexpr NumberKind traced_kind() {
  if constexpr (std::is_same_v<V, trace::Truth>)
    return NumberKind::whole;
  else
    return V::kNumberKind;
}

/// Values and contacts.
class TracedValues : public SeeValues<TracedValues, false> {
 public:
  explicit TracedValues(trace::DescribedPass& pass) : pass_(pass) {}

  void enter(auto part) { pass_.enter(part); }
  void leave() { pass_.leave(); }
  void enter_range(std::size_t /*length*/) {}
  void undeclared(std::string_view name) { pass_.refuse(name, " is not declared"); }

  template <class V, class Get, class Set, class Note>
  void value(const Get& get, const Set& set, const Note& note) {
    if constexpr (kIsRecording<V>) {
      if (pass_.is_setting()) {
        V given;
        given.expression = pass_.given(traced_kind<V>());
        set(given);
        pass_.end_set(0);
      } else {
        const V value = get();
        pass_.read(value.expression == trace::kConstant
                       ? trace::record_constant(traced_kind<V>(), value.value)
                       : value.expression);
      }
    } else {
      const auto [low, high] = cases_of<V>(note);
      if (pass_.is_setting()) {
        set(static_cast<V>(pass_.given(low, high)));
        pass_.end_set(sizeof(V));
      } else {
        pass_.read(static_cast<std::int64_t>(get()), low, high);
      }
    }
  }

 private:
  // None of a value that has no limits.
  template <class V, class Note>
  static std::array<std::int64_t, 2> cases_of([[maybe_unused]] const Note& note) {
    if constexpr (std::is_same_v<V, bool>)
      return {0, 1};
    else if constexpr (std::is_same_v<Note, Names>)
      return {0, static_cast<std::int64_t>(note.names.size()) - 1};
    else if constexpr (std::is_floating_point_v<V> || std::is_same_v<Note, NoNote>)
      return {0, -1};
    else
      return {static_cast<std::int64_t>(static_cast<V>(note.low)),
              static_cast<std::int64_t>(static_cast<V>(note.high))};
  }

  trace::DescribedPass& pass_;
};

struct TracedContacts {
  trace::DescribedPass& pass;
  template <class T>
  void operator()(std::string_view name, T&& condition) {
    pass.add_contact(name, static_cast<bool>(condition));
  }
};

class TracedActions : public SeeActions<TracedActions> {
 public:
  explicit TracedActions(trace::DescribedPass& pass) : pass_(pass) {}

  template <class Arguments, class F>
  void action(std::string_view name, F& act, std::span<const NameText> names) {
    std::array<std::string_view, std::tuple_size_v<Arguments>> texts;
    for (std::size_t place = 0; place < texts.size(); ++place) texts[place] = names[place].text;
    if (!pass_.wants_action(name, texts)) return;
    Arguments arguments;
    std::size_t place = 0;
    std::apply([&](auto&... each) { (give(each, texts[place++]), ...); }, arguments);
    static_cast<void>(std::apply(act, arguments));
  }

 private:
  template <class V>
  void give(V& value, std::string_view name) const {
    if constexpr (kIsRecording<V>)
      value.expression = pass_.argument(traced_kind<V>(), name);
    else if constexpr (std::is_same_v<V, bool>)
      value = trace::decide(Relation::equal, pass_.argument(NumberKind::whole, name),
                            trace::record_constant(NumberKind::whole, 1.0));
    else
      pass_.refuse(name, ": an argument that is no double, float, int or bool");
  }

  trace::DescribedPass& pass_;
};

// Whether its lists of what is only read cannot change it.
template <class Core>
constexpr bool reads_alone() {
  struct AnyList {};
  constexpr auto kIsConst = [](auto call) {
    return !std::is_invocable_v<decltype(call), Core&> || std::is_invocable_v<decltype(call), const Core&>;
  };
  return kIsConst([](auto& core) -> decltype(core.contacts(std::declval<AnyList&>())) {}) &&
         kIsConst([](auto& core) -> decltype(core.outputs(std::declval<AnyList&>())) {}) &&
         kIsConst([](auto& core) -> decltype(core.properties(std::declval<AnyList&>())) {});
}

template <class Core>
trace::DescribedCalls traced_calls_of() {
  return {.size_bytes = sizeof(Core),
          .align_bytes = alignof(Core),
          .is_trivially_copyable = std::is_trivially_copyable_v<Core>,
          .reads_alone = reads_alone<Core>(),
          .construct = [](void* body) { new (body) Core(); },
          .values =
              [](void* body, trace::DescribedPass& pass) {
                Core& core = *static_cast<Core*>(body);
                TracedValues see(pass);
                if constexpr (requires { core.parameters(see); }) core.parameters(see);
                pass.end_parameters();
                if constexpr (requires { core.inputs(see); }) core.inputs(see);
                core.state(see);
              },
          .contacts =
              [](void* body, trace::DescribedPass& pass) {
                TracedContacts see{pass};
                if constexpr (requires(Core & core) { core.contacts(see); })
                  static_cast<Core*>(body)->contacts(see);
              },
          .actions =
              [](void* body, trace::DescribedPass& pass) {
                TracedActions see(pass);
                if constexpr (requires(Core & core) { core.actions(see); })
                  static_cast<Core*>(body)->actions(see);
              },
          .step = [](void* body,
                     const trace::Real& dt_s) { static_cast<void>(static_cast<Core*>(body)->step(dt_s)); }};
}

}  // namespace hyrax::see
