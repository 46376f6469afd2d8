#include "base/files.h"
#include "base/text.h"
#include "json/object_reader.h"

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

[[noreturn]] void refuse(const std::string& name,
                         const std::string& text,
                         std::size_t offset,
                         const std::string& problem) {
  const auto at = position_of_offset(text, offset);
  throw InputError(fmt::format("{}:{}:{}: {}\n{}", name, at.line, at.column, problem, excerpt(text, at)));
}

}  // namespace

Document parse(std::string name, std::string text) {
  constexpr int kDeepest =
      64;  // locate() and later readers recurse by level; no real file of ours goes beyond 10
  std::vector<std::set<std::string>> open_objects;
  std::size_t bytes_read = 0;
  const auto here = [&] { return bytes_read > 0 ? bytes_read - 1 : 0; };
  const auto check = [&](int depth, nlohmann::json::parse_event_t event, nlohmann::json& value) {
    using Event = nlohmann::json::parse_event_t;
    if (depth > kDeepest) refuse(name, text, here(), fmt::format("nested deeper than {} levels", kDeepest));
    if (event == Event::object_start) open_objects.emplace_back();
    if (event == Event::object_end) open_objects.pop_back();
    if (event == Event::key && !open_objects.back().insert(value.get<std::string>()).second)
      refuse(name, text, here(),
             fmt::format("key '{}' appears twice in one object", value.get<std::string>()));
    return true;
  };
  if (trim(text).empty()) refuse(name, text, 0, "the file is empty, expected a JSON object");
  try {
    const char* begin = text.data();
    auto root = std::make_shared<const nlohmann::json>(
        nlohmann::json::parse(Reading{begin, &bytes_read}, Reading{begin + text.size(), &bytes_read}, check));
    return {std::move(name), std::move(text), std::move(root)};
  } catch (const nlohmann::json::parse_error& e) {
    refuse(name, text, e.byte > 0 ? e.byte - 1 : 0, "not valid JSON: " + shortened(e.what()));
  } catch (const nlohmann::json::exception& e) {
    refuse(name, text, here(), "not usable JSON: " + shortened(e.what()));
  }
}

Document parse_file(const std::filesystem::path& path) { return parse(path.string(), read_file(path)); }

}  // namespace orbs::json
