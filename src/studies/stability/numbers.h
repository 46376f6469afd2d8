#pragma once

#include "studies/stability/record.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace orbs::studies {

/// The easiest step of a cell that broke.
struct FirstBreak {
  double magnitude = 1;
  std::string scene;
  StepOutcome outcome = StepOutcome::Breaks;
  double confidence = 0;
  std::string reason;
  std::string images = {};  // as those of the step
};

template <class Visitor, json::RecordOf<FirstBreak> Record>
void fields(Visitor& visit, Record& first) {
  visit("magnitude", first.magnitude);
  visit("scene", first.scene);
  visit("outcome", first.outcome);
  visit("confidence", first.confidence);
  visit("reason", first.reason);
  visit("images", first.images);
}

/// How far one renderer follows one relation, over all scenes.
struct StabilityCell {
  std::size_t relation = 0;  // index of the record's, with its name
  std::size_t renderer = 0;
  std::string relation_name;
  std::string renderer_name;
  int scenes = 0;          // on which it was measured
  int not_applicable = 0;  // scenes that have nothing to change, or that the renderer cannot render
  std::string why_not_applicable = {};  // of the first of them
  std::optional<double> held_to;        // of a sweep: the magnitude up to which it held on all of them
  std::optional<double> decades;        // of a sweep: |log10| of that; 0 if the first step broke
  std::optional<FirstBreak> first_break;
  bool is_bit_equal = false;  // all steps of all scenes are
  int inconclusive = 0;       // scenes whose noise hides what happens
};

template <class Visitor, json::RecordOf<StabilityCell> Record>
void fields(Visitor& visit, Record& cell) {
  visit("relation", cell.relation_name);
  visit("renderer", cell.renderer_name);
  visit("scenes", cell.scenes);
  visit("not_applicable", cell.not_applicable);
  visit("why_not_applicable", cell.why_not_applicable);
  visit("bit_equal", cell.is_bit_equal);
  visit("inconclusive", cell.inconclusive);
  visit("held_to", cell.held_to);
  visit("decades", cell.decades);
  visit("first_break", cell.first_break);
}

/// One cell for each relation and renderer, by relation and then by renderer.
std::vector<StabilityCell> stability_cells(const StabilityRecord& record);

/// The studies as one, with the renderers of all. InputError when they differ in scenes, relations or
/// settings, or a renderer is in two of them.
StabilityRecord joined(const std::vector<StabilityRecord>& records);

/// True if no step broke and something was measured.
bool all_hold(const StabilityRecord& record);

}  // namespace orbs::studies
