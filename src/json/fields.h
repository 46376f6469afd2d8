#pragma once

#include "json/object_reader.h"

#include <concepts>
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
/// from_text(text, value), which throws InputError for a text that stands for no value.
namespace orbs::json {

/// Record, or const Record for a visitor that only looks.
template <class Candidate, class Record>
concept RecordOf = std::same_as<std::remove_const_t<Candidate>, Record>;

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
