#include "base/files.h"
#include "json/object_reader.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace orbs::json {

Document parse(std::string name, std::string text) {
  constexpr int kDeepest =
      64;  // locate() and later readers recurse by level; no real file of ours goes beyond 10
  std::vector<std::set<std::string>> open_objects;
  const auto check = [&](int depth, nlohmann::json::parse_event_t event, nlohmann::json& value) {
    using Event = nlohmann::json::parse_event_t;
    if (depth > kDeepest) throw InputError(fmt::format("{}: nested deeper than {} levels", name, kDeepest));
    if (event == Event::object_start) open_objects.emplace_back();
    if (event == Event::object_end) open_objects.pop_back();
    if (event == Event::key && !open_objects.back().insert(value.get<std::string>()).second)
      throw InputError(
          fmt::format("{}: key '{}' appears twice in one object", name, value.get<std::string>()));
    return true;
  };
  try {
    auto root = std::make_shared<const nlohmann::json>(nlohmann::json::parse(text, check));
    return {std::move(name), std::move(text), std::move(root)};
  } catch (const nlohmann::json::parse_error& e) {
    const auto at = position_of_offset(text, e.byte > 0 ? e.byte - 1 : 0);
    throw InputError(fmt::format("{}:{}:{}: not valid JSON: {}\n{}", name, at.line, at.column, e.what(),
                                 excerpt(text, at)));
  } catch (const nlohmann::json::exception& e) {
    throw InputError(fmt::format("{}: not usable JSON: {}", name, e.what()));
  }
}

Document parse_file(const std::filesystem::path& path) { return parse(path.string(), read_file(path)); }

}  // namespace orbs::json
