#include "studies/stability/numbers.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

template <typename Items>
std::vector<std::string> names_of(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

// Distance of a magnitude from one, in decades: the same for a sweep upwards and one downwards.
double decades_of(double magnitude) { return std::fabs(std::log10(magnitude)); }

bool is_break(const StabilityStep& step) {
  return step.outcome == StepOutcome::Breaks || step.outcome == StepOutcome::NoImage;
}

// What the steps of one sweep say, which follow each other in the record from the easiest to the hardest.
struct MagnitudeSweep {
  std::optional<double> held_to;
  std::optional<std::size_t> first_break;
  std::optional<std::size_t> not_applicable;
  bool is_measured = false;
  bool is_bit_equal = true;
  bool is_inconclusive = false;
};

MagnitudeSweep sweep_of(const StabilityRecord& record, std::size_t scene, const StabilityCell& cell) {
  MagnitudeSweep sweep;
  for (std::size_t i = 0; i < record.steps.size(); ++i) {
    const auto& step = record.steps[i];
    if (step.scene != scene || step.renderer != cell.renderer || step.relation != cell.relation) continue;
    if (step.outcome == StepOutcome::NotApplicable) {
      sweep.not_applicable = i;
      continue;
    }
    sweep.is_measured = true;
    sweep.is_bit_equal = sweep.is_bit_equal && step.is_bit_equal;
    if (step.outcome == StepOutcome::Inconclusive) sweep.is_inconclusive = true;
    if (is_break(step) && !sweep.first_break) sweep.first_break = i;
    if (step.outcome == StepOutcome::Holds && !sweep.first_break && !sweep.is_inconclusive)
      sweep.held_to = step.magnitude;
  }
  return sweep;
}

void add(const StabilityRecord& record, const MagnitudeSweep& sweep, StabilityCell& cell) {
  const bool is_sweep = record.relations[cell.relation].is_sweep;
  cell.inconclusive += sweep.is_inconclusive && !sweep.first_break ? 1 : 0;
  const double held = sweep.held_to ? decades_of(*sweep.held_to) : 0;
  if (is_sweep && (!cell.decades || held < *cell.decades)) {
    cell.decades = held;
    cell.held_to = sweep.held_to;
  }
  if (!sweep.first_break) return;
  const auto& step = record.steps[*sweep.first_break];
  if (!cell.first_break || decades_of(step.magnitude) < decades_of(cell.first_break->magnitude))
    cell.first_break =
        FirstBreak{step.magnitude, record.scenes[step.scene].name, step.outcome, step.confidence, step.reason,
                   step.images};
}

}  // namespace

std::vector<StabilityCell> stability_cells(const StabilityRecord& record) {
  std::vector<StabilityCell> cells;
  for (std::size_t relation = 0; relation < record.relations.size(); ++relation)
    for (std::size_t renderer = 0; renderer < record.renderers.size(); ++renderer) {
      StabilityCell cell;
      cell.relation = relation;
      cell.renderer = renderer;
      cell.relation_name = record.relations[relation].name;
      cell.renderer_name = record.renderers[renderer].name;
      cell.is_bit_equal = true;
      for (std::size_t scene = 0; scene < record.scenes.size(); ++scene) {
        const auto sweep = sweep_of(record, scene, cell);
        if (sweep.not_applicable && ++cell.not_applicable == 1)
          cell.why_not_applicable = record.steps[*sweep.not_applicable].reason;
        if (!sweep.is_measured) continue;
        ++cell.scenes;
        cell.is_bit_equal = cell.is_bit_equal && sweep.is_bit_equal;
        add(record, sweep, cell);
      }
      cell.is_bit_equal = cell.is_bit_equal && cell.scenes > 0;
      cells.push_back(cell);
    }
  return cells;
}

StabilityRecord joined(const std::vector<StabilityRecord>& records) {
  StabilityRecord all = records.at(0);
  for (std::size_t i = 1; i < records.size(); ++i) {
    const auto& more = records[i];
    const auto first = all.renderers.size();
    if (names_of(more.scenes) != names_of(all.scenes) ||
        names_of(more.relations) != names_of(all.relations) || !(more.settings == all.settings))
      throw InputError(
          "the studies have other scenes, relations or settings, so that they are no one table; show them one by "
          "one");
    for (const auto& renderer : more.renderers) {
      const auto known = names_of(all.renderers);
      if (std::find(known.begin(), known.end(), renderer.name) != known.end())
        throw InputError(fmt::format("renderer '{}' is in two of the studies", renderer.name));
      all.renderers.push_back(renderer);
    }
    for (auto step : more.steps) {
      step.renderer += first;
      all.steps.push_back(std::move(step));
    }
    all.is_finished = all.is_finished && more.is_finished;
  }
  return all;
}

bool all_hold(const StabilityRecord& record) {
  const auto is = [&](StepOutcome outcome) {
    return std::any_of(record.steps.begin(), record.steps.end(),
                       [&](const auto& step) { return step.outcome == outcome; });
  };
  return is(StepOutcome::Holds) && !is(StepOutcome::Breaks) && !is(StepOutcome::NoImage);
}

}  // namespace orbs::studies
