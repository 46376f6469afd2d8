#pragma once

#include <map>
#include <string>
#include <vector>

namespace orbs::tests {

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<Element> children;

  const std::string& at(const std::string& key) const { return attributes.at(key); }
  /// The child that is called `called` by its name attribute.
  const Element* named(const std::string& called) const;
  /// The first child with that tag.
  const Element* kind(const std::string& tag) const;
  /// The value attribute of a named child; throws when there is none.
  const std::string& value(const std::string& called) const;
  double number(const std::string& called) const;
};

/// The root of as much of XML as a scene takes: elements, attributes, comments, one declaration. Throws
/// std::runtime_error for a text that is not well-formed.
Element read_xml(const std::string& text);

}  // namespace orbs::tests
