#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace orbs {

/// Exit status after an interrupt: 128 + SIGINT, as shells count.
constexpr int kInterrupted = 130;

/// Bad input from the user's side: a file, a key, an option. Never a bug of ours.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& what) : std::runtime_error(what), text_(what) {}

  /// Adds one "while ..." line; called by each layer that knows more than the layer below.
  InputError& note(const std::string& line) {
    text_ += "\n  while " + line;
    return *this;
  }
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::string text_;
};

/// The disk refuses what we write: the surroundings, and nobody's input, so nothing else is worth trying.
class WriteError : public InputError {
 public:
  using InputError::InputError;
};

/// Runs f; an InputError that passes through gains a "while <doing>" line.
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
