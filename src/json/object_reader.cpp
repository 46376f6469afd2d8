#include "json/object_reader.h"

#include "base/files.h"
#include "base/text.h"
#include "json/layers.h"
#include "json/locate.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace orbs::json {

namespace {

// JSON pointer escaping, RFC 6901 section 3.
std::string escaped(const std::string& key) {
  std::string out;
  for (const char c : key) out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return out;
}

}  // namespace

ObjectReader::ObjectReader(const Document& document) : ObjectReader(document, "", *document.root) {}

ObjectReader::ObjectReader(const Document& document, std::string pointer, const nlohmann::json& value)
    : document_(&document), pointer_(std::move(pointer)), value_(&value) {
  if (!value.is_object()) fail("", fmt::format("must be an object, is {}", value.type_name()));
}

std::string ObjectReader::pointer_to(const std::string& key) const {
  return key.empty() ? pointer_ : pointer_ + "/" + escaped(key);
}

void ObjectReader::fail_pointer(const std::string& pointer, const std::string& problem) const {
  const auto [document, place] = standing_of(*document_, pointer);
  const auto at = locate(document->text, place);
  throw InputError(fmt::format("{}:{}:{}: {}: {}\n{}", document->name, at.line, at.column,
                               place.empty() ? "/" : place, problem, excerpt(document->text, at)));
}

void ObjectReader::fail(const std::string& key, const std::string& problem) const {
  fail_pointer(pointer_to(key), problem);
}

void ObjectReader::fail_at(const std::string& key, std::size_t index, const std::string& problem) const {
  fail_pointer(fmt::format("{}/{}", pointer_to(key), index), problem);
}

std::string ObjectReader::place(const std::string& key) const {
  const auto [document, place] = standing_of(*document_, pointer_to(key));
  return fmt::format("{}:{}", document->name, document->index->locate(document->text, place).line);
}

bool ObjectReader::has(const std::string& key) {
  asked_.insert(key);
  return value_->contains(key);
}

const nlohmann::json& ObjectReader::required(const std::string& key) {
  asked_.insert(key);
  const auto found = value_->find(key);
  if (found == value_->end()) {
    std::set<std::string> not_asked;
    for (const auto& item : value_->items())
      if (!asked_.contains(item.key())) not_asked.insert(item.key());
    fail("", fmt::format("key '{}' is missing{}", key, closest(key, not_asked)));
  }
  return *found;
}

const nlohmann::json& ObjectReader::required_array(const std::string& key) {
  const auto& value = required(key);
  if (!value.is_array()) fail(key, fmt::format("must be an array, is {}", value.type_name()));
  return value;
}

double ObjectReader::number_of(const nlohmann::json& value, const std::string& where, Range range) const {
  if (!value.is_number()) fail_pointer(where, fmt::format("must be a number, is {}", value.type_name()));
  const double x = value.get<double>();
  if (x >= range.min && x <= range.max) return x;
  if (range.min == kPositive.min) fail_pointer(where, fmt::format("must be above 0, is {}", x));
  if (range.max == kNotNegative.max)
    fail_pointer(where, fmt::format("must be at least {}, is {}", range.min, x));
  fail_pointer(where, fmt::format("must lie in [{}, {}], is {}", range.min, range.max, x));
}

double ObjectReader::number(const std::string& key, Range range) {
  return number_of(required(key), pointer_to(key), range);
}

double ObjectReader::number_or(const std::string& key, double fallback, Range range) {
  return has(key) ? number(key, range) : fallback;
}

int ObjectReader::integer(const std::string& key, int min, int max) {
  const double x = number(key, {static_cast<double>(min), static_cast<double>(max)});
  if (x != std::floor(x)) fail(key, fmt::format("must be a whole number, is {}", x));
  return static_cast<int>(x);
}

int ObjectReader::integer_or(const std::string& key, int fallback, int min, int max) {
  return has(key) ? integer(key, min, max) : fallback;
}

bool ObjectReader::boolean_or(const std::string& key, bool fallback) {
  if (!has(key)) return fallback;
  const auto& value = required(key);
  if (!value.is_boolean()) fail(key, fmt::format("must be true or false, is {}", value.type_name()));
  return value.get<bool>();
}

std::string ObjectReader::text(const std::string& key) {
  const auto& value = required(key);
  if (!value.is_string()) fail(key, fmt::format("must be a string, is {}", value.type_name()));
  return value.get<std::string>();
}

namespace {

constexpr const char* kHoldsZero = "must not hold a zero byte: whoever takes it on would stop there";

bool holds_zero(const std::string& text) { return text.find('\0') != std::string::npos; }

}  // namespace

std::string ObjectReader::system_text(const std::string& key) {
  auto value = text(key);
  if (holds_zero(value)) fail(key, kHoldsZero);
  return value;
}

std::vector<std::string> ObjectReader::system_texts(const std::string& key) {
  auto values = texts(key);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (holds_zero(values[i])) fail_at(key, i, kHoldsZero);
  return values;
}

std::string ObjectReader::text_or(const std::string& key, const std::string& fallback) {
  return has(key) ? text(key) : fallback;
}

std::string ObjectReader::one_of(const std::string& key, std::initializer_list<std::string_view> allowed) {
  std::string value = text(key);
  if (std::find(allowed.begin(), allowed.end(), value) == allowed.end()) {
    const std::set<std::string> names(allowed.begin(), allowed.end());
    fail(key,
         fmt::format("'{}' is not one of: {}{}", value, fmt::join(allowed, ", "), closest(value, names)));
  }
  return value;
}

std::string ObjectReader::one_of_or(const std::string& key,
                                    const std::string& fallback,
                                    std::initializer_list<std::string_view> allowed) {
  return has(key) ? one_of(key, allowed) : fallback;
}

std::vector<double> ObjectReader::numbers(const std::string& key, std::size_t count, Range range) {
  const auto& array = required_array(key);
  if (count != 0 && array.size() != count)
    fail(key, fmt::format("must hold {} numbers, holds {}", count, array.size()));
  std::vector<double> out;
  out.reserve(array.size());
  for (const auto& element : array) {
    const bool plain =
        element.is_number() && element.get<double>() >= range.min && element.get<double>() <= range.max;
    if (!plain) number_of(element, fmt::format("{}/{}", pointer_to(key), out.size()), range);
    out.push_back(element.get<double>());
  }
  return out;
}

std::vector<std::vector<double>> ObjectReader::number_rows(const std::string& key,
                                                           std::size_t count,
                                                           Range range) {
  std::vector<std::vector<double>> rows;
  for (const auto& element : required_array(key)) {
    if (!element.is_array() || element.size() != count)
      fail_at(key, rows.size(), fmt::format("must be an array of {} numbers", count));
    auto& row = rows.emplace_back();
    for (const auto& number : element)
      row.push_back(
          number_of(number, fmt::format("{}/{}/{}", pointer_to(key), rows.size() - 1, row.size()), range));
  }
  return rows;
}

std::vector<std::string> ObjectReader::texts(const std::string& key) {
  std::vector<std::string> out;
  for (const auto& element : required_array(key)) {
    if (!element.is_string())
      fail_at(key, out.size(), fmt::format("must be a string, is {}", element.type_name()));
    out.push_back(element.get<std::string>());
  }
  return out;
}

Vec3d ObjectReader::vec3(const std::string& key, Range range) {
  const auto v = numbers(key, 3, range);
  return {v[0], v[1], v[2]};
}

Vec3d ObjectReader::vec3_or(const std::string& key, Vec3d fallback, Range range) {
  return has(key) ? vec3(key, range) : fallback;
}

ObjectReader ObjectReader::object(const std::string& key, const std::string& expected) {
  const auto& value = required(key);
  if (!value.is_object()) fail(key, fmt::format("must be {}, is {}", expected, value.type_name()));
  return {*document_, pointer_to(key), value};
}

std::vector<ObjectReader> ObjectReader::objects(const std::string& key) {
  const auto& array = required_array(key);
  std::vector<ObjectReader> out;
  for (std::size_t i = 0; i < array.size(); ++i)
    out.push_back(ObjectReader(*document_, fmt::format("{}/{}", pointer_to(key), i), array[i]));
  return out;
}

std::vector<ObjectReader> ObjectReader::objects_or_none(const std::string& key) {
  return has(key) ? objects(key) : std::vector<ObjectReader>{};
}

bool ObjectReader::holds_objects(const std::string& key) {
  const auto& array = required_array(key);
  return array.empty() || array.front().is_object();
}

bool ObjectReader::holds_text(const std::string& key) { return required(key).is_string(); }

bool ObjectReader::holds_array(const std::string& key) { return required(key).is_array(); }

bool ObjectReader::holds_number(const std::string& key) { return required(key).is_number(); }

std::vector<std::string> ObjectReader::keys() const {
  std::vector<std::string> out;
  for (const auto& item : value_->items()) out.push_back(item.key());
  return out;
}

void ObjectReader::check_written_whole(const std::string& key) {
  const auto& value = required(key);
  const auto problem = [](const nlohmann::json& number) {
    return fmt::format("must be a whole number written without a fraction, is {}", number.dump());
  };
  if (value.is_number() && !value.is_number_integer()) fail(key, problem(value));
  for (std::size_t i = 0; value.is_array() && i < value.size(); ++i)
    if (!value[i].is_number_integer()) fail_at(key, i, problem(value[i]));
}

void ObjectReader::finish() const {
  for (const auto& item : value_->items())
    if (!asked_.contains(item.key())) fail(item.key(), "unknown key" + closest(item.key(), asked_));
}

}  // namespace orbs::json
