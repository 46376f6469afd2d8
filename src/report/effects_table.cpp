#include "report/effects_table.h"

#include "base/text_table.h"

#include <fmt/format.h>

namespace orbs::report {

namespace {

using results::EffectRecord;
using Rows = std::vector<TableRow>;

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

}  // namespace

std::string effects_text(const std::vector<results::SceneRecord>& scenes) {
  Rows rows;
  for (const auto& scene : scenes) {
    rows.push_back({scene.name, fmt::format("{}; {}", scene.transport, scene.features)});
    add_rows(scene.called_for, "", rows);
    add_rows(scene.not_called_for, "not ", rows);
  }
  return text_table(rows);
}

}  // namespace orbs::report
