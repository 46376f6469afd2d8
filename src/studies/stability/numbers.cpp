#include "studies/stability/numbers.h"

#include <algorithm>
#include <cmath>

namespace orbs::studies {

namespace {

// Distance of a magnitude from one, in decades: the same for a sweep upwards and one downwards.
double decades_of(double magnitude) { return std::fabs(std::log10(magnitude)); }

bool is_break(const StabilityStep& step) {
  return step.outcome == StepOutcome::Breaks || step.outcome == StepOutcome::NoImage;
}

// What the steps of one sweep say, which follow each other in the record from the easiest to the hardest.
struct MagnitudeSweep {
  std::optional<double> held_to;
  std::optional<std::size_t> first_break;
  bool is_measured = false;
  bool is_bit_equal = true;
  bool is_inconclusive = false;
};

MagnitudeSweep sweep_of(const StabilityRecord& record, std::size_t scene, const StabilityCell& cell) {
  MagnitudeSweep sweep;
  for (std::size_t i = 0; i < record.steps.size(); ++i) {
    const auto& step = record.steps[i];
    if (step.scene != scene || step.renderer != cell.renderer || step.relation != cell.relation ||
        step.outcome == StepOutcome::NotApplicable)
      continue;
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
    cell.first_break = FirstBreak{step.magnitude, record.scenes[step.scene].name, step.outcome,
                                  step.confidence, step.reason};
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

bool all_hold(const StabilityRecord& record) {
  const auto is = [&](StepOutcome outcome) {
    return std::any_of(record.steps.begin(), record.steps.end(),
                       [&](const auto& step) { return step.outcome == outcome; });
  };
  return is(StepOutcome::Holds) && !is(StepOutcome::Breaks) && !is(StepOutcome::NoImage);
}

}  // namespace orbs::studies
