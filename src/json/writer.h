#pragma once

#include "base/vec.h"

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::json {

/// Writes JSON text in the order of the calls: objects one member a line, arrays of numbers on one line.
/// Numbers are the shortest text that reads back to the same double; NaN and infinities, which JSON cannot
/// hold, become null.
class Writer {
 public:
  Writer& begin_object();
  Writer& end_object();
  Writer& begin_array();
  Writer& end_array();
  Writer& key(std::string_view name);

  Writer& value(double number);
  Writer& value(int number);
  Writer& value(long long number);
  Writer& value(unsigned long long number);
  Writer& value(bool flag);
  Writer& value(std::string_view text);
  Writer& value(const char* text) { return value(std::string_view(text)); }
  Writer& value(const std::string& text) { return value(std::string_view(text)); }
  Writer& null();
  Writer& numbers(std::span<const double> values);
  Writer& value(Vec3d v);
  Writer& value(const std::vector<std::string>& texts);

  template <typename T>
  Writer& member(std::string_view name, const T& content) {
    return key(name).value(content);
  }

  /// The whole text with a final newline; all objects and arrays must be closed.
  std::string text() const;

 private:
  void before_value();
  void line_break();

  std::string out_;
  std::vector<bool> has_elements_;  // one per open object or array
  bool after_key_ = false;
};

/// `text` as a JSON string with quotes; bytes that are not UTF-8 become U+FFFD.
std::string json_string(std::string_view text);

}  // namespace orbs::json
