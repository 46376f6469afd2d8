#include "studies/cost/subject.h"

#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "judge/judge.h"
#include "judge/noise.h"
#include "metrics/pixel_errors.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

ReferenceNoise noise_of(const image::Image& reference, const metrics::Mask& mask) {
  ReferenceNoise noise;
  const auto included = metrics::included_pixels(mask, reference.width, reference.height);
  double count = 0;
  for (const char* colour : {"R", "G", "B"}) {
    const int variance = image::channel_index(reference, std::string("variance.") + colour);
    if (variance < 0) continue;
    const auto value = static_cast<std::size_t>(image::channel_index(reference, colour));
    for (int y = 0; y < reference.height; ++y)
      for (int x = 0; x < reference.width; ++x) {
        if (included[static_cast<std::size_t>(y) * static_cast<std::size_t>(reference.width) +
                     static_cast<std::size_t>(x)] == 0)
          continue;
        const double of_pixel = static_cast<double>(reference.at(x, y, static_cast<std::size_t>(variance)));
        const double level = static_cast<double>(reference.at(x, y, value));
        noise.mse += of_pixel;
        noise.relmse += of_pixel / (level * level + metrics::relmse::kEpsilon);
        ++count;
      }
  }
  if (count == 0) return noise;
  noise.mse /= count;
  noise.relmse /= count;
  if (const auto srgb8 = judge::noise_mse_srgb8(reference, reference); srgb8 && *srgb8 > 0)
    noise.psnr_srgb8 = judge::psnr_srgb8_of(*srgb8);
  return noise;
}

// The case that a scene is known by: that in whose folder its file lies, if a chosen case has it, for others
// may look at it as well. Else the first.
const registry::Case& own_case(const run::Plan& plan,
                               const std::string& target,
                               const registry::Case& first) {
  for (const auto& one_case : plan.cases)
    for (const auto& scene : one_case.scenes)
      if (scene.name == target &&
          scene.file.lexically_normal().parent_path() == one_case.file.lexically_normal().parent_path())
        return one_case;
  return first;
}

bool is_known(const std::vector<CostSubject>& subjects, const std::string& target) {
  return std::any_of(subjects.begin(), subjects.end(),
                     [&](const CostSubject& subject) { return subject.target.name == target; });
}

}  // namespace

std::vector<CostSubject> load_cost_subjects(const run::Plan& plan, const std::filesystem::path& folder) {
  std::vector<CostSubject> subjects;
  make_folder(folder / "images/reference");
  for (const auto& planned : plan.targets) {
    const auto& name = planned.target;
    if (planned.jobs.empty() || is_known(subjects, name)) continue;
    if (judge::is_difference(plan.cases[planned.one_case], name)) continue;
    const auto& one_case = own_case(plan, name, plan.cases[planned.one_case]);
    auto reference = judge::load_reference(one_case, name, plan.suite.references, plan.reference_hashes, {},
                                           plan.settings.size_divisor);
    if (!reference.image) throw InputError(reference.problem);
    CostSubject subject;
    subject.one_case = &one_case;
    subject.scene = &*std::find_if(plan.scenes.begin(), plan.scenes.end(),
                                   [&](const auto& scene) { return scene.name == name; });
    subject.reference = std::move(*reference.image);
    subject.mask = judge::mask_of(one_case, name);
    subject.target = {name,
                      one_case.requirement,
                      one_case.title,
                      subject.reference.width,
                      subject.reference.height,
                      fmt::format("images/reference/{}.exr", name),
                      noise_of(subject.reference, subject.mask)};
    image::write_exr(subject.reference, folder / subject.target.reference);
    subjects.push_back(std::move(subject));
  }
  if (subjects.empty()) throw InputError("none of the chosen renderers renders a scene of the chosen cases");
  return subjects;
}

}  // namespace orbs::studies
