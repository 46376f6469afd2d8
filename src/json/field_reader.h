#pragma once

#include "base/error.h"
#include "base/files_inside.h"
#include "base/text.h"
#include "json/fields.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace orbs::json {

/// Who wrote a file. A record may be of a newer program: members that are unknown are ignored, and null is a
/// number that JSON cannot hold. Settings are written by hand: unknown keys are refused, and texts hold no
/// zero byte, since they are handed on to the system.
enum class WrittenBy { Program, Hand };

/// The visitor of fields() that reads an object. A member that is not there keeps its value.
class FieldReader {
 public:
  explicit FieldReader(ObjectReader& in, WrittenBy author = WrittenBy::Program) : in_(in), author_(author) {}

  template <class T>
  void operator()(const std::string& key, T& value, const Field& field = {}) {
    if (in_.has(key)) get(key, value, field);
  }

  template <class T>
  void operator()(const std::string& key, std::optional<T>& value, const Field& field = {}) {
    // Of a program, null is a number that JSON cannot hold.
    const bool may_be_null =
        author_ == WrittenBy::Program && std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
    const bool is_there = in_.has(key) && (!may_be_null || in_.holds_number(key));
    if (is_there) get(key, value.emplace(), field);
  }

  template <class T>
  void required(const std::string& key, T& value, const Field& field = {}) {
    get(key, value, field);
  }

  // As FieldWriter writes it: null with "infinite" beside it is infinite, null alone is NaN.
  void maybe_infinite(const std::string& key, double& value) {
    if (in_.has(key) && in_.holds_number(key)) {
      value = in_.number(key);
    } else {
      value =
          is_infinite() ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
    }
  }

  void maybe_infinite(const std::string& key, std::optional<double>& value) {
    (*this)(key, value);
    if (is_infinite()) value = std::numeric_limits<double>::infinity();
  }

  // Folders of runs come from other machines: no path of theirs may lead merge, serve or report elsewhere.
  void inside_folder(const std::string& key, std::string& path) {
    if (!in_.has(key)) return;
    path = in_.system_text(key);
    if (!leads_inside(path))
      in_.fail(key,
               fmt::format("'{}' leads out of the folder of this file; expected a relative path without '..'",
                           clean_text(path)));
  }

  void rectangle(const std::string& key, std::vector<double>& corners) {
    if (in_.has(key)) corners = in_.numbers(key, 4);
  }

 private:
  static constexpr int kMostInteger = std::numeric_limits<int>::max();

  bool is_infinite() { return in_.boolean_or("infinite", false); }

  void get(const std::string& key, std::string& value, const Field&) {
    value = author_ == WrittenBy::Hand ? in_.system_text(key) : in_.text(key);
  }

  void get(const std::string& key, std::vector<std::string>& value, const Field&) {
    value = author_ == WrittenBy::Hand ? in_.system_texts(key) : in_.texts(key);
  }

  void get(const std::string& key, double& value, const Field& field) {
    if (!field.advice.empty() && in_.number(key) < field.range.min)
      in_.fail(key, fmt::format("must be at least {}, {}", field.range.min, field.advice));
    value = in_.number(key, field.range);
  }

  void get(const std::string& key, std::vector<double>& value, const Field& field) {
    value = in_.numbers(key, 0, field.range);
  }

  void get(const std::string& key, bool& value, const Field&) { value = in_.boolean_or(key, value); }

  void get(const std::string& key, int& value, const Field& field) {
    constexpr double kMost = kMostInteger;
    value = in_.integer(key, static_cast<int>(std::max(field.range.min, -kMost)),
                        static_cast<int>(std::min(field.range.max, kMost)));
  }

  void get(const std::string& key, std::size_t& value, const Field&) {
    constexpr double kLargestExact = 9007199254740992;  // 2^53: every integer up to it is a double
    const double number = in_.number(key, {0, kLargestExact});
    value = static_cast<std::size_t>(number);
    if (static_cast<double>(value) != number)
      in_.fail(key, fmt::format("must be a whole number, is {}", number));
  }

  // An element of a map, where null is a value of its own: no number.
  template <class T>
  void get(const std::string& key, std::optional<T>& value, const Field& field) {
    if (in_.holds_number(key)) get(key, value.emplace(), field);
  }

  template <class T>
  void get(const std::string& key, std::vector<T>& items, const Field&) {
    for (auto& item : in_.objects(key)) get_record(item, items.emplace_back());
  }

  template <class Key, class T>
  void get(const std::string& key, std::map<Key, T>& items, const Field& field) {
    auto object = in_.object(key);
    FieldReader read(object, author_);
    for (const auto& name : object.keys()) {
      if constexpr (std::is_same_v<Key, std::string>) {
        read.get(name, items[name], field);
      } else {
        Key own{};
        get_text(object, name, name, own);
        read.get(name, items[own], field);
      }
    }
  }

  template <class T>
  void get(const std::string& key, T& value, const Field&) {
    if constexpr (requires { from_text(key, value); }) {
      get_text(in_, key, in_.text(key), value);
    } else {
      auto object = in_.object(key);
      get_record(object, value);
    }
  }

  template <class T>
  static void get_text(const ObjectReader& in, const std::string& key, const std::string& text, T& value) {
    try {
      from_text(text, value);
    } catch (const InputError& e) {
      in.fail(key, e.what());
    }
  }

  template <class T>
  void get_record(ObjectReader& object, T& record) {
    FieldReader read(object, author_);
    fields(read, record);
    if (author_ == WrittenBy::Hand) object.finish();
  }

  ObjectReader& in_;
  WrittenBy author_;
};

/// The settings that the object holds. InputError with file, line and key for one that is unknown,
/// of another type or out of range.
template <class Settings>
Settings read_settings(ObjectReader in) {
  Settings settings;
  FieldReader read(in, WrittenBy::Hand);
  fields(read, settings);
  in.finish();
  return settings;
}

/// Refuses a file of another format than `expected`, with its place.
inline void check_format(ObjectReader& in, std::string_view expected) {
  if (const auto format = in.text("format"); format != expected)
    in.fail("format",
            fmt::format(
                "'{}' is not '{}': another version of orbs wrote it; open it with that one, or make it anew",
                format, expected));
}

}  // namespace orbs::json
