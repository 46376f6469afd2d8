#pragma once

#include "json/fields.h"
#include "results/record.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// What a stranger reads first of a renderer: whether it is right, what is wrong and where, and what its
/// noise costs. The same sentences stand on the page, at the head of the one-file report and at the end of
/// the terminal's output.
namespace orbs::report {

/// Targets of one renderer with the same trouble.
struct TroubleGroup {
  std::string state;  // "fail", "known", "inconclusive", "pass with remarks", ...
  std::string what;   // the diagnosis, else why the failure is known, else the first part of the reason
  bool is_diagnosis = false;         // a usual fault explains the images
  std::vector<std::size_t> targets;  // indices into the targets of the run
};

template <class Visitor, json::RecordOf<TroubleGroup> Record>
void fields(Visitor& visit, Record& group) {
  visit("state", group.state);
  visit("what", group.what);
  visit("diagnosis", group.is_diagnosis);
  visit("targets", group.targets);
}

/// CPU time for equal noise over that of another renderer: the geometric mean of CPU seconds times the
/// squared noise over the targets that both rendered in looks, with the 95 % interval of its scatter over
/// them.
struct NoiseCost {
  std::string than;  // the other renderer
  double ratio = 1;
  double low = 0;
  double high = 0;
  std::size_t targets = 0;
  /// "takes 3.1 times the CPU time of orbs for equal noise (2.4 to 4.1, 34 targets)"
  std::string sentence{};
};

template <class Visitor, json::RecordOf<NoiseCost> Record>
void fields(Visitor& visit, Record& cost) {
  visit("than", cost.than);
  visit("ratio", cost.ratio);
  visit("low", cost.low);
  visit("high", cost.high);
  visit("targets", cost.targets);
  visit("sentence", cost.sentence);
}

struct ReportCard {
  std::string renderer;
  std::string standing;              // "right", "wrong", "known", "undecided", "open" (nothing judged yet)
  std::string sentence;              // "wrong in 7 of 48 targets: 6 of them textures are not decoded (sRGB)"
  std::vector<TroubleGroup> groups;  // the worst and largest first
  std::optional<NoiseCost> cost;     // nothing for the renderer that the others are compared with
  std::string clock;                 // what is said where its times contradict each other, see clocks_text
};

template <class Visitor, json::RecordOf<ReportCard> Record>
void fields(Visitor& visit, Record& card) {
  visit("renderer", card.renderer);
  visit("standing", card.standing);
  visit("sentence", card.sentence);
  visit("groups", card.groups);
  visit("cost", card.cost);
  visit("clock", card.clock);
}

/// One card for each renderer that has declared targets, in the order of the run.
std::vector<ReportCard> report_cards(const results::RunRecord& run);

}  // namespace orbs::report
