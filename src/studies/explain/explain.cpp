#include "studies/explain/explain.h"

#include "adapters/job.h"
#include "base/error.h"
#include "base/files.h"
#include "judge/fault_fit.h"
#include "judge/judge.h"
#include "judge/reference.h"
#include "scene/render_fault.h"
#include "studies/qualify/images.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::studies {

namespace {

// As judge::diagnosed: most of what is no noise, and no chance.
constexpr double kLeastShare = 0.9;
constexpr double kDeviations = 6;

const run::PlannedScene* scene_named(const run::Plan& plan, const std::string& name) {
  const auto found = std::find_if(plan.scenes.begin(), plan.scenes.end(),
                                  [&](const auto& scene) { return scene.name == name; });
  return found == plan.scenes.end() ? nullptr : &*found;
}

const registry::Case* case_named(const run::Plan& plan, const std::string& name) {
  const auto found =
      std::find_if(plan.cases.begin(), plan.cases.end(), [&](const auto& one) { return one.name == name; });
  return found == plan.cases.end() ? nullptr : &*found;
}

// The share of the error that the mistake explains; nothing where it explains too little, or by chance.
std::optional<double> explained_share(const judge::FitSamples& samples, const image::Image& like) {
  const Rectangle all{0, 0, samples.result.width, samples.result.height};
  const auto fit = judge::fit_of(samples, like, all);
  const auto rest = judge::unexplained_by(samples, like, all, false);
  const double explained = fit.before - fit.after;
  const double share = explained / (explained + rest.squared);
  if (!(explained > 0) || share < kLeastShare || explained < kDeviations * fit.standard_error)
    return std::nullopt;
  return share;
}

Explanation explained(const run::Plan& plan,
                      const results::RunRecord& run,
                      const results::TargetRecord& target,
                      const std::vector<RenderedMutant>& mistakes) {
  Explanation out{.renderer = target.renderer, .case_name = target.case_name, .target = target.target};
  const registry::Case& one_case = *case_named(plan, target.case_name);
  const auto reference =
      judge::load_reference(one_case, target.target, plan.suite.references, plan.reference_hashes, {},
                            registry::reduced_size(plan.settings));
  if (!reference.image) throw InputError(reference.problem);
  const auto result = control_image(run, target.renderer, target.case_name, target.target);
  if (result.width != reference.image->width || result.height != reference.image->height)
    throw InputError("its image has another size than the reference");
  const auto samples =
      judge::fit_samples(image::select_rgb(result, ""), image::select_rgb(*reference.image, ""),
                         judge::mask_of(one_case, target.target));
  for (const auto& mistake : mistakes) {
    out.tried.push_back(mistake.name);
    const auto share = explained_share(samples, image::select_rgb(mistake.image, ""));
    if (!share || *share <= out.share) continue;
    out.share = *share;
    out.fault = mistake.name;
  }
  return out;
}

bool is_wanted(const run::Plan& plan, const ExplainSettings& settings, const results::TargetRecord& target) {
  const auto& names = settings.renderers;
  return target.verdict == results::Verdict::Fail && case_named(plan, target.case_name) != nullptr &&
         scene_named(plan, target.target) != nullptr &&
         (names.empty() || std::find(names.begin(), names.end(), target.renderer) != names.end());
}

}  // namespace

std::vector<Explanation> explain(const run::Plan& plan,
                                 const results::RunRecord& run,
                                 const ExplainSettings& settings,
                                 const StudyContext& context) {
  const ScratchFolder scratch("orbs-explain");
  std::map<std::string, std::vector<RenderedMutant>> mistakes;
  std::vector<Explanation> out;
  for (const auto& target : run.targets) {
    if (!is_wanted(plan, settings, target)) continue;
    const auto& scene = *scene_named(plan, target.target);
    if (!mistakes.contains(scene.name)) {
      const int spp = adapters::scaled_spp(scene.spp, 1, settings.spp_scale);
      auto made = with_each_fault(plan, scene, spp, scratch.path(), context.stop);
      if (!made) return out;
      context.say(fmt::format("{}: rendered with {} mistakes", scene.name, made->size()));
      mistakes[scene.name] = std::move(*made);
    }
    try {
      out.push_back(explained(plan, run, target, mistakes[scene.name]));
    } catch (const InputError& e) {
      out.push_back({.renderer = target.renderer,
                     .case_name = target.case_name,
                     .target = target.target,
                     .problem = e.what()});
    }
  }
  return out;
}

std::string explanations_text(const std::vector<Explanation>& explanations) {
  std::string text;
  for (const auto& one : explanations) {
    text += fmt::format("{}  {}  ", one.renderer, one.target);
    if (!one.problem.empty()) {
      text += fmt::format("cannot be compared: {}\n", one.problem);
    } else if (one.fault) {
      const auto& info = *std::find_if(scene::kRenderFaults.begin(), scene::kRenderFaults.end(),
                                       [&](const auto& fault) { return fault.name == *one.fault; });
      text +=
          fmt::format("{}: {}. This explains {:.1f} % of the error\n", info.name, info.what, 100 * one.share);
    } else if (one.tried.empty()) {
      text += "none of the known mistakes can change this scene\n";
    } else {
      text += fmt::format("none of these: {}\n", fmt::join(one.tried, ", "));
    }
  }
  return text;
}

}  // namespace orbs::studies
