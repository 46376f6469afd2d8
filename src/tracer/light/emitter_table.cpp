#include "tracer/light/emitter_table.h"

#include <algorithm>
#include <numeric>

namespace orbs::tracer {

void EmitterTable::build(const std::vector<float>& powers,
                         SurfaceEmitters surfaces,
                         std::size_t light_count) {
  light_count_ = light_count;
  surfaces_ = std::move(surfaces);
  const double total = std::accumulate(powers.begin(), powers.end(), 0.0);
  probability_.clear();
  if (total <= 0) return;
  std::vector<double> scaled;
  for (const float power : powers) {
    probability_.push_back(static_cast<float>(power / total));
    scaled.push_back(power / total * static_cast<double>(powers.size()));
  }
  keep_.assign(powers.size(), 1.0);
  alias_.resize(powers.size());
  std::iota(alias_.begin(), alias_.end(), 0U);
  std::vector<std::uint32_t> small;
  std::vector<std::uint32_t> large;
  for (std::uint32_t i = 0; i < scaled.size(); ++i) (scaled[i] < 1 ? small : large).push_back(i);
  while (!small.empty() && !large.empty()) {
    const std::uint32_t s = small.back();
    const std::uint32_t l = large.back();
    small.pop_back();
    keep_[s] = scaled[s];
    alias_[s] = l;
    scaled[l] -= 1 - scaled[s];
    if (scaled[l] >= 1) continue;
    large.pop_back();
    small.push_back(l);
  }
}

std::size_t EmitterTable::pick(double u) const {
  const double at = u * static_cast<double>(probability_.size());
  const auto slot = std::min(static_cast<std::size_t>(at), probability_.size() - 1);
  return at - static_cast<double>(slot) < keep_[slot] ? slot : alias_[slot];
}

}  // namespace orbs::tracer
