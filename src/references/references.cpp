#include "references/references.h"

#include "analytic/analytic_image.h"
#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "references/history.h"
#include "references/render.h"
#include "references/store.h"
#include "registry/cases.h"
#include "scene/load/load_scene.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::references {

namespace {

// Raises `wanted` to what all cases that are judged by it need, chosen or not, as they share its file.
void raise_to_needs(const std::vector<registry::Case>& cases, WantedReference& wanted) {
  for (const auto& one_case : cases)
    for (const auto& scene : one_case.scenes) {
      if (registry::reference_name(scene) != wanted.name) continue;
      wanted.most_noise = stricter(wanted.most_noise, most_noise(one_case.gates));
      for (const auto& share : one_case.path_shares)
        wanted.split_paths = wanted.split_paths || share.scene == scene.name;
    }
}

std::vector<WantedReference> wanted_references(const registry::Suite& suite,
                                               const registry::RunSettings& selection,
                                               const ReferenceContext& context) {
  const auto cases = registry::load_cases(suite);
  std::vector<WantedReference> all;
  for (const auto& one_case : registry::choose_cases(cases, selection))
    for (const auto& scene : one_case.scenes) {
      const auto is_known = [&](const auto& wanted) { return wanted.name == scene.name; };
      if (std::any_of(all.begin(), all.end(), is_known)) continue;
      if (!scene.reference.empty()) {
        context.say(fmt::format("{} is judged by the reference of {}", scene.name, scene.reference));
        continue;
      }
      if (!scene.no_reference.empty()) {
        context.say(fmt::format("{} has no reference: {}", scene.name, scene.no_reference));
        continue;
      }
      WantedReference wanted{scene.name, scene.file, suite.references / (scene.name + ".exr"), scene.spp};
      const auto read = with_note(fmt::format("reading scene '{}'", scene.name),
                                  [&] { return scene::load_scene(scene.file, suite.data, scene.camera); });
      wanted.pixels =
          static_cast<std::size_t>(read.camera.width_px) * static_cast<std::size_t>(read.camera.height_px);
      wanted.camera = scene.camera;
      wanted.analytic = scene.analytic;
      raise_to_needs(cases, wanted);
      all.push_back(std::move(wanted));
    }
  return all;
}

bool exists(const WantedReference& wanted) {
  std::error_code ignored;
  return std::filesystem::exists(wanted.target, ignored);
}

// Without a reason only the missing ones. Refuses here rather than after hours of rendering.
std::vector<WantedReference> due_references(std::vector<WantedReference> all,
                                            const std::string& reason,
                                            const ReferenceContext& context) {
  if (trim(reason).empty()) {
    const auto missing = std::stable_partition(all.begin(), all.end(), exists);
    std::vector<std::string> existing;
    for (auto kept = all.begin(); kept != missing; ++kept) existing.push_back(kept->name);
    if (missing == all.end() && !existing.empty())
      throw InputError(
          fmt::format("references exist for {}; say why they may be replaced with --accept \"reason\"",
                      fmt::join(existing, ", ")));
    if (!existing.empty())
      context.say(fmt::format("kept, for want of a reason to replace them (--accept): {}",
                              fmt::join(existing, ", ")));
    all.erase(all.begin(), missing);
  }
  for (const auto& wanted : all)
    with_note(fmt::format("reading the history of the reference '{}'", wanted.name),
              [&] { read_history(wanted.target); });
  return all;
}

// The references before this one took hours, in which another call may have stored it.
bool is_kept(const WantedReference& wanted,
             const ReferenceSettings& settings,
             const ReferenceContext& context) {
  if (!trim(settings.reason).empty() || !exists(wanted)) return false;
  context.say(fmt::format("kept, as it has appeared meanwhile: {}", wanted.name));
  return true;
}

// The formula's image is exact: no pass, no noise.
void compute_reference(const WantedReference& wanted, const ReferenceSettings& settings) {
  const auto scene = scene::load_scene(wanted.file, {}, wanted.camera);
  const auto image = with_note(fmt::format("computing the image of scene '{}'", wanted.name), [&] {
    return analytic::analytic_image(wanted.analytic->image, scene.camera);
  });
  store_analytic_reference(image, wanted, settings.reason);
}

}  // namespace

int render_references(const registry::Configuration& configuration,
                      const registry::RunSettings& selection,
                      const ReferenceSettings& settings,
                      const ReferenceContext& context) {
  const auto& suite = registry::find_suite(configuration, selection.suite);
  const auto all = due_references(wanted_references(suite, selection, context), settings.reason, context);
  make_folder(suite.references);
  bool too_noisy = false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& wanted = all[i];
    if (is_kept(wanted, settings, context)) continue;
    if (wanted.analytic) {
      compute_reference(wanted, settings);
      context.say(fmt::format("[{}/{}] {:<18} by its formula", i + 1, all.size(), wanted.name));
      continue;
    }
    auto unfinished =
        unfinished_reference(wanted.target, wanted.file, wanted.camera, context.tracer, wanted.split_paths);
    const auto rendered = render_reference(wanted, settings, context, unfinished);
    if (!rendered) {
      context.say(fmt::format("stopped at {}, the same call goes on from there; {} of {} references are done",
                              wanted.name, i, all.size()));
      return kInterrupted;
    }
    // The passes stay, for a call with a reason.
    if (is_kept(wanted, settings, context)) continue;
    store_reference(*rendered, wanted, settings.reason);
    remove_passes(std::move(unfinished));
    const bool noisy = times_too_noisy(rendered->noise, wanted.most_noise) > 1;
    too_noisy = too_noisy || noisy;
    context.say(fmt::format(
        "[{}/{}] {:<18} {:>7} spp, noise {}{}", i + 1, all.size(), wanted.name, rendered->sum.spp,
        noise_text(rendered->noise),
        noisy ? fmt::format("; {} is needed, so more samples", noise_text(wanted.most_noise)) : ""));
  }
  return too_noisy ? 1 : 0;
}

}  // namespace orbs::references
