#include "scene/shapes/expression.h"

#include "base/error.h"
#include "base/nth.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

constexpr std::size_t kMostCharacters = 10'000;
constexpr std::size_t kMostSteps = 1000;
constexpr int kDeepest = 100;  // brackets within brackets; each takes some 500 bytes of the stack
constexpr int kHighestPower = 64;

struct Function {
  std::string_view name;
  Operation operation;
  int arguments;
};
// pow is written as a function and is a power like those of ^.
constexpr std::array kFunctions{Function{"sin", Operation::Sin, 1},      Function{"cos", Operation::Cos, 1},
                                Function{"exp", Operation::Exp, 1},      Function{"log", Operation::Log, 1},
                                Function{"sqrt", Operation::Sqrt, 1},    Function{"abs", Operation::Abs, 1},
                                Function{"min", Operation::Min, 2},      Function{"max", Operation::Max, 2},
                                Function{"pow", Operation::RealPower, 2}};

// Recursive descent; each function reads one rank of the grammar and returns the place of its step.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  std::vector<Step> read() {
    const int value = sum();
    skip_space();
    if (at_ < text_.size()) fail(fmt::format("expected an operator or the end, found '{}'", text_[at_]));
    return used_steps(value);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(fmt::format("column {} of the formula: {}", at_ + 1, problem));
  }

  void skip_space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }

  bool take(char wanted) {
    skip_space();
    if (at_ >= text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }

  void require(char wanted) {
    if (take(wanted)) return;
    fail(at_ < text_.size() ? fmt::format("expected '{}', found '{}'", wanted, text_[at_])
                            : fmt::format("expected '{}', found the end", wanted));
  }

  std::optional<double> constant(int step) const {
    const Step& s = nth(steps_, step);
    return s.operation == Operation::Constant ? std::optional(s.number) : std::nullopt;
  }

  int add(Step step) {
    const auto known = std::find(steps_.begin(), steps_.end(), step);
    if (known != steps_.end()) return static_cast<int>(known - steps_.begin());
    if (steps_.size() == kMostSteps) fail(fmt::format("more than {} steps", kMostSteps));
    steps_.push_back(step);
    return static_cast<int>(steps_.size()) - 1;
  }

  // Steps of constants are computed here, in double.
  int add_folded(const Step& step) {
    const auto a = constant(step.a);
    const auto b = step.b < 0 ? std::optional(0.0) : constant(step.b);
    if (!a || !b) return add(step);
    const double value = apply(step, *a, *b);
    if (!std::isfinite(value)) fail("this constant has no finite value");
    return add({Operation::Constant, -1, -1, value});
  }

  // Without the parts of folded constants; the value becomes the last step, as it takes earlier ones only.
  std::vector<Step> used_steps(int value) const {
    std::vector<int> place(steps_.size(), -1);
    nth(place, value) = 0;
    for (std::size_t i = steps_.size(); i-- > 0;)
      for (const int argument : {steps_[i].a, steps_[i].b})
        if (place[i] == 0 && argument >= 0) nth(place, argument) = 0;
    std::vector<Step> used;
    const auto moved = [&](int step) { return step < 0 ? -1 : nth(place, step); };
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      if (place[i] < 0) continue;
      place[i] = static_cast<int>(used.size());
      used.push_back({steps_[i].operation, moved(steps_[i].a), moved(steps_[i].b), steps_[i].number});
    }
    return used;
  }

  int sum() {
    if (++depth_ > kDeepest) fail(fmt::format("more than {} brackets within each other", kDeepest));
    int left = product();
    while (true) {
      if (take('+'))
        left = add_folded({Operation::Add, left, product()});
      else if (take('-'))
        left = add_folded({Operation::Subtract, left, product()});
      else
        break;
    }
    --depth_;
    return left;
  }

  int product() {
    int left = factor();
    while (true) {
      if (take('*')) {
        const int right = factor();
        // x * x as a square: as a product its enclosure would not know that both are the same x.
        left = left == right ? power(left, 2) : add_folded({Operation::Multiply, left, right});
      } else if (take('/')) {
        left = add_folded({Operation::Divide, left, factor()});
      } else {
        return left;
      }
    }
  }

  // -x^2 is -(x^2).
  int factor() {
    bool is_negative = false;
    while (true) {
      if (take('-'))
        is_negative = !is_negative;
      else if (!take('+'))
        break;
    }
    const int value = power_of(primary());
    return is_negative ? add_folded({Operation::Negate, value}) : value;
  }

  // a^b^c is a^(b^c).
  int power_of(int base) {
    if (!take('^')) return base;
    if (++depth_ > kDeepest) fail(fmt::format("more than {} powers within each other", kDeepest));
    const int result = power_with_exponent(base, factor());
    --depth_;
    return result;
  }

  int power_with_exponent(int base, int exponent) {
    const auto number = constant(exponent);
    if (!number) fail("the exponent must be a constant; write exp(b * log(a)) for a^b");
    return power(base, *number);
  }

  int power(int base, double exponent) {
    if (exponent == 1) return base;
    const bool is_whole = exponent == std::round(exponent) && std::abs(exponent) <= kHighestPower;
    return add_folded({is_whole ? Operation::IntegerPower : Operation::RealPower, base, -1, exponent});
  }

  int primary() {
    skip_space();
    if (at_ >= text_.size()) fail("expected a number, x, y, z, a function or '(', found the end");
    if (take('(')) {
      const int inner = sum();
      require(')');
      return inner;
    }
    const auto c = static_cast<unsigned char>(text_[at_]);
    if (std::isdigit(c) != 0 || c == '.') return number();
    if (std::isalpha(c) != 0) return name();
    fail(fmt::format("expected a number, x, y, z, a function or '(', found '{}'", text_[at_]));
  }

  int number() {
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) fail("expected a number");
    at_ = static_cast<std::size_t>(end - text_.data());
    return add({Operation::Constant, -1, -1, value});
  }

  int name() {
    const std::size_t first = at_;
    std::size_t end = at_;
    while (end < text_.size() && std::isalnum(static_cast<unsigned char>(text_[end])) != 0) ++end;
    const auto word = text_.substr(first, end - first);
    for (const auto& [letter, operation] :
         {std::pair{"x", Operation::X}, std::pair{"y", Operation::Y}, std::pair{"z", Operation::Z}})
      if (word == letter) {
        at_ = end;
        return add({operation});
      }
    if (word == "pi") {
      at_ = end;
      return add({Operation::Constant, -1, -1, std::numbers::pi});
    }
    for (const auto& function : kFunctions)
      if (word == function.name) {
        at_ = end;
        return call(function);
      }
    std::set<std::string> known{"x", "y", "z", "pi"};
    for (const auto& function : kFunctions) known.emplace(function.name);
    fail(fmt::format("there is no '{}'{}", word, closest(std::string(word), known)));
  }

  int call(const Function& function) {
    require('(');
    const int a = sum();
    int b = -1;
    if (function.arguments == 2) {
      require(',');
      b = sum();
    }
    require(')');
    if (function.operation == Operation::RealPower) return power_with_exponent(a, b);
    return add_folded({function.operation, a, b});
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::vector<Step> steps_;
};

}  // namespace

Expression parse_expression(const std::string& text) {
  if (text.size() > kMostCharacters)
    throw InputError(
        fmt::format("the formula has {} characters; at most {} are read", text.size(), kMostCharacters));
  return {text, Parser(text).read()};
}

}  // namespace orbs::scene
