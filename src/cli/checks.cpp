#include "cli/checks.h"

#include "base/text.h"

#include <cmath>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

CLI::Validator check(bool (*holds)(double), const char* expected) {
  const auto problem = [=](const std::string& text) -> std::string {
    const auto number = to_number(text);
    if (number && std::isfinite(*number) && holds(*number)) return "";
    return fmt::format("expected {}, not '{}'", expected, text);
  };
  return {problem, ""};
}

}  // namespace

CLI::Validator not_empty(const std::string& what) {
  return {[=](const std::string& text) { return text.empty() ? "needs " + what : ""; }, ""};
}

CLI::Validator any_number() {
  return check([](double) { return true; }, "a number");
}

CLI::Validator above_zero() {
  return check([](double number) { return number > 0; }, "a number above 0");
}

CLI::Validator zero_or_more() {
  return check([](double number) { return number >= 0; }, "0 or more");
}

}  // namespace orbs::cli
