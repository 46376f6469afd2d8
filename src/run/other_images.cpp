#include "run/other_images.h"

#include "base/text.h"
#include "image/image_io.h"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::run {

namespace {

namespace fs = std::filesystem;

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

// Whether "Seed-277_0001.exr" is "seed-277.exr" with something before or behind its name.
bool has_stem(const fs::path& file, const std::string& image) {
  return lower_case(file.filename().string()).find(lower_case(fs::path(image).stem().string())) !=
         std::string::npos;
}

}  // namespace

std::set<std::string> other_images(const fs::path& folder, const std::string& image) {
  constexpr int kMostEntries = 10000;
  constexpr int kDeepest = 4;
  std::set<std::string> found;
  std::error_code failed;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, failed);
  const fs::recursive_directory_iterator end;
  for (int count = 0; !failed && entry != end && count < kMostEntries; entry.increment(failed), ++count) {
    if (entry.depth() >= kDeepest) entry.disable_recursion_pending();
    std::error_code ignored;
    if (entry->symlink_status(ignored).type() != fs::file_type::regular) continue;
    if (image::looks_like_image(entry->path()) || has_stem(entry->path(), image))
      found.insert(entry->path().lexically_relative(folder).generic_string());
  }
  return found;
}

std::string misnamed_text(const std::string& image,
                          const std::set<std::string>& before,
                          const std::set<std::string>& after) {
  constexpr std::size_t kShown = 3;
  std::vector<std::string> found;
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(found));
  std::erase(found, image);
  std::stable_partition(found.begin(), found.end(), [&](const auto& name) { return has_stem(name, image); });
  if (found.empty()) return "";
  const auto more = found.size() > kShown ? fmt::format(" and {} more", found.size() - kShown) : "";
  found.resize(std::min(kShown, found.size()));
  for (auto& name : found) name = clean_line(name);
  return fmt::format(", but {}{}", fmt::join(found, ", "), more);
}

}  // namespace orbs::run
