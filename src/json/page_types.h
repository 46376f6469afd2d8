#pragma once

#include "json/fields.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeinfo>
#include <vector>

#include <fmt/format.h>

namespace orbs::json {

/// "Host" for orbs::results::Host.
std::string type_name(const std::type_info& type);

/// The TypeScript types of records as FieldWriter writes them, each once, by the names of their structs. A
/// record that another one holds comes with it.
class PageTypes {
 public:
  /// Adds the type of the record and returns its name.
  template <class Record>
  std::string add();

  /// One type after the other, in the order of their names.
  std::string text() const;

 private:
  std::map<std::string, std::string> types_;  // by name: what stands behind "export type <name> ="
};

namespace page_types {

/// The visitor of fields() that lists the members of one record.
class Members {
 public:
  explicit Members(PageTypes& types) : types_(types) {}

  template <class T>
  void operator()(std::string_view key, const T& value, const Field& = {}) {
    constexpr bool kMayBeLeftOut = requires { is_absent(value); };
    add(key, kMayBeLeftOut ? "?" : "", type_of(value));
  }

  template <class T>
  void operator()(std::string_view key, const std::optional<T>&, const Field& = {}) {
    add(key, "?", type_of(T{}));
  }

  template <class T>
  void required(std::string_view key, const T& value, const Field& = {}) {
    add(key, "", type_of(value));
  }

  void inside_folder(std::string_view key, const std::string& path) { (*this)(key, path); }
  void rectangle(std::string_view key, const std::vector<double>&) { add(key, "?", "number[]"); }

  void maybe_infinite(std::string_view key, double) {
    add(key, "", "number | null");
    add("infinite", "?", "boolean");
  }

  void maybe_infinite(std::string_view key, const std::optional<double>&) {
    add(key, "?", "number | null");
    add("infinite", "?", "boolean");
  }

  void nullable(std::string_view key, double) { add(key, "", "number | null"); }

  template <class T>
  void nullable(std::string_view key, const std::optional<T>&) {
    add(key, "", type_of(T{}) + " | null");
  }

  const std::string& text() const { return text_; }

 private:
  void add(std::string_view key, std::string_view mark, const std::string& type) {
    text_ += fmt::format("  {}{}: {};\n", key, mark, type);
  }

  static std::string type_of(const std::string&) { return "string"; }
  static std::string type_of(std::string_view) { return "string"; }
  static std::string type_of(bool) { return "boolean"; }
  static std::string type_of(const std::vector<double>&) { return "(number | null)[]"; }

  template <class T>
  std::string type_of(const std::vector<T>&) {
    return type_of(T{}) + "[]";
  }

  template <class T>
  std::string type_of(const std::map<std::string, T>&) {
    return fmt::format("Record<string, {}>", type_of(T{}));
  }

  template <class T>
  std::string type_of(const T& value) {
    if constexpr (std::is_arithmetic_v<T>) {
      return "number";
    } else if constexpr (NamedEnum<T>) {
      std::string text;
      for (const auto& named : names(value))
        text += fmt::format("{}\"{}\"", text.empty() ? "" : " | ", named.name);
      return text;
    } else if constexpr (requires { to_text(value); }) {
      return "string";
    } else {
      return types_.add<T>();
    }
  }

  PageTypes& types_;
  std::string text_;
};

}  // namespace page_types

template <class Record>
std::string PageTypes::add() {
  const auto name = type_name(typeid(Record));
  if (types_.contains(name)) return name;
  types_[name];  // a record may hold records of its own type
  page_types::Members members(*this);
  const Record record;
  fields(members, record);
  types_[name] = fmt::format("{{\n{}}}", members.text());
  return name;
}

}  // namespace orbs::json
