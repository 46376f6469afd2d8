#include "page/fixture_stability.h"

#include "base/files.h"
#include "image/image_io.h"
#include "results/study_kinds.h"
#include "studies/stability/json.h"
#include "studies/stability/report.h"

namespace orbs::page_tests {

namespace {

using studies::StabilityStep;

constexpr std::size_t kBox = 0, kBlock = 1, kOrbs = 0, kCycles = 1;
constexpr std::size_t kTranslate = 0, kRotate = 1, kGround = 2;

StabilityStep step_of(std::size_t scene, std::size_t renderer, std::size_t relation, double magnitude) {
  StabilityStep step;
  step.scene = scene;
  step.renderer = renderer;
  step.relation = relation;
  step.magnitude = magnitude;
  return step;
}

StabilityStep broken_step(double magnitude) {
  auto step = step_of(kBlock, kCycles, kTranslate, magnitude);
  step.outcome = studies::StepOutcome::Breaks;
  step.mean = -0.012;
  step.mean_error = 1e-4;
  step.block = -0.17;
  step.block_error = 2e-3;
  step.confidence = 1;
  step.reason = studies::break_text(step);
  return step;
}

void add_sweeps(studies::StabilityRecord& record) {
  for (const auto scene : {kBox, kBlock})
    for (const double magnitude : {1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9})
      record.steps.push_back(step_of(scene, kOrbs, kTranslate, magnitude));
  for (const double magnitude : {1e1, 1e2, 1e3, 1e4})
    record.steps.push_back(step_of(kBox, kCycles, kTranslate, magnitude));
  record.steps.push_back(step_of(kBox, kCycles, kTranslate, 1e5));
  record.steps.back().outcome = studies::StepOutcome::NoImage;
  record.steps.back().reason = "renderer 'cycles' crashed <b>here</b>";
  for (const double magnitude : {1e1, 1e2, 1e3})
    record.steps.push_back(step_of(kBlock, kCycles, kTranslate, magnitude));
  record.steps.push_back(broken_step(1e4));
  record.steps.back().images = "breaks/cycles/block/translate_matrix-10000";
  record.steps.push_back(broken_step(1e5));
}

}  // namespace

void write_stability_study(const std::filesystem::path& folder) {
  studies::StabilityRecord record;
  record.orbs_version = "0.1.0";
  record.started = "2026-01-02T03:04:05";
  record.is_finished = true;
  record.suite = "orbs";
  record.host.name = "host";
  record.host.cores = 2;
  record.renderers = {{"orbs", "orbs-tracer 0.1.0"}, {"cycles", "Blender 3.4.1"}};
  record.scenes = {{"box"}, {"block"}};
  record.relations = {{"translate_matrix", "the world moved, by its matrices", "m", true, false},
                      {"rotate", "world and camera turned", "", false, false},
                      {"ground", "a larger ground, times the other objects", "", true, false}};
  add_sweeps(record);
  for (const auto renderer : {kOrbs, kCycles})
    for (const auto scene : {kBox, kBlock}) {
      record.steps.push_back(step_of(scene, renderer, kRotate, 1));
      record.steps.back().is_bit_equal = renderer == kOrbs;
      record.steps.push_back(step_of(scene, renderer, kGround, 1e3));
      record.steps.back().outcome = studies::StepOutcome::NotApplicable;
      record.steps.back().reason = "there is no ground";
    }
  write_file(folder / results::kStability.file, studies::stability_json(record));
  const auto images = folder / "breaks/cycles/block/translate_matrix-10000";
  make_folder(images);
  for (const char* name : {results::kOriginalImage, results::kChangedImage, results::kDifferenceImage})
    image::write_png(image::make_image(8, 8, {"R", "G", "B"}), images / name);
}

}  // namespace orbs::page_tests
