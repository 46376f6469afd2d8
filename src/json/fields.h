#pragma once

#include "base/error.h"
#include "base/statistics.h"
#include "json/object_reader.h"

#include <array>
#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

/// The members of every record and of all settings are listed once, in a function template beside their
/// struct:
///
///   template <class Visitor, json::RecordOf<Task> Record>
///   void fields(Visitor& visit, Record& task) {
///     visit.required("name", task.name);
///     visit("jobs", task.jobs, {.help = "Number of renders at the same time", .range = {1, 1024}});
///   }
///
/// FieldWriter writes the listed members as JSON and FieldReader reads them; for settings the command line,
/// the hash of what outdates an image, the JSON schema and the tables of the documentation follow from the
/// same line. A key states the unit of its number as its last word ("wall_seconds", "peak_rss_bytes"). A
/// member that is missing in a file keeps its default, unless it is required.
///
/// inside_folder(key, member) is for the path of a file or folder, relative to the folder that the record
/// lies in: the reader refuses one that leads out of it.
///
/// A type that is written as a text, such as an enum, has two functions beside it: to_text(value), and
/// from_text(text, value), which throws InputError for a text that stands for no value. An enum may have a
/// list of its values with their texts instead:
///
///   inline constexpr auto names(Purpose) {
///     return std::array{json::Named{Purpose::Sweep, "sweep"}, json::Named{Purpose::FixedCost, "fixed"}};
///   }
///
/// nullable(key, member) is for an optional, or a number that may be NaN, of data that are only written: null
/// stands where the value is not known.
namespace orbs::json {

/// Record, or const Record for a visitor that only looks.
template <class Candidate, class Record>
concept RecordOf = std::same_as<std::remove_const_t<Candidate>, Record>;

/// A value of an enum and the text that stands for it.
template <class Enum>
struct Named {
  constexpr Named(Enum the_value, std::string_view the_name) : value(the_value), name(the_name) {}
  Enum value;
  std::string_view name;
};

template <class Enum>
concept NamedEnum = std::is_enum_v<Enum> && requires(Enum value) {
  names(value);
};

template <NamedEnum Enum>
std::string_view to_text(Enum value) {
  for (const auto& named : names(value))
    if (named.value == value) return named.name;
  return {};
}

template <NamedEnum Enum>
void from_text(std::string_view text, Enum& value) {
  std::string known;
  for (const auto& named : names(value)) {
    if (named.name == text) {
      value = named.value;
      return;
    }
    known += std::string(known.empty() ? "'" : ", '").append(named.name) + "'";
  }
  throw InputError("'" + std::string(text) + "' is none that this version of orbs knows; expected one of " +
                   known);
}

template <class Visitor, RecordOf<Interval> Record>
void fields(Visitor& visit, Record& interval) {
  visit.nullable("value", interval.value);
  visit.nullable("low", interval.low);
  visit.nullable("high", interval.high);
}

/// What a line of fields() says about its member beyond its key.
struct Field {
  std::string_view help{};    // what it is for, in Markdown without links; --help has it without backticks
  std::string_view option{};  // of the command line, with the word for its value: "-j,--jobs NUMBER"
  bool is_list = false;       // a text: the option may be given several times, which commas join
  Range range{};              // of the number, or of each number of a list or map
  std::string_view advice{};  // in the complaint about a number below the range
  std::string_view unset{};   // what applies where it is not given, if its initial value does not say it
  bool changes_image = true;  // of an entry of a renderer: an image that was rendered before is outdated
};

}  // namespace orbs::json
