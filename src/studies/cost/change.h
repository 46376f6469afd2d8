#pragma once

#include "studies/cost/numbers.h"

#include <string>
#include <vector>

/// Two studies of cost of the same scenes, such as yesterday's tracer and today's: by what factor the time to
/// an error has changed. Like everything that follows from renders it is computed here alone; the terminal
/// and the page show it.
namespace orbs::studies {

/// In how many comparisons of two studies of equal programs any time is called changed.
inline constexpr double kFalseChanges = 0.01;

/// One renderer on one scene in both studies.
struct SceneChange {
  std::string target;
  std::string renderer;
  ErrorTarget error;
  Interval before, after;   // CPU seconds to the error
  Interval time_ratio;      // of the later over the earlier
  double by_chance = 1;     // the probability that equal programs differ so much
  bool is_changed = false;  // beyond chance among all tests of its error
};

template <class Visitor, json::RecordOf<SceneChange> Record>
void fields(Visitor& visit, Record& change) {
  visit("target", change.target);
  visit("renderer", change.renderer);
  fields(visit, change.error);
  visit("before", change.before);
  visit("after", change.after);
  visit("time_ratio", change.time_ratio);
  visit("by_chance", change.by_chance);
  visit("changed", change.is_changed);
}

/// One renderer at one error over all scenes.
struct MeanChange {
  std::string renderer;
  ErrorTarget error;
  int scenes = 0;       // where both times are known
  Interval time_ratio;  // geometric mean over them of the later time over the earlier
  double by_chance = 1;
  bool is_changed = false;  // beyond chance among all renderers
  /// The same over that of the renderers whose versions are the same in both studies: what the machine does
  /// to all of them falls out. Nothing where there is none.
  std::optional<Interval> ratio_to_unchanged;
};

template <class Visitor, json::RecordOf<MeanChange> Record>
void fields(Visitor& visit, Record& change) {
  visit("renderer", change.renderer);
  fields(visit, change.error);
  visit("scenes", change.scenes);
  visit("time_ratio", change.time_ratio);
  visit("by_chance", change.by_chance);
  visit("changed", change.is_changed);
  visit.nullable("ratio_to_unchanged", change.ratio_to_unchanged);
}

/// A renderer that both studies have.
struct RendererInBoth {
  std::string name;
  std::string version_before, version_after;
  bool is_unchanged = false;  // the versions are known and the same
};

template <class Visitor, json::RecordOf<RendererInBoth> Record>
void fields(Visitor& visit, Record& renderer) {
  visit("name", renderer.name);
  visit("version_before", renderer.version_before);
  visit("version_after", renderer.version_after);
  visit("unchanged", renderer.is_unchanged);
}

struct CostChanges {
  std::string before, after;  // when they began
  ErrorTarget main_error;     // that the later study was made for
  std::vector<RendererInBoth> renderers;
  std::vector<MeanChange> means;    // by error and renderer
  std::vector<SceneChange> scenes;  // by error, the most changed first
  std::vector<std::string> notes;   // what was not compared, and what makes the factors doubtful
};

template <class Visitor, json::RecordOf<CostChanges> Record>
void fields(Visitor& visit, Record& changes) {
  visit("before", changes.before);
  visit("after", changes.after);
  visit("main_metric", kCostMetrics.at(changes.main_error.metric).name);
  visit("main_level", changes.main_error.level);
  visit("renderers", changes.renderers);
  visit("means", changes.means);
  visit("scenes", changes.scenes);
  visit("notes", changes.notes);
}

/// InputError if the studies are of different suites or sizes, were made on different machines, or have no
/// renderer on the same target.
CostChanges cost_changes(const CostRecord& before, const CostRecord& after);

/// 1 if a time is longer beyond chance at the main error, else 0.
int exit_status(const CostChanges& changes);

}  // namespace orbs::studies
