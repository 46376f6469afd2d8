#include "studies/stability/study.h"

#include "adapters/export.h"
#include "base/error.h"
#include "base/files.h"
#include "base/local_time.h"
#include "base/text.h"
#include "image/colour.h"
#include "image/false_colour.h"
#include "image/image_io.h"
#include "results/study_kinds.h"
#include "run/host.h"
#include "run/renderer_version.h"
#include "studies/effects/paired_difference.h"
#include "studies/probe/scene.h"
#include "studies/stability/images.h"
#include "studies/stability/json.h"
#include "studies/stability/report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

struct StabilityMeasurement {
  const run::Plan& plan;
  const StabilityRequest& request;
  const StudyContext& context;
  StabilityRecord record;
};

void store(const StabilityMeasurement& study) {
  write_file(study.request.folder / results::kStability.file, stability_json(study.record));
}

const StabilityStep* find_step(const StabilityRecord& record, const StabilityStep& wanted) {
  for (const auto& step : record.steps)
    if (step.scene == wanted.scene && step.renderer == wanted.renderer && step.relation == wanted.relation &&
        (step.magnitude == wanted.magnitude || step.outcome == StepOutcome::NotApplicable))
      return &step;
  return nullptr;
}

std::string step_folder(const StabilityRecord& record, const StabilityStep& step) {
  return fmt::format("{}/{}/{}-{:g}", record.renderers[step.renderer].name, record.scenes[step.scene].name,
                     record.relations[step.relation].name, step.magnitude);
}

void judge(const StabilitySettings& settings,
           const StabilityRelation& relation,
           const PairedDifference& found,
           StabilityStep& step) {
  step.is_bit_equal = found.is_equal;
  step.mean = found.mean.value;
  step.mean_error = found.mean.standard_error;
  step.block = found.largest.value;
  step.block_error = found.largest.standard_error;
  step.block_x = found.x;
  step.block_y = found.y;
  step.pixels = found.pixels;
  const auto is_off = [](const RelativeDifference& one, double bound) {
    return one.confidence >= kSure && std::fabs(one.value) > bound;
  };
  const bool mean_is_off = is_off(found.mean, settings.mean_bound);
  const bool block_is_off = is_off(found.largest, settings.block_bound);
  step.confidence = mean_is_off ? found.mean.confidence : found.largest.confidence;
  // Four standard errors of that size would hide an error of one percent.
  constexpr double kMostNoise = 0.0025;
  if (mean_is_off || block_is_off) {
    step.outcome = StepOutcome::Breaks;
    step.reason = break_text(step);
  } else if (relation.of_scenes.is_exact && !found.is_equal) {
    step.outcome = StepOutcome::Breaks;
    step.reason = "the images differ within noise, but they must be equal to the bit";
    step.confidence = 1;
  } else if (relation.render == RenderChange::Precision && found.pixels > settings.pixels_bound) {
    step.outcome = StepOutcome::Breaks;
    step.reason = fmt::format("single pixels differ by {:.2g} % in the mean: rounding decides what they show",
                              100 * found.pixels);
    step.confidence = 1;
  } else if (found.mean.standard_error > kMostNoise) {
    step.outcome = StepOutcome::Inconclusive;
    step.reason = fmt::format("the standard error of the mean is {:.2g} %: more samples are needed",
                              100 * found.mean.standard_error);
  }
}

void keep_images(const StabilityMeasurement& study,
                 const std::vector<image::Image>& original,
                 const std::vector<image::Image>& changed,
                 StabilityStep& step) {
  step.images = "images/" + step_folder(study.record, step);
  const auto folder = study.request.folder / step.images;
  make_folder(folder);
  image::write_png(image::display_image(original.front()), folder / results::kOriginalImage);
  image::write_png(image::display_image(changed.front()), folder / results::kChangedImage);
  const auto difference = mean_difference(original, changed);
  image::write_png(
      image::false_colour(difference, image::ColourScale::Diverging, image::largest_magnitude(difference)),
      folder / results::kDifferenceImage);
}

// Fills in the outcome of one step. False when the user interrupts. `is_first_break`: no easier step broke.
bool measure_step(const StabilityMeasurement& study,
                  StabilityImages& images,
                  const scene::RelatedScenes& scenes,
                  bool is_first_break,
                  StabilityStep& step) {
  const auto& relation = study.request.relations[step.relation];
  const auto folder = study.request.folder / "scenes" / step_folder(study.record, step);
  try {
    const auto original = images.original(scenes.original, folder / "original");
    if (!original) return false;
    auto changed = images.render(scenes.changed, folder / "changed", relation.render);
    if (!changed) return false;
    for (auto& image : *changed) image = original_of(image, scenes.image);
    judge(study.request.settings, relation, paired_difference(*original, *changed), step);
    const bool is_condition_map = relation.render == RenderChange::Precision && !step.is_bit_equal;
    if (is_condition_map || (step.outcome == StepOutcome::Breaks && is_first_break))
      keep_images(study, *original, *changed, step);
  } catch (const InputError& e) {
    step.outcome = StepOutcome::NoImage;
    step.reason = clean_line(split(e.what(), '\n').front());
  }
  if (step.outcome == StepOutcome::Holds) remove_tree(folder);
  return true;
}

// Why the renderer has no such change of rendering; "" where it has.
std::string_view missing_change(const StabilityMeasurement& study, const StabilityStep& step) {
  const auto render = study.request.relations[step.relation].render;
  const auto& entry = study.plan.renderers[step.renderer].entry;
  const bool is_of_noise = render == RenderChange::Seed || render == RenderChange::TwoHalves;
  if (is_of_noise && entry.sampling.is_noise_free) return "the renderer has no random numbers";
  if (render == RenderChange::Precision && entry.command.double_precision.empty())
    return "the renderer's entry has no arguments for double_precision";
  return "";
}

void say_step(const StabilityMeasurement& study, const StabilityStep& step) {
  study.context.say(
      fmt::format("{:<10} {:<16} {:<18} {:>8.4g}  {}{}{}", study.record.renderers[step.renderer].name,
                  study.record.scenes[step.scene].name, study.record.relations[step.relation].name,
                  step.magnitude, json::to_text(step.outcome), step.reason.empty() ? "" : ": ", step.reason));
}

// The steps of one relation on one scene by one renderer. False when the user interrupts.
bool climb(StabilityMeasurement& study,
           StabilityImages& images,
           const scene::Scene& scene,
           StabilityStep step) {
  const auto& relation = study.request.relations[step.relation].of_scenes;
  int broken = 0;
  for (const double magnitude : relation.magnitudes) {
    step.magnitude = magnitude;
    StabilityStep made = step;
    if (const auto* earlier = find_step(study.record, step)) {
      made = *earlier;
    } else {
      const auto missing = missing_change(study, step);
      const auto related =
          missing.empty() ? relation.apply(scene, magnitude) : scene::Related{std::string(missing)};
      if (const auto* reason = std::get_if<std::string>(&related)) {
        // A sweep may end at what the scene format allows; that says nothing of the renderer.
        if (magnitude != relation.magnitudes.front()) return true;
        made.outcome = StepOutcome::NotApplicable;
        made.reason = *reason;
      } else if (!measure_step(study, images, std::get<scene::RelatedScenes>(related), broken == 0, made)) {
        return false;
      }
      study.record.steps.push_back(made);
      say_step(study, made);
      store(study);
    }
    if (made.outcome == StepOutcome::NotApplicable) return true;
    broken = made.outcome == StepOutcome::Breaks || made.outcome == StepOutcome::NoImage ? broken + 1 : 0;
    if (broken == 2) return true;
  }
  return true;
}

void describe(StabilityMeasurement& study) {
  auto& record = study.record;
  record.orbs_version = study.context.orbs_version;
  record.started = local_time_now();
  record.suite = study.plan.suite.name;
  record.settings = study.request.settings;
  record.host = run::this_host();
  for (const auto& chosen : study.plan.renderers)
    record.renderers.push_back(
        {chosen.entry.name, run::renderer_version(chosen, study.plan, {.say = study.context.say})});
  for (const auto& scene : study.plan.scenes) record.scenes.push_back({scene.name});
  for (const auto& relation : study.request.relations) {
    const auto& one = relation.of_scenes;
    record.relations.push_back({std::string(one.name), std::string(one.change), std::string(one.unit),
                                scene::is_sweep(one.magnitudes), one.is_exact});
  }
}

// An interrupted study goes on with the same scenes, renderers, relations and settings.
void check_earlier(const StabilityMeasurement& study) {
  StabilityMeasurement now{study.plan, study.request, study.context, {}};
  describe(now);
  const auto names = [](const auto& items) {
    std::vector<std::string> out;
    for (const auto& item : items) out.push_back(item.name);
    return out;
  };
  if (names(now.record.scenes) != names(study.record.scenes) ||
      names(now.record.renderers) != names(study.record.renderers) ||
      names(now.record.relations) != names(study.record.relations) ||
      !(now.record.settings == study.record.settings))
    throw InputError(
        "the study in this folder has other scenes, renderers, relations or settings; give the same options, "
        "or begin a new study");
}

// Why the renderer cannot render the scene at all; "" if it can.
std::string unsupported(const run::ChosenRenderer& renderer, const scene::Scene& scene) {
  const auto prepared = adapters::prepare_scene(renderer.entry, scene);
  const auto* reason = std::get_if<std::string>(&prepared);
  return reason == nullptr ? "" : *reason;
}

void leave_out(StabilityMeasurement& study,
               std::size_t scene,
               std::size_t renderer,
               const std::string& reason) {
  for (std::size_t relation = 0; relation < study.request.relations.size(); ++relation) {
    StabilityStep step{.scene = scene, .renderer = renderer, .relation = relation};
    step.magnitude = study.request.relations[relation].of_scenes.magnitudes.front();
    step.outcome = StepOutcome::NotApplicable;
    step.reason = fmt::format("the renderer cannot render the scene: {}", reason);
    if (find_step(study.record, step) == nullptr) study.record.steps.push_back(step);
  }
  store(study);
}

// False when the user interrupts.
bool measure_pair(StabilityMeasurement& study, std::size_t scene_index, std::size_t renderer_index) {
  const auto& renderer = study.plan.renderers[renderer_index];
  auto scene = *study.plan.scenes[scene_index].scene;
  fit_camera(scene.camera, study.request.settings.size_px);
  if (const auto reason = unsupported(renderer, scene); !reason.empty()) {
    study.context.say(fmt::format("{:<10} {:<16} not rendered: {}", renderer.entry.name,
                                  study.plan.scenes[scene_index].name, reason));
    leave_out(study, scene_index, renderer_index, reason);
    return true;
  }
  StabilityImages images(study.plan, renderer, study.request.settings, study.context);
  for (std::size_t relation = 0; relation < study.request.relations.size(); ++relation) {
    StabilityStep step;
    step.scene = scene_index;
    step.renderer = renderer_index;
    step.relation = relation;
    if (!climb(study, images, scene, step)) return false;
  }
  return true;
}

}  // namespace

StabilityRecord measure_stability(const run::Plan& plan,
                                  const StabilityRequest& request,
                                  StabilityRecord record,
                                  const StudyContext& context) {
  StabilityMeasurement study{plan, request, context, std::move(record)};
  if (study.record.renderers.empty())
    describe(study);
  else
    check_earlier(study);
  study.record.is_finished = false;
  bool goes_on = true;
  for (std::size_t renderer = 0; renderer < plan.renderers.size() && goes_on; ++renderer)
    for (std::size_t scene = 0; scene < plan.scenes.size() && goes_on; ++scene)
      goes_on = measure_pair(study, scene, renderer);
  study.record.is_finished = goes_on;
  store(study);
  return study.record;
}

}  // namespace orbs::studies
