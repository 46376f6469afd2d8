#include "json/writer.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

#include <nlohmann/json.hpp>

namespace orbs::json {

namespace {

template <typename Number>
std::string shortest(Number number) {
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  return {digits.data(), end};
}

}  // namespace

std::string json_string(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void Writer::line_break() {
  out_ += '\n';
  out_.append(2 * has_elements_.size(), ' ');
}

void Writer::before_value() {
  if (after_key_) {
    after_key_ = false;
    return;
  }
  if (has_elements_.empty()) return;
  if (has_elements_.back()) out_ += ",";
  has_elements_.back() = true;
  line_break();
}

Writer& Writer::begin_object() {
  before_value();
  out_ += "{";
  has_elements_.push_back(false);
  return *this;
}

Writer& Writer::end_object() {
  const bool had_elements = has_elements_.back();
  has_elements_.pop_back();
  if (had_elements) line_break();
  out_ += "}";
  return *this;
}

Writer& Writer::begin_array() {
  before_value();
  out_ += "[";
  has_elements_.push_back(false);
  return *this;
}

Writer& Writer::end_array() {
  const bool had_elements = has_elements_.back();
  has_elements_.pop_back();
  if (had_elements) line_break();
  out_ += "]";
  return *this;
}

Writer& Writer::key(std::string_view name) {
  before_value();
  out_ += json_string(name) + ": ";
  after_key_ = true;
  return *this;
}

Writer& Writer::value(double number) {
  if (!std::isfinite(number)) return null();
  before_value();
  out_ += shortest(number);
  return *this;
}

Writer& Writer::value(int number) { return value(static_cast<long long>(number)); }

Writer& Writer::value(long long number) {
  before_value();
  out_ += shortest(number);
  return *this;
}

Writer& Writer::value(unsigned long long number) {
  before_value();
  out_ += shortest(number);
  return *this;
}

Writer& Writer::value(bool flag) {
  before_value();
  out_ += flag ? "true" : "false";
  return *this;
}

Writer& Writer::value(std::string_view text) {
  before_value();
  out_ += json_string(text);
  return *this;
}

Writer& Writer::null() {
  before_value();
  out_ += "null";
  return *this;
}

Writer& Writer::numbers(std::span<const double> values) {
  before_value();
  out_ += "[";
  for (std::size_t i = 0; i < values.size(); ++i)
    out_ += (i == 0 ? "" : ", ") + (std::isfinite(values[i]) ? shortest(values[i]) : std::string("null"));
  out_ += "]";
  return *this;
}

Writer& Writer::value(Vec3d v) { return numbers(std::array{v.x, v.y, v.z}); }

Writer& Writer::value(const std::vector<std::string>& texts) {
  before_value();
  out_ += "[";
  for (std::size_t i = 0; i < texts.size(); ++i) out_ += (i == 0 ? "" : ", ") + json_string(texts[i]);
  out_ += "]";
  return *this;
}

std::string Writer::text() const {
  assert(has_elements_.empty());
  return out_ + "\n";
}

}  // namespace orbs::json
