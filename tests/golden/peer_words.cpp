#include "golden/peer_words.h"

#include "base/text.h"
#include "golden/pbrt_tokens.h"
#include "golden/xml.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::tests {

namespace {

bool is_text(const std::string& token) { return token.starts_with('"'); }

class PbrtWords {
 public:
  explicit PbrtWords(std::vector<std::string> tokens) : tokens_(std::move(tokens)) {}

  std::set<std::string> take() {
    while (at_ < tokens_.size()) directive(tokens_[at_++]);
    return std::move(words_);
  }

 private:
  void directive(const std::string& name) {
    static const std::set<std::string> kNamesOfOurs{"NamedMaterial", "ObjectBegin", "ObjectInstance"};
    if (name == "Option") {
      words_.insert("Option " + text());
      ++at_;
    } else if (name == "Texture") {
      text();  // a name of ours
      const std::string kind = text();
      parameters(fmt::format("Texture {} {}", kind, text()));
    } else if (name == "MakeNamedMaterial") {
      text();
      words_.insert(name);
      material();
    } else if (at_ < tokens_.size() && is_text(tokens_[at_]) && !kNamesOfOurs.contains(name)) {
      parameters(fmt::format("{} {}", name, text()));
    } else {
      words_.insert(name);
      while (at_ < tokens_.size() && !is_directive(tokens_[at_])) ++at_;
    }
  }
  static bool is_directive(const std::string& token) { return token[0] >= 'A' && token[0] <= 'Z'; }

  // Its type is a parameter.
  void material() {
    if (text() != "string type") throw std::runtime_error("a material's type expected first");
    parameters("Material " + text());
  }
  void parameters(const std::string& of) {
    words_.insert(of);
    while (at_ < tokens_.size() && is_text(tokens_[at_])) {
      const std::string parameter = text();
      const std::string value = tokens_.at(at_);
      words_.insert(fmt::format("{} {}", of, parameter));
      const bool is_of_file = parameter == "string filename" || parameter == "string normalmap";
      if (parameter.starts_with("string ") && !is_of_file && is_text(value))
        words_.insert(fmt::format("{} {}={}", of, parameter, value.substr(1)));
      if (value == "[")
        while (tokens_.at(at_) != "]") ++at_;
      ++at_;
    }
  }
  std::string text() {
    if (at_ == tokens_.size() || !is_text(tokens_[at_])) throw std::runtime_error("a string expected");
    return tokens_[at_++].substr(1);
  }

  std::vector<std::string> tokens_;
  std::size_t at_ = 0;
  std::set<std::string> words_;
};

void add_words(const Element& element, const std::string& of, std::set<std::string>& words) {
  const bool is_plugin = element.attributes.contains("type");
  const std::string own = is_plugin ? fmt::format("{} {}", element.name, element.at("type")) : element.name;
  const auto name = element.attributes.find("name");
  if (!of.empty())
    words.insert(name == element.attributes.end() ? fmt::format("{} {}", of, element.name)
                                                  : fmt::format("{} {} {}", of, element.name, name->second));
  if (element.name == "string" && element.at("name") != "filename")
    words.insert(fmt::format("{} string {}={}", of, name->second, element.at("value")));
  if (is_plugin) {
    words.insert(own);
  } else {
    std::vector<std::string> keys;
    for (const auto& [key, value] : element.attributes) keys.push_back(key);
    words.insert(fmt::format("attributes {} {}", element.name, fmt::join(keys, " ")));
  }
  for (const Element& child : element.children) add_words(child, own, words);
}

}  // namespace

std::set<std::string> pbrt_words(const std::string& text) { return PbrtWords(pbrt_tokens(text)).take(); }

std::set<std::string> mitsuba_words(const std::string& text) {
  std::set<std::string> words;
  add_words(read_xml(text), "", words);
  return words;
}

namespace {

void add_hydra_words(const Element& element, const std::string& parent, std::set<std::string>& words) {
  const auto type = element.attributes.find("type");
  const std::string own =
      type == element.attributes.end() ? element.name : fmt::format("{} {}", element.name, type->second);
  if (!parent.empty()) words.insert(fmt::format("{}/{}", parent, own));
  for (const auto& [key, value] : element.attributes) {
    if (key == "id" || key == "type") continue;
    words.insert(fmt::format("{}@{}", own, key));
    if (key == "shape" || key.starts_with("addressing_mode"))
      words.insert(fmt::format("{}@{}={}", own, key, value));
  }
  for (const Element& child : element.children) add_hydra_words(child, own, words);
}

}  // namespace

std::set<std::string> hydra_words(const std::string& text) {
  std::set<std::string> words;
  add_hydra_words(read_xml(text), "", words);
  return words;
}

std::map<std::string, std::string> known_words(const std::string& text) {
  std::map<std::string, std::string> words;
  for (const std::string& line : split(text, '\n')) {
    if (line.empty() || line.starts_with('#')) continue;
    const auto parts = split(line, '|');
    if (parts.size() != 2 || parts[1].find(':') == std::string::npos)
      throw std::runtime_error("expected 'word | file:line', found: " + line);
    words[std::string(trim(parts[0]))] = trim(parts[1]);
  }
  return words;
}

}  // namespace orbs::tests
