#pragma once

#include "json/fields.h"

#include <string>

namespace orbs::report {

/// What a request of the page makes of a file, or has made of it.
struct FileChange {
  std::string file;
  int line = 1;      // where the new entry begins
  std::string diff;  // unified; "" if nothing changes
  std::string hash;  // of the file's content before the change
  bool written = false;
};

template <class Visitor, json::RecordOf<FileChange> Record>
void fields(Visitor& visit, Record& change) {
  visit("file", change.file);
  visit("line", change.line);
  visit("diff", change.diff);
  visit("hash", change.hash);
  visit("written", change.written);
}

/// The difference of two texts as `diff -u` writes it, in one hunk, with three lines of context. "" for equal
/// texts.
std::string unified_diff(const std::string& before, const std::string& after, const std::string& name);

std::string file_change_json(const FileChange& change);

}  // namespace orbs::report
