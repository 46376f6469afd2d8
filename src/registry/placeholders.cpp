#include "registry/placeholders.h"

#include "base/text.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::registry {

namespace {

// A text as its parts: plain text, or the word between braces.
struct Part {
  std::string text;
  bool is_name = false;
};

struct Parts {
  std::vector<Part> parts;
  std::string problem;
};

Parts parts_of(std::string_view text) {
  Parts out;
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool doubled = i + 1 < text.size() && text[i + 1] == text[i];
    if (text[i] != '{' && text[i] != '}') {
      plain += text[i];
    } else if (doubled) {
      plain += text[i++];
    } else if (const auto close = text.find('}', i); text[i] == '{' && close != std::string_view::npos) {
      out.parts.push_back({plain});
      out.parts.push_back({std::string(text.substr(i + 1, close - i - 1)), true});
      plain.clear();
      i = close;
    } else {
      out.problem =
          fmt::format("'{}' has no partner; write {}{} for the character itself", text[i], text[i], text[i]);
      return out;
    }
  }
  out.parts.push_back({plain});
  return out;
}

}  // namespace

const std::set<std::string>& argument_placeholders() {
  static const std::set<std::string> kNames{"executable",   "scene",     "output", "folder", "spp",
                                            "seed",         "threads",   "width",  "height", "aa_grid",
                                            "trace_depth",  "transport", "root",   "build",  "layer",
                                            "antialiasing", "effects",   "bounces"};
  return kNames;
}

const std::set<std::string>& command_placeholders() {
  static const auto kNames = [] {
    auto names = argument_placeholders();
    names.insert({"arguments", "images", "plugin"});
    return names;
  }();
  return kNames;
}

const std::set<std::string>& executable_placeholders() {
  static const std::set<std::string> kNames{"executable", "root", "build"};
  return kNames;
}

std::optional<std::string> placeholder_problem(std::string_view text, const std::set<std::string>& known) {
  const auto parts = parts_of(text);
  if (!parts.problem.empty()) return parts.problem;
  for (const auto& part : parts.parts)
    if (part.is_name && !known.contains(part.text))
      return fmt::format("unknown placeholder {{{}}}{}; known are: {}", part.text, closest(part.text, known),
                         fmt::join(known, ", "));
  return std::nullopt;
}

bool uses_placeholder(std::string_view text, const std::string& name) {
  for (const auto& part : parts_of(text).parts)
    if (part.is_name && part.text == name) return true;
  return false;
}

bool uses_placeholder(const std::vector<std::string>& texts, const std::string& name) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& text) { return uses_placeholder(text, name); });
}

std::string fill_placeholders(std::string_view text, const Placeholders& values) {
  std::string out;
  for (const auto& part : parts_of(text).parts) {
    assert(!part.is_name || values.contains(part.text));
    out += part.is_name ? values.at(part.text) : part.text;
  }
  return out;
}

std::vector<std::string> fill_placeholders(const std::vector<std::string>& texts,
                                           const Placeholders& values) {
  std::vector<std::string> out;
  for (const auto& text : texts) out.push_back(fill_placeholders(text, values));
  return out;
}

std::string with_doubled_braces(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '{' || c == '}' ? std::string(2, c) : std::string(1, c);
  return out;
}

std::string with_some_placeholders(const std::string& text, const Placeholders& texts) {
  const auto parts = parts_of(text);
  if (!parts.problem.empty()) return text;
  std::string out;
  for (const auto& part : parts.parts) {
    const auto found = part.is_name ? texts.find(part.text) : texts.end();
    if (!part.is_name)
      out += with_doubled_braces(part.text);
    else
      out += found != texts.end() ? found->second : "{" + part.text + "}";
  }
  return out;
}

}  // namespace orbs::registry
