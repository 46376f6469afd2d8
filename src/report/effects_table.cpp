#include "report/effects_table.h"

#include "base/text_table.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::report {

namespace {

using results::EffectRecord;
using Rows = std::vector<TableRow>;

constexpr int kUnlimited = 1'000'000;  // a trace depth without a limit

std::string with_hyphens(std::string text) {
  std::replace(text.begin(), text.end(), ' ', '-');
  return text;
}

// The findings of one effect are adjacent; the first one stands for all of them.
void add_rows(const std::vector<EffectRecord>& effects, const char* mark, Rows& rows) {
  for (std::size_t i = 0; i < effects.size();) {
    std::size_t next = i + 1;
    while (next < effects.size() && effects[next].effect == effects[i].effect) ++next;
    const auto others = next - i - 1;
    rows.push_back({fmt::format("  {}{}", mark, effects[i].effect),
                    fmt::format("{} {}{}", effects[i].subject, effects[i].reason,
                                others == 0 ? "" : fmt::format(" (and {} more)", others))});
    i = next;
  }
}

// What a renderer can switch: by these words in its scene file and in {effects} of its command.
void add_switches(const results::SceneRecord& scene, Rows& rows) {
  std::vector<std::string> words;
  for (const auto& one : scene.switches) words.push_back(one.effect);
  rows.push_back({"  can switch", words.empty() ? "nothing: all that is seen emits"
                                                : fmt::format("{}", fmt::join(words, ","))});
  for (const auto& one : scene.switches)
    if (std::none_of(scene.called_for.begin(), scene.called_for.end(),
                     [&](const EffectRecord& effect) { return with_hyphens(effect.effect) == one.effect; }))
      rows.push_back({fmt::format("  {}", one.effect), one.subject});
  if (scene.bounces > 0)
    rows.push_back({"  bounces", scene.bounces >= kUnlimited
                                     ? "any number can matter"
                                     : fmt::format("up to {} can matter", scene.bounces)});
}

}  // namespace

std::string effects_text(const std::vector<results::SceneRecord>& scenes) {
  Rows rows;
  for (const auto& scene : scenes) {
    rows.push_back({scene.name, fmt::format("{}; {}", scene.transport, scene.features)});
    add_switches(scene, rows);
    add_rows(scene.called_for, "", rows);
    add_rows(scene.not_called_for, "not ", rows);
  }
  return text_table(rows);
}

}  // namespace orbs::report
