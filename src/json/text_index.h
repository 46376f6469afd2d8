#pragma once

#include "json/locate.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::json {

/// Where values are in one text, for many questions: each object and array is looked through once, and lines
/// are counted once, so that the places of n entries cost n steps and not n². One thread asks at a time.
class TextIndex {
 public:
  /// As locate. The text is the same, valid JSON, for all questions.
  TextPosition locate(std::string_view text, std::string_view pointer);

 private:
  const std::map<std::string, std::size_t>& children_of(std::string_view text,
                                                        const std::string& pointer,
                                                        std::size_t offset);

  std::map<std::string, std::map<std::string, std::size_t>> children_;  // offsets by pointer, then by key
  std::vector<std::size_t> line_begins_;
};

}  // namespace orbs::json
