#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace orbs {

/// Exit status after an interrupt: 128 + SIGINT, as shells count.
constexpr int kInterrupted = 130;

/// The user gave bad input: a file, a key, an option. A bug of ours is an assert, never an InputError.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& what) : std::runtime_error(what), text_(what) {}

  /// Adds one "while ..." line. Each layer that knows more than the layer below calls it.
  InputError& note(const std::string& line) {
    text_ += "\n  while " + line;
    return *this;
  }
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::string text_;
};

/// The disk refuses what we write. No other input would help, so callers stop instead of trying the next.
class WriteError : public InputError {
 public:
  using InputError::InputError;
};

/// Runs f. An InputError that passes through gains a "while <doing>" line.
template <typename F>
decltype(auto) with_note(const std::string& doing, F&& f) {
  try {
    return std::forward<F>(f)();
  } catch (InputError& e) {
    e.note(doing);
    throw;
  }
}

}  // namespace orbs
