#pragma once

#include "json/fields.h"
#include "json/writer.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::json {

/// The visitor of fields() that writes the members as JSON. Left out are an empty optional, a rectangle that
/// is all of the image, a record that is_absent(), and what the filter does not keep.
class FieldWriter {
 public:
  using Filter = bool (*)(const Field& field);

  explicit FieldWriter(Writer& out, Filter keeps = nullptr) : out_(out), keeps_(keeps) {}

  template <class T>
  void operator()(std::string_view key, const T& value, const Field& field = {}) {
    if (keeps_ != nullptr && !keeps_(field)) return;
    if constexpr (requires { is_absent(value); })
      if (is_absent(value)) return;
    out_.key(key);
    put(value);
  }

  template <class T>
  void operator()(std::string_view key, const std::optional<T>& value, const Field& field = {}) {
    if (value) (*this)(key, *value, field);
  }

  template <class T>
  void required(std::string_view key, const T& value, const Field& field = {}) {
    if (keeps_ != nullptr && !keeps_(field)) return;
    out_.key(key);
    put(value);
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

  void nullable(std::string_view key, double value) { out_.member(key, value); }

  template <class T>
  void nullable(std::string_view key, const std::optional<T>& value) {
    out_.key(key);
    put(value);
  }

  void rectangle(std::string_view key, const std::vector<double>& corners) {
    if (!corners.empty()) out_.key(key).numbers(corners);
  }

 private:
  void put(std::size_t number) { out_.value(static_cast<unsigned long long>(number)); }
  void put(const std::vector<std::string>& texts) { out_.value(texts); }
  void put(const std::vector<double>& numbers) { out_.numbers(numbers); }
  void put(const std::vector<std::size_t>& indices) {
    out_.numbers(std::vector<double>(indices.begin(), indices.end()));
  }

  template <class T>
  void put(const std::vector<T>& items) {
    out_.begin_array();
    for (const auto& item : items) put(item);
    out_.end_array();
  }

  template <class Key, class T>
  void put(const std::map<Key, T>& items) {
    out_.begin_object();
    for (const auto& [key, item] : items) {
      if constexpr (std::is_same_v<Key, std::string>) {
        out_.key(key);
      } else {
        out_.key(to_text(key));
      }
      put(item);
    }
    out_.end_object();
  }

  template <class T>
  void put(const std::optional<T>& value) {
    if (value) {
      put(*value);
    } else {
      out_.null();
    }
  }

  template <class T>
  void put(const T& value) {
    if constexpr (requires { to_text(value); }) {
      out_.value(to_text(value));
    } else if constexpr (requires { fields(*this, value); }) {
      out_.begin_object();
      fields(*this, value);
      out_.end_object();
    } else {
      out_.value(value);
    }
  }

  Writer& out_;
  Filter keeps_;
};

/// Writes the members of a record into the object that is open.
template <class Record>
void write_fields(Writer& out, const Record& record, FieldWriter::Filter keeps = nullptr) {
  FieldWriter visit(out, keeps);
  fields(visit, record);
}

/// Writes the record as an object.
template <class Record>
void write_record(Writer& out, const Record& record) {
  out.begin_object();
  write_fields(out, record);
  out.end_object();
}

}  // namespace orbs::json
