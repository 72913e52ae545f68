// The forms of see(NAME, ...) in the lists of a core's header, for any visitor.
//
// It is compiled a second time with every core, in which numbers record what is done to them: it includes
// little.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace hyrax::see {

template <class T, class... Types>
inline constexpr bool kIsOneOf = (std::is_same_v<T, Types> || ...);
/// A number that records what is done to it, in place of a double, float, int or bool.
template <class T>
inline constexpr bool kIsRecording = false;
template <class T>
concept Value = kIsRecording<T> ||
    ((std::is_arithmetic_v<T> || std::is_enum_v<T>)&&sizeof(T) <= sizeof(std::uint64_t) &&
     !kIsOneOf<T, long double, char, wchar_t, char8_t, char16_t, char32_t>);
template <class T>
concept Getter = std::is_invocable_v<T&>;
template <class T>
concept Range = requires(T& range) {
  std::begin(range);
  std::end(range);
};
template <class T>
concept Text = std::is_convertible_v<const T&, std::string_view>;

// What is in a braced list has to convert to these types.
// NOLINTBEGIN(google-explicit-constructor)

/// A name in a list {"calm", "wild"}; no number converts to it, 0 neither.
struct NameText {
  template <class T>
  requires std::is_same_v<T, const char*>
  constexpr NameText(T literal) : text(literal) {}
  const char* text;
};

/// A limit of an enum: an enumerator, or its number.
template <class Enum>
struct EnumLimit {
  constexpr EnumLimit(Enum limit) : value(limit) {}
  constexpr EnumLimit(std::underlying_type_t<Enum> limit)  // A text converts to bool.
      requires(!std::is_same_v<std::underlying_type_t<Enum>, bool>)
      : value(static_cast<Enum>(limit)) {}
  constexpr operator Enum() const { return value; }
  Enum value;
};

/// A limit of a bool: no text converts to it.
struct BoolLimit {
  template <class T>
  requires std::is_same_v<T, bool>
  constexpr BoolLimit(T limit) : value(limit) {}
  constexpr operator bool() const { return value; }
  bool value;
};

/// A limit of what has none, as a struct: any number, so that what is refused is the struct.
struct AnyLimit {
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  constexpr AnyLimit(T /*limit*/) {}
};
// NOLINTEND(google-explicit-constructor)

/// The values of what an author passes: of a member, a getter, a range. Others have none.
template <class T>
struct ValueOf {
  using Limit = AnyLimit;
};
template <Value T>
struct ValueOf<T> {
  using Limit = std::conditional_t<std::is_floating_point_v<T>, double, T>;  // {0.1, 0.9} of a float.
};
template <Value T>
requires std::is_enum_v<T>
struct ValueOf<T> {
  using Limit = EnumLimit<T>;
};
template <>
struct ValueOf<bool> {
  using Limit = BoolLimit;
};
template <Getter T>
struct ValueOf<T> : ValueOf<std::remove_cvref_t<std::invoke_result_t<T&>>> {};
template <Range T>
struct ValueOf<T>
    : ValueOf<typename std::iterator_traits<decltype(std::begin(std::declval<T&>()))>::value_type> {};
template <class T>
using LimitOf = typename ValueOf<std::remove_cvref_t<T>>::Limit;

/// The last argument of see: none, {LOW, HIGH}, or names.
struct NoNote {};
template <class Limit>
struct Limits {
  Limit low;
  Limit high;
};
struct Names {
  std::span<const NameText> names;
};

template <class...>
inline constexpr bool kNever = false;

/// Whether what see() is given begins with a name, and has more.
template <class...>
inline constexpr bool kIsNamed = false;
template <class Name, class Next, class... More>
inline constexpr bool kIsNamed<Name, Next, More...> = std::is_convertible_v<Name, std::string_view>;

/// The forms of see(NAME, ...) in lists of values. A Visitor has enter(NAME or place), leave(),
/// enter_range(length), value<T>(getter, setter, note).
/// @param kIsOutput constants and temporaries are taken, too.
template <class Visitor, bool kIsOutput>
class SeeValues {
 public:
  SeeValues() = default;
  SeeValues(const SeeValues&) = delete;
  SeeValues& operator=(const SeeValues&) = delete;

  template <class T>
  void operator()(std::string_view name, T&& at) {
    member(name, std::forward<T>(at), NoNote());
  }
  template <class T>
  void operator()(std::string_view name, T&& at, const LimitOf<T> (&limits)[2]) {
    member(name, std::forward<T>(at), Limits<LimitOf<T>>{limits[0], limits[1]});
  }
  template <class T>
  void operator()(std::string_view /*name*/, T&& /*at*/, const LimitOf<T> (&/*limits*/)[1]) {
    static_assert(kNever<T>, "hyrax: limits are two, {LOW, HIGH}");
  }
  template <class T, std::size_t N>
  requires(N > 2) void operator()(std::string_view /*name*/, T&& /*at*/, const LimitOf<T> (&/*limits*/)[N]) {
    static_assert(kNever<T>, "hyrax: limits are two, {LOW, HIGH}");
  }
  template <class T, std::size_t N>
  void operator()(std::string_view name, T&& at, const NameText (&names)[N]) {
    member(name, std::forward<T>(at), Names{names});
  }

  template <Getter Get, class Set>
  void operator()(std::string_view name, Get&& get, Set&& set) {
    property(name, get, set, NoNote());
  }
  template <Getter Get, class Set>
  void operator()(std::string_view name, Get&& get, Set&& set, const LimitOf<Get> (&limits)[2]) {
    property(name, get, set, Limits<LimitOf<Get>>{limits[0], limits[1]});
  }
  template <Getter Get, class Set>
  void operator()(std::string_view /*name*/, Get&& /*get*/, Set&& /*set*/,
                  const LimitOf<Get> (&/*limits*/)[1]) {
    static_assert(kNever<Get>, "hyrax: limits are two, {LOW, HIGH}");
  }
  template <Getter Get, class Set, std::size_t N>
  requires(N > 2) void operator()(std::string_view /*name*/, Get&& /*get*/, Set&& /*set*/,
                                  const LimitOf<Get> (&/*limits*/)[N]) {
    static_assert(kNever<Get>, "hyrax: limits are two, {LOW, HIGH}");
  }
  template <Getter Get, class Set, std::size_t N>
  void operator()(std::string_view name, Get&& get, Set&& set, const NameText (&names)[N]) {
    property(name, get, set, Names{names});
  }

  /// An object, or a range of them, with the list of each.
  template <class T, class Parts>
  requires(!Getter<std::remove_reference_t<T>>) void operator()(std::string_view name, T&& object,
                                                                Parts&& parts) {
    static_assert(
        std::is_class_v<std::remove_cvref_t<Parts>>,
        "hyrax: after an object give a function of it, after a value {LOW, HIGH} or {\"name\", ...}");
    visitor().enter(name);
    objects(object, parts);
    visitor().leave();
  }

  template <class... Given>
  requires(!kIsNamed<Given...>) void operator()(Given&&... /*given*/) {
    static_assert(kNever<Given...>, "hyrax: a value is see(NAME, VALUE)");
  }

  void undeclared(std::string_view /*name*/) {}

 private:
  Visitor& visitor() { return static_cast<Visitor&>(*this); }

  template <class T, class Note>
  void member(std::string_view name, T&& at, const Note& note) {
    using Plain = std::remove_reference_t<T>;
    if constexpr (Getter<Plain>) {
      static_assert(kNever<T>,
                    "hyrax: a getter needs a setter, see(NAME, GETTER, SETTER); an output is a value");
    } else if constexpr (!std::is_lvalue_reference_v<T> && !kIsOutput) {
      static_assert(kNever<T>,
                    "hyrax: a temporary cannot be set; give a member, or see(NAME, GETTER, SETTER)");
    } else {
      visitor().enter(name);
      element(at, note);
      visitor().leave();
    }
  }

  template <class Get, class Set, class Note>
  void property(std::string_view name, Get& get, Set& set, const Note& note) {
    using V = std::remove_cvref_t<std::invoke_result_t<Get&>>;
    if constexpr (!Value<V>) {
      static_assert(kNever<V>, "hyrax: a getter gives a double, float, bool, integer or enum");
    } else if constexpr (!std::is_invocable_v<Set&, V>) {
      static_assert(kNever<V>, "hyrax: a setter takes what its getter gives");
    } else {
      visitor().enter(name);
      value<V>([&]() -> V { return get(); }, [&](V given) { static_cast<void>(set(given)); }, note);
      visitor().leave();
    }
  }

  template <class T, class Note>
  void element(T& at, const Note& note) {
    using V = std::remove_cv_t<T>;
    if constexpr (Text<V>) {
      static_assert(kNever<T>, "hyrax: a string is no value; declare a number or an enum with names");
    } else if constexpr (std::is_const_v<T> && !kIsOutput) {
      static_assert(kNever<T>,
                    "hyrax: what is const cannot be set: a const member need not be declared, and a list of "
                    "values that can be set is no const function");
    } else if constexpr (Value<V>) {
      value<V>([&]() -> V { return at; },
               [&]([[maybe_unused]] V given) {
                 if constexpr (!std::is_const_v<T>) at = given;
               },
               note);
    } else if constexpr (requires(V & object, Visitor & see) { object.state(see); }) {
      static_assert(std::is_same_v<Note, NoNote>, "hyrax: limits and names are of values, not of a struct");
      const_cast<V&>(at).state(visitor());  // It may not be const; of an output nothing is set.
    } else if constexpr (Range<T>) {
      each(at, [&](auto&& part) {
        using Part = decltype(part);
        if constexpr (std::is_lvalue_reference_v<Part> &&
                      std::is_const_v<T> >= std::is_const_v<std::remove_reference_t<Part>>) {
          element(part, note);
        } else if constexpr (std::is_same_v<LimitOf<V>, BoolLimit>) {  // Of std::vector<bool>.
          value<bool>([&]() -> bool { return part; },
                      [&]([[maybe_unused]] bool given) {
                        if constexpr (std::is_assignable_v<Part, bool>) std::forward<Part>(part) = given;
                      },
                      note);
        } else {
          static_assert(kIsOutput || kNever<Part>,
                        "hyrax: the elements of a range are temporaries or const, and cannot be set");
          element(part, note);
        }
      });
    } else {
      static_assert(
          kNever<T>,
          "hyrax: a value is a double, float, bool, integer or enum, or a range or struct of these (no "
          "optional, pointer or char); a struct has template <class See> void state(See&& see), or is "
          "passed as see(NAME, OBJECT, [](auto& part, T& object) {...})");
    }
  }

  template <class T, class Parts>
  void objects(T& object, Parts& parts) {
    if constexpr (Range<T>)
      each(object, [&](auto&& part) { objects(part, parts); });
    else
      parts(visitor(), object);
  }

  template <class T, class Do>
  void each(T& range, const Do& action) {
    std::size_t length = 0, place = 0;
    for ([[maybe_unused]] auto&& part : range) ++length;
    visitor().enter_range(length);
    for (auto&& part : range) {
      visitor().enter(place++);
      action(std::forward<decltype(part)>(part));
      visitor().leave();
    }
  }

  template <class V, class Get, class Set, class Note>
  void value(const Get& get, const Set& set, const Note& note) {
    static_assert(!std::is_same_v<Note, Names> || std::is_enum_v<V> ||
                      (std::is_integral_v<V> && !std::is_same_v<V, bool>),
                  "hyrax: names are of the values of an enum or integer");
    visitor().template value<V>(get, set, note);
  }
};

/// The arguments of a function; of one whose arguments have no types of their own there are none.
template <class... Argument>
struct ArgumentList {
  using Arguments = std::tuple<std::remove_cvref_t<Argument>...>;
  template <class A>  // What it could write to is nobody's.
  static constexpr bool kIsWritten =
      std::is_lvalue_reference_v<A> && !std::is_const_v<std::remove_reference_t<A>>;
  static constexpr bool kAreValues = ((Value<std::remove_cvref_t<Argument>> && !kIsWritten<Argument>)&&...);
};
template <class F>
struct SignatureOf {};
template <class F>
requires requires { &F::operator(); }
struct SignatureOf<F> : SignatureOf<decltype(&F::operator())> {};
template <class Result, class... A>
struct SignatureOf<Result (*)(A...)> : ArgumentList<A...> {};
template <class Result, class... A>
struct SignatureOf<Result (*)(A...) noexcept> : ArgumentList<A...> {};
template <class Result, class T, class... A>
struct SignatureOf<Result (T::*)(A...)> : ArgumentList<A...> {};
template <class Result, class T, class... A>
struct SignatureOf<Result (T::*)(A...) const> : ArgumentList<A...> {};
template <class Result, class T, class... A>
struct SignatureOf<Result (T::*)(A...) noexcept> : ArgumentList<A...> {};
template <class Result, class T, class... A>
struct SignatureOf<Result (T::*)(A...) const noexcept> : ArgumentList<A...> {};

/// The forms of see(NAME, ...) in the list of actions. A Visitor has action<Arguments>(name, function,
/// names).
template <class Visitor>
class SeeActions {
 public:
  SeeActions() = default;
  SeeActions(const SeeActions&) = delete;
  SeeActions& operator=(const SeeActions&) = delete;

  template <class F>
  void operator()(std::string_view name, F&& act) {
    pass<0>(name, act, {});
  }
  template <class F, std::size_t N>
  void operator()(std::string_view name, F&& act, const NameText (&names)[N]) {
    pass<N>(name, act, names);
  }
  template <class... Given>
  requires(!kIsNamed<Given...>) void operator()(Given&&... /*given*/) {
    static_assert(kNever<Given...>,
                  "hyrax: an action is see(NAME, FUNCTION), or see(NAME, FUNCTION, {\"name\", ...})");
  }

 private:
  template <std::size_t N, class F>
  void pass(std::string_view name, F& act, std::span<const NameText> names) {
    using Signature = SignatureOf<std::decay_t<F>>;
    if constexpr (!requires { typename Signature::Arguments; }) {
      static_assert(kNever<F>, "hyrax: an action is a function whose arguments have types, not auto");
    } else if constexpr (std::tuple_size_v<typename Signature::Arguments> != N) {
      static_assert(kNever<F>,
                    "hyrax: an action has a name for each argument: see(NAME, FUNCTION, {\"vx_px_per_s\"})");
    } else if constexpr (!Signature::kAreValues) {
      static_assert(kNever<F>,
                    "hyrax: an argument of an action is a double, float, bool, integer or enum, by value");
    } else {
      static_cast<Visitor&>(*this).template action<typename Signature::Arguments>(name, act, names);
    }
  }
};

}  // namespace hyrax::see
