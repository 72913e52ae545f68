// Memory that outlives its owner: a loop that makes the same buffers again and again takes no new pages.
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace hyrax {

/// Owns a value that an owner in this thread has given up, or a new one. It holds what it held then.
template <class Value>
class Reused {
 public:
  Reused() : value_(take()) {}
  Reused(Reused&&) noexcept = default;
  Reused& operator=(Reused other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~Reused() {
    if (value_) spare().push_back(std::move(value_));
  }

  [[nodiscard]] Value& operator*() { return *value_; }
  [[nodiscard]] const Value& operator*() const { return *value_; }
  [[nodiscard]] Value* operator->() { return value_.get(); }
  [[nodiscard]] const Value* operator->() const { return value_.get(); }

 private:
  using Values = std::vector<std::unique_ptr<Value>>;

  static Values& spare() {
#ifdef __wasm__  // Has one thread, and no way to end a variable of it.
    static Values values;
#elif defined(__MINGW32__)  // Frees a thread's variables before their ends: this one has none.
    thread_local Values& values = *new Values;
#else
    thread_local Values values;
#endif
    return values;
  }
  static std::unique_ptr<Value> take() {
    Values& values = spare();
    if (values.empty()) return std::make_unique<Value>();
    std::unique_ptr<Value> value = std::move(values.back());
    values.pop_back();
    return value;
  }

  std::unique_ptr<Value> value_;
};

}  // namespace hyrax
