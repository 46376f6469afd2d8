#include "importer/report.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::importer {

void Report::not_understood(const std::string& what, const std::string& instead, const std::string& where) {
  auto& places = remarks_[{what, instead}];
  if (std::find(places.begin(), places.end(), where) == places.end()) places.push_back(where);
}

std::vector<Report::Remark> Report::remarks() const {
  std::vector<Remark> all;
  for (const auto& [key, where] : remarks_) all.push_back({key.first, key.second, where});
  return all;
}

std::string text_of(const Report::Remark& remark) {
  constexpr std::size_t kShown = 3;
  const auto shown = std::span(remark.where).first(std::min(kShown, remark.where.size()));
  return fmt::format("{}: {} ({}{}): {}", remark.what, remark.where.size(), fmt::join(shown, ", "),
                     remark.where.size() > kShown ? ", ..." : "", remark.instead);
}

}  // namespace orbs::importer
