#include "server/run_names.h"

#include <algorithm>
#include <iterator>

namespace orbs::server {

namespace {

// The last `count` parts, or the whole path if it has fewer.
std::string tail(const std::filesystem::path& folder, std::ptrdiff_t count) {
  const auto parts = std::distance(folder.begin(), folder.end());
  std::filesystem::path out;
  for (auto part = std::next(folder.begin(), std::max<std::ptrdiff_t>(0, parts - count));
       part != folder.end(); ++part)
    out /= *part;
  return out.string();
}

}  // namespace

std::vector<std::string> run_names(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::string> names;
  for (const auto& folder : folders) {
    const auto is_shared = [&](std::ptrdiff_t count) {
      return std::any_of(folders.begin(), folders.end(), [&](const auto& other) {
        return other != folder && tail(other, count) == tail(folder, count);
      });
    };
    std::ptrdiff_t count = 1;
    while (is_shared(count)) ++count;
    names.push_back(tail(folder, count));
  }
  return names;
}

}  // namespace orbs::server
