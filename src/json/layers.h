#pragma once

#include "json/document.h"

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

/// One document put together from several, each over those below it.
namespace orbs::json {

/// A value of one of the documents, by its pointer there.
struct Origin {
  std::size_t layer = 0;
  std::string pointer;
};

struct Layers {
  std::vector<Document> documents;        // the lowest first
  std::map<std::string, Origin> origins;  // by pointer into the whole; what is not listed is its parent's
};

/// Arrays at the top of the documents that are not replaced as a whole.
struct LayeredArrays {
  std::set<std::string> by_name{};   // objects of the same "name" are put together
  std::set<std::string> appended{};  // the elements of all documents, the lowest first
};

/// What the text at `pointer` in the document number `layer` stands for.
using TextOf =
    std::function<std::string(std::size_t layer, const std::string& pointer, const std::string& text)>;

/// The whole: objects are put together key by key, any other value takes the place of the one below, and null
/// takes away the key below it. Complaints about the whole name the file and line of the document that a
/// value comes from. At least one document, all of them objects.
Document layered(std::vector<Document> documents, const LayeredArrays& arrays, const TextOf& text_of);

/// Where the value with this pointer stands: the document itself, or the one that it comes from.
struct Standing {
  const Document* document;
  std::string pointer;
};
Standing standing_of(const Document& document, const std::string& pointer);

}  // namespace orbs::json
