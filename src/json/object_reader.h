#pragma once

#include "base/error.h"
#include "base/vec.h"
#include "json/document.h"

#include <initializer_list>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace orbs::json {

struct Range {
  double min = -std::numeric_limits<double>::max();
  double max = std::numeric_limits<double>::max();
};
constexpr Range kAnyNumber{};
constexpr Range kNotNegative{0.0, std::numeric_limits<double>::max()};
constexpr Range kPositive{std::numeric_limits<double>::min(), std::numeric_limits<double>::max()};

/// Reads one JSON object. Every key must be asked for before finish(), so typos cannot pass. Readers point
/// into their Document, which must outlive them. Every complaint is an InputError "file:line:column:
/// /json/pointer: problem".
class ObjectReader {
 public:
  explicit ObjectReader(const Document& document);

  bool has(const std::string& key);
  double number(const std::string& key, Range range = kAnyNumber);
  double number_or(const std::string& key, double fallback, Range range = kAnyNumber);
  int integer(const std::string& key, int min, int max);
  int integer_or(const std::string& key, int fallback, int min, int max);
  bool boolean_or(const std::string& key, bool fallback);
  std::string text(const std::string& key);
  /// As text, for what the system or another program takes as a path, a name or a word of a command line:
  /// there a zero byte ends it, so it must hold none.
  std::string system_text(const std::string& key);
  std::string text_or(const std::string& key, const std::string& fallback);
  std::string one_of(const std::string& key, std::initializer_list<std::string_view> allowed);
  std::string one_of_or(const std::string& key,
                        const std::string& fallback,
                        std::initializer_list<std::string_view> allowed);

  /// Array of numbers; `count` = required length, 0 for any.
  std::vector<double> numbers(const std::string& key, std::size_t count = 0, Range range = kAnyNumber);
  /// Array of arrays of `count` numbers each.
  std::vector<std::vector<double>> number_rows(const std::string& key,
                                               std::size_t count,
                                               Range range = kAnyNumber);
  std::vector<std::string> texts(const std::string& key);
  std::vector<std::string> system_texts(const std::string& key);
  /// Refuses a number, or one of an array, that is written with a fraction or an exponent, as 1.0.
  void check_written_whole(const std::string& key);
  Vec3d vec3(const std::string& key, Range range = kAnyNumber);
  Vec3d vec3_or(const std::string& key, Vec3d fallback, Range range = kAnyNumber);

  /// `expected` is what a complaint asks for where an object is not all that may stand there.
  ObjectReader object(const std::string& key, const std::string& expected = "an object");
  /// Array of objects; an absent key is an empty array for objects_or_none.
  std::vector<ObjectReader> objects(const std::string& key);
  std::vector<ObjectReader> objects_or_none(const std::string& key);
  /// True when the key holds an array whose first element is an object (or which is empty).
  bool holds_objects(const std::string& key);
  bool holds_text(const std::string& key);
  bool holds_array(const std::string& key);
  /// False for null, which stands for a number that JSON cannot hold.
  bool holds_number(const std::string& key);
  /// Keys of this object in file order of nlohmann (sorted): for objects that are dictionaries.
  std::vector<std::string> keys() const;

  /// Refuses keys that nobody asked for.
  void finish() const;
  [[noreturn]] void fail(const std::string& key, const std::string& problem) const;
  /// As fail, but points at the element `index` of the array under `key`.
  [[noreturn]] void fail_at(const std::string& key, std::size_t index, const std::string& problem) const;
  /// "file:line" of the value, for messages about meaning that are found after reading.
  std::string place(const std::string& key) const;
  const std::string& file() const { return document_->name; }

 private:
  ObjectReader(const Document& document, std::string pointer, const nlohmann::json& value);
  const nlohmann::json& required(const std::string& key);
  const nlohmann::json& required_array(const std::string& key);
  double number_of(const nlohmann::json& value, const std::string& where, Range range) const;
  std::string pointer_to(const std::string& key) const;
  [[noreturn]] void fail_pointer(const std::string& pointer, const std::string& problem) const;

  const Document* document_;
  std::string pointer_;
  const nlohmann::json* value_;
  std::set<std::string> asked_;
};

}  // namespace orbs::json
