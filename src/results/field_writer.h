#pragma once

#include "json/writer.h"
#include "results/host_record.h"
#include "results/job_outcome.h"
#include "results/verdict.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::results {

/// The visitor of fields() that writes a record as JSON. An empty optional, an unknown host and a rectangle
/// that is all of the image are left out.
class FieldWriter {
 public:
  explicit FieldWriter(json::Writer& out) : out_(out) {}

  template <class T>
  void operator()(std::string_view key, const T& value) {
    out_.key(key);
    put(value);
  }

  template <class T>
  void operator()(std::string_view key, const std::optional<T>& value) {
    if (value) (*this)(key, *value);
  }

  void operator()(std::string_view key, const Host& host) {
    if (host == Host{}) return;
    out_.key(key);
    put(host);
  }

  template <class T>
  void required(std::string_view key, const T& value) {
    (*this)(key, value);
  }

  template <class T>
  void at_least(std::string_view key, const T& value, int) {
    (*this)(key, value);
  }

  void inside_folder(std::string_view key, const std::string& path) { (*this)(key, path); }

  /// JSON has no infinity: it becomes null, with "infinite": true beside it.
  void maybe_infinite(std::string_view key, double value) {
    out_.member(key, value);
    if (std::isinf(value)) out_.member("infinite", true);
  }

  void maybe_infinite(std::string_view key, const std::optional<double>& value) {
    if (value) maybe_infinite(key, *value);
  }

  void rectangle(std::string_view key, const std::vector<double>& corners) {
    if (!corners.empty()) out_.key(key).numbers(corners);
  }

 private:
  void put(Verdict verdict) { out_.value(verdict_name(verdict)); }
  void put(Expectation expectation) { out_.value(expectation_name(expectation)); }
  void put(JobOutcome outcome) { out_.value(job_outcome_name(outcome)); }
  void put(std::size_t number) { out_.value(static_cast<unsigned long long>(number)); }
  void put(const std::vector<std::string>& texts) { out_.value(texts); }

  template <class T>
  void put(const std::vector<T>& items) {
    out_.begin_array();
    for (const auto& item : items) put(item);
    out_.end_array();
  }

  template <class T>
  void put(const std::map<std::string, T>& items) {
    out_.begin_object();
    for (const auto& [key, item] : items) (*this)(key, item);
    out_.end_object();
  }

  template <class T>
  void put(const T& value) {
    if constexpr (requires { fields(*this, value); }) {
      out_.begin_object();
      fields(*this, value);
      out_.end_object();
    } else {
      out_.value(value);
    }
  }

  json::Writer& out_;
};

/// Writes the members of a record into the object that is open.
template <class Record>
void write_fields(json::Writer& out, const Record& record) {
  FieldWriter visit(out);
  fields(visit, record);
}

/// Writes the record as an object.
template <class Record>
void write_record(json::Writer& out, const Record& record) {
  out.begin_object();
  write_fields(out, record);
  out.end_object();
}

}  // namespace orbs::results
