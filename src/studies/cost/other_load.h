#pragma once

#include "studies/cost/record.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Renders beside which other work went on: their times are not those of the renderer alone.
namespace orbs::studies {

/// The share of the time of all processors that others may take. An idle system takes about 1 %, and the
/// scatter of a renderer's times between seeds is about 3 %: what takes less than 5 % of the machine cannot
/// take more of its memory bandwidth and clock than that scatter hides by much, and what takes more can.
inline constexpr double kMostOtherShare = 0.05;

/// How often a disturbed render is repeated before it counts as one. On a machine that stays in use repeats
/// only take time.
inline constexpr int kMostRepeats = 2;

/// False where it is not known what others took.
bool is_disturbed(const CostRender& render);

/// Makes a render, and again while it is disturbed, up to `most_repeats` times. The last attempt, which may
/// be disturbed; nothing when `make` gives nothing.
std::optional<CostRender> undisturbed_render(const std::function<std::optional<CostRender>()>& make,
                                             int most_repeats = kMostRepeats);

/// Those that no other work disturbed, or all where it disturbed each: a number that is marked says more than
/// none.
std::vector<const CostRender*> that_count(std::vector<const CostRender*> renders);

/// What other work did to a study.
struct OtherLoad {
  int renders = 0;
  int repeats = 0;
  int left_out = 0;  // disturbed, of a setting that has renders which are not
  int marked = 0;    // disturbed, of a setting that has no other: they count
  int unknown = 0;   // renders of which it is not known
};

template <class Visitor, json::RecordOf<OtherLoad> Record>
void fields(Visitor& visit, Record& load) {
  visit("renders", load.renders);
  visit("repeats", load.repeats);
  visit("left_out", load.left_out);
  visit("marked", load.marked);
  visit("unknown", load.unknown);
}

OtherLoad other_load_of(const CostRecord& record);

/// One line for the terminal and the report.
std::string other_load_text(const OtherLoad& load);

}  // namespace orbs::studies
