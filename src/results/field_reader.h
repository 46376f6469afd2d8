#pragma once

#include "base/files_inside.h"
#include "base/text.h"
#include "json/object_reader.h"
#include "results/job_outcome.h"
#include "results/verdict.h"

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace orbs::results {

/// The visitor of fields() that reads a record from a JSON object. A member that is not there keeps its
/// value.
class FieldReader {
 public:
  explicit FieldReader(json::ObjectReader& in) : in_(in) {}

  template <class T>
  void operator()(const std::string& key, T& value) {
    if (in_.has(key)) get(key, value);
  }

  template <class T>
  void required(const std::string& key, T& value) {
    get(key, value);
  }

  void at_least(const std::string& key, int& value, int least) {
    value = in_.integer_or(key, value, least, kMostInteger);
  }

  void at_least(const std::string& key, std::map<std::string, int>& values, int least) {
    if (!in_.has(key)) return;
    auto object = in_.object(key);
    for (const auto& name : object.keys()) values[name] = object.integer(name, least, kMostInteger);
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
    get(key, value);
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

  void get(const std::string& key, std::string& value) { value = in_.text(key); }
  void get(const std::string& key, std::vector<std::string>& value) { value = in_.texts(key); }
  void get(const std::string& key, double& value) { value = in_.number(key); }
  void get(const std::string& key, bool& value) { value = in_.boolean_or(key, value); }

  void get(const std::string& key, int& value) { value = in_.integer(key, -kMostInteger, kMostInteger); }

  void get(const std::string& key, std::size_t& value) {
    constexpr double kLargestExact = 9007199254740992;  // 2^53: every integer up to it is a double
    const double number = in_.number(key, {0, kLargestExact});
    value = static_cast<std::size_t>(number);
    if (static_cast<double>(value) != number)
      in_.fail(key, fmt::format("must be a whole number, is {}", number));
  }

  void get(const std::string& key, Verdict& value) {
    const auto name = in_.text(key);
    const auto verdict = verdict_named(name);
    if (!verdict) in_.fail(key, fmt::format("'{}' is no verdict that this version of orbs knows", name));
    value = *verdict;
  }

  void get(const std::string& key, Expectation& value) {
    const auto name = in_.text(key);
    const auto expectation = expectation_named(name);
    if (!expectation)
      in_.fail(key, fmt::format("'{}' is no expectation that this version of orbs knows", name));
    value = *expectation;
  }

  void get(const std::string& key, JobOutcome& value) {
    const auto name = in_.text(key);
    const auto outcome = job_outcome_named(name);
    if (!outcome) in_.fail(key, fmt::format("'{}' is no outcome that this version of orbs knows", name));
    value = *outcome;
  }

  template <class T>
  void get(const std::string& key, std::optional<T>& value) {
    if (!in_.has(key) || !in_.holds_number(key)) return;
    value.emplace();
    get(key, *value);
  }

  template <class T>
  void get(const std::string& key, std::vector<T>& items) {
    for (auto& item : in_.objects(key)) {
      FieldReader read(item);
      fields(read, items.emplace_back());
    }
  }

  template <class T>
  void get(const std::string& key, std::map<std::string, T>& items) {
    auto object = in_.object(key);
    FieldReader read(object);
    for (const auto& name : object.keys()) read.get(name, items[name]);
  }

  template <class T>
  void get(const std::string& key, T& record) {
    auto object = in_.object(key);
    FieldReader read(object);
    fields(read, record);
  }

  json::ObjectReader& in_;
};

/// Refuses a file of another format than `expected`, with its place.
void check_format(json::ObjectReader& in, const std::string& expected);

}  // namespace orbs::results
