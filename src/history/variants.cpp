#include "history/variants.h"

#include "history/number_changes.h"
#include "history/pair_runs.h"
#include "history/verdict_changes.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace orbs::history {

std::vector<RunComparison> compare_variants(const results::RunRecord& run) {
  std::vector<RunComparison> comparisons;
  std::map<std::string, std::string> first;  // variant of each entry
  for (const auto& renderer : run.renderers) {
    if (renderer.variant_of.empty()) continue;
    const auto [base, is_first] = first.try_emplace(renderer.variant_of, renderer.name);
    if (is_first) continue;
    const auto pair = pair_renderers(run, base->second, renderer.name);
    comparisons.push_back(
        compare_pairs(pair, verdict_changes(pair), {light_candidates(pair), error_candidates(pair)}));
    comparisons.back().before = base->second;
    comparisons.back().after = renderer.name;
  }
  return comparisons;
}

std::string variants_text(const std::vector<RunComparison>& comparisons) {
  constexpr std::size_t kMost = 8;
  std::string text;
  for (const auto& comparison : comparisons) {
    const auto& changes = comparison.changes;
    text += fmt::format("{} against {}: {} targets, {}\n", comparison.after, comparison.before,
                        comparison.targets,
                        changes.empty() ? "the same but for noise"
                                        : fmt::format("{} differences beyond noise", changes.size()));
    for (std::size_t i = 0; i < std::min(changes.size(), kMost); ++i)
      text += fmt::format("  {} {}: {}, {} against {}\n", changes[i].requirement,
                          changes[i].target.empty() ? "all together" : changes[i].target,
                          quantity_name(changes[i].quantity), changes[i].after, changes[i].before);
    if (changes.size() > kMost) text += fmt::format("  and {} more\n", changes.size() - kMost);
  }
  return text;
}

}  // namespace orbs::history
