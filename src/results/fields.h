#pragma once

#include <concepts>
#include <type_traits>

/// The members of every record are listed once, in a function template beside its struct:
///
///   template <class Visitor, RecordOf<LeftOut> Record>
///   void fields(Visitor& visit, Record& left) {
///     visit.required("renderer", left.renderer);
///     visit("reason", left.reason);
///   }
///
/// FieldWriter writes the listed members as JSON, the reader of read_record.cpp reads them, and the page
/// shows them: a member that is added here is stored, read and shown. A key states the unit of its number as
/// its last word ("wall_seconds", "peak_rss_bytes"). A member that is missing in a file keeps its default,
/// unless it is required. at_least(key, member, least) is for a number, or a map of numbers, that must not be
/// less than `least`: the reader refuses it. inside_folder(key, member) is for the path of a file or folder,
/// relative to the folder that the record lies in: the reader refuses one that leads out of it.
namespace orbs::results {

/// Record, or const Record for a visitor that only looks.
template <class Candidate, class Record>
concept RecordOf = std::same_as<std::remove_const_t<Candidate>, Record>;

}  // namespace orbs::results
