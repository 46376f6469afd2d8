#pragma once

#include "json/fields.h"
#include "results/host_record.h"

#include <cstddef>
#include <string>
#include <vector>

/// What a study of stability measured. Each member is also listed in the struct's fields(), see
/// results/fields.h, so that a study is stored and resumed.
namespace orbs::studies {

struct StabilitySettings {
  int size_px = 48;  // longer side of the images
  int spp = 64;
  int seeds = 2;
  int threads = 1;
  double mean_bound = 1e-3;    // a relation is broken where the mean is off by more than this for sure
  double block_bound = 2e-2;   // or the mean of a block
  double pixels_bound = 1e-2;  // or, by double precision, single pixels by more than this in the mean
  bool operator==(const StabilitySettings&) const = default;
};

template <class Visitor, json::RecordOf<StabilitySettings> Record>
void fields(Visitor& visit, Record& settings) {
  visit("size_px", settings.size_px, {.range = {.min = 1}});
  visit("spp", settings.spp, {.range = {.min = 1}});
  visit("seeds", settings.seeds, {.range = {.min = 1}});
  visit("threads", settings.threads, {.range = {.min = 1}});
  visit("mean_bound", settings.mean_bound);
  visit("block_bound", settings.block_bound);
  visit("pixels_bound", settings.pixels_bound);
}

struct StabilityRenderer {
  std::string name;
  std::string version;
};

template <class Visitor, json::RecordOf<StabilityRenderer> Record>
void fields(Visitor& visit, Record& renderer) {
  visit.required("name", renderer.name);
  visit("version", renderer.version);
}

struct StabilityScene {
  std::string name;
};

template <class Visitor, json::RecordOf<StabilityScene> Record>
void fields(Visitor& visit, Record& scene) {
  visit.required("name", scene.name);
}

/// A relation that the study measured, see relation.h.
struct StabilityRelationRecord {
  std::string name;
  std::string change;
  std::string unit;
  bool is_sweep = false;
  bool is_exact = false;
};

template <class Visitor, json::RecordOf<StabilityRelationRecord> Record>
void fields(Visitor& visit, Record& relation) {
  visit.required("name", relation.name);
  visit("change", relation.change);
  visit("unit", relation.unit);
  visit("is_sweep", relation.is_sweep);
  visit("is_exact", relation.is_exact);
}

/// The relation of single and double precision, see RenderChange::Precision.
inline constexpr const char* kPrecisionRelation = "precision";

enum class StepOutcome { Holds, Breaks, NoImage, Inconclusive, NotApplicable };

inline constexpr auto names(StepOutcome) {
  return std::array{json::Named{StepOutcome::Holds, "holds"}, json::Named{StepOutcome::Breaks, "breaks"},
                    json::Named{StepOutcome::NoImage, "no image"},
                    json::Named{StepOutcome::Inconclusive, "inconclusive"},
                    json::Named{StepOutcome::NotApplicable, "not applicable"}};
}

/// One relation at one magnitude, on one scene, by one renderer.
struct StabilityStep {
  std::size_t scene = 0;
  std::size_t renderer = 0;
  std::size_t relation = 0;
  double magnitude = 1;
  StepOutcome outcome = StepOutcome::Holds;
  std::string reason = {};    // of an outcome other than Holds
  bool is_bit_equal = false;  // all pairs of images are
  double mean = 0;            // relative to the mean of the original image
  double mean_error = 0;      // standard error
  double block = 0;           // of the block that differs most for sure, relative to its mean
  double block_error = 0;
  int block_x = 0;
  int block_y = 0;
  double pixels = 0;      // mean of the absolute differences of single pixels, relative to the image's mean
  double confidence = 0;  // that the greater of mean and block is no noise
  std::string images =
      {};  // folder of images relative to the study's: of first breaks and precision; else ""
};

template <class Visitor, json::RecordOf<StabilityStep> Record>
void fields(Visitor& visit, Record& step) {
  visit.required("scene", step.scene);
  visit.required("renderer", step.renderer);
  visit.required("relation", step.relation);
  visit("magnitude", step.magnitude);
  visit.required("outcome", step.outcome);
  visit("reason", step.reason);
  visit("is_bit_equal", step.is_bit_equal);
  visit("mean", step.mean);
  visit("mean_error", step.mean_error);
  visit("block", step.block);
  visit("block_error", step.block_error);
  visit("block_x", step.block_x);
  visit("block_y", step.block_y);
  visit("pixels", step.pixels);
  visit("confidence", step.confidence);
  visit.inside_folder("images", step.images);
}

struct StabilityRecord {
  std::string orbs_version;
  std::string started;  // local time, ISO 8601
  bool is_finished = false;
  std::string suite;
  StabilitySettings settings;
  results::Host host;
  std::vector<StabilityRenderer> renderers;
  std::vector<StabilityScene> scenes;
  std::vector<StabilityRelationRecord> relations;
  std::vector<StabilityStep> steps;
};

template <class Visitor, json::RecordOf<StabilityRecord> Record>
void fields(Visitor& visit, Record& record) {
  visit("orbs_version", record.orbs_version);
  visit("started", record.started);
  visit("finished", record.is_finished);
  visit("suite", record.suite);
  visit("settings", record.settings);
  visit("host", record.host);
  visit("renderers", record.renderers);
  visit("scenes", record.scenes);
  visit("relations", record.relations);
  visit("steps", record.steps);
}

}  // namespace orbs::studies
