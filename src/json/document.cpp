#include "json/document.h"

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "json/locate.h"

#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace orbs::json {

namespace {

// Tells how far the parser has come, which its own events do not.
struct Reading {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at;
  std::size_t* bytes_read;

  reference operator*() const { return *at; }
  Reading& operator++() {
    ++at;
    ++*bytes_read;
    return *this;
  }
  bool operator==(const Reading& other) const { return at == other.at; }
};

// The library quotes all that it has read of a word, spaces before it included.
std::string shortened(const std::string& text) {
  constexpr std::size_t kSide = 150;
  if (text.size() <= 2 * kSide) return text;
  return text.substr(0, kSide) + " ... " + text.substr(text.size() - kSide);
}

// What the library says without its own name of the error and its place, which we state ourselves:
// "[json.exception.parse_error.101] parse error at line 1, column 2: ".
std::string without_prefix(const std::string& text) {
  constexpr std::string_view kPlace = "parse error at line";
  auto rest = text.substr(text.starts_with('[') ? text.find("] ") + 2 : 0);
  if (rest.starts_with(kPlace)) rest.erase(0, rest.find(": ") + 2);
  return rest;
}

[[noreturn]] void refuse(const std::string& name,
                         const std::string& text,
                         std::size_t offset,
                         const std::string& problem) {
  const auto at = position_of_offset(text, offset);
  throw InputError(fmt::format("{}:{}:{}: {}\n{}", name, at.line, at.column, problem, excerpt(text, at)));
}

// A problem that the parser or the builder has found; without an offset it is where the parser stands.
struct Refusal {
  std::string problem;
  std::optional<std::size_t> offset = {};
};

// Builds the tree from the parser's events. The library's own builder with a callback looks through the whole
// parent after each of its elements (nlohmann-json 3.11.2, json_sax_dom_callback_parser::end_object): arrays
// of objects cost it quadratic time, 52 s for 400,000 instances.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit TreeBuilder(nlohmann::json& root) : root_(root) {}

  bool null() override { return add(nullptr) != nullptr; }
  bool boolean(bool value) override { return add(value) != nullptr; }
  bool number_integer(number_integer_t value) override { return add(value) != nullptr; }
  bool number_unsigned(number_unsigned_t value) override { return add(value) != nullptr; }
  bool number_float(number_float_t value, const string_t&) override { return add(value) != nullptr; }
  bool string(string_t& value) override { return add(std::move(value)) != nullptr; }
  bool binary(binary_t&) override { return false; }  // JSON text has none
  bool start_object(std::size_t) override { return open(nlohmann::json::object()); }
  bool start_array(std::size_t) override { return open(nlohmann::json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    const auto [member, is_new] = open_.back()->emplace(name, nullptr);
    if (!is_new) throw Refusal{fmt::format("key '{}' appears twice in one object", name)};
    member_ = &*member;
    return true;
  }

  bool parse_error(std::size_t byte, const std::string&, const nlohmann::json::exception& e) override {
    // Other exceptions are of numbers beyond the range of double.
    if (dynamic_cast<const nlohmann::json::parse_error*>(&e) == nullptr)
      throw Refusal{"not usable JSON: " + shortened(without_prefix(e.what()))};
    throw Refusal{"not valid JSON: " + shortened(without_prefix(e.what())), byte > 0 ? byte - 1 : 0};
  }

 private:
  // The value in its place: the root, the end of the open array, or the member whose key was read last.
  nlohmann::json* add(nlohmann::json value) {
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    if (open_.back()->is_array()) return &open_.back()->emplace_back(std::move(value));
    *member_ = std::move(value);
    return member_;
  }
  bool open(nlohmann::json structure) {
    constexpr std::size_t kDeepest = 64;  // locate() and later readers recurse by level; no file of ours
                                          // goes beyond 10
    if (open_.size() > kDeepest) throw Refusal{fmt::format("nested deeper than {} levels", kDeepest)};
    open_.push_back(add(std::move(structure)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  nlohmann::json& root_;
  std::vector<nlohmann::json*> open_;  // from the root to what is being read; none moves while it is open
  nlohmann::json* member_ = nullptr;
};

}  // namespace

Document parse(std::string name, std::string text) {
  if (trim(text).empty()) refuse(name, text, 0, "the file is empty, expected a JSON object");
  std::size_t bytes_read = 0;
  const char* begin = text.data();
  nlohmann::json root;
  TreeBuilder builder(root);
  try {
    nlohmann::json::sax_parse(Reading{begin, &bytes_read}, Reading{begin + text.size(), &bytes_read},
                              &builder);
  } catch (const Refusal& refusal) {
    const auto here = bytes_read > 0 ? bytes_read - 1 : 0;
    refuse(name, text, refusal.offset.value_or(here), refusal.problem);
  }
  auto shared = std::make_shared<const nlohmann::json>(std::move(root));
  return {std::move(name), std::move(text), std::move(shared), std::make_shared<TextIndex>()};
}

Document parse_file(const std::filesystem::path& path) { return parse(path.string(), read_file(path)); }

}  // namespace orbs::json
