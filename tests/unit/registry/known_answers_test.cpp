// Every case whose right image is known accepts it and refuses one that is slightly wrong.
#include "faults/fault.h"
#include "image/image_io.h"
#include "judge/judge.h"
#include "registry/cases.h"
#include "registry/configuration.h"
#include "scene/load/load_scene.h"
#include "structure/source_files.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;
using results::Verdict;

namespace {

Verdict verdict_of(const registry::Case& one_case,
                   const std::string& target,
                   const image::Image& image,
                   const judge::Reference& reference) {
  results::TargetRecord record;
  record.target = target;
  judge::judge_image(one_case, image, reference,
                     {1, judge::Measured::ForTheVerdict, metrics::ResultNoise::NoiseFree}, record);
  return record.verdict;
}

// The image that every pixel check of the target takes for right.
image::Image as_the_checks_say(const registry::Case& one_case, const registry::CaseScene& scene) {
  const auto camera = scene::load_scene(scene.file, {}, scene.camera).camera;
  auto image = image::make_image(camera.width_px, camera.height_px, {"R", "G", "B"});
  for (const auto& check : one_case.pixel_checks)
    if (check.target == scene.name)
      for (int y = check.region.y0; y < check.region.y1; ++y)
        for (int x = check.region.x0; x < check.region.x1; ++x)
          for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = static_cast<float>(check.expected.at(c));
  return image;
}

// What is wrong with how the case judges the scene where its checks alone do; "" for nothing. Each check by
// itself must see a radiance of 1e-6 in one pixel where it says zero, and else twice its tolerance.
std::string fault_of_checks(const registry::Case& one_case, const registry::CaseScene& scene) {
  const auto right = as_the_checks_say(one_case, scene);
  if (verdict_of(one_case, scene.name, right, {}) != Verdict::Pass) return "the right image does not pass";
  for (const auto& check : one_case.pixel_checks) {
    if (check.target != scene.name) continue;
    auto wrong = right;
    const bool is_zero = check.tolerance == 0;
    for (int y = check.region.y0; y < (is_zero ? check.region.y0 + 1 : check.region.y1); ++y)
      for (int x = check.region.x0; x < (is_zero ? check.region.x0 + 1 : check.region.x1); ++x)
        for (std::size_t c = 0; c < 3; ++c)
          wrong.at(x, y, c) += is_zero ? 1e-6F : static_cast<float>(2 * check.tolerance);
    if (verdict_of(one_case, scene.name, wrong, {}) != Verdict::Fail)
      return fmt::format("the check {} does not fail", check.why);
  }
  return "";
}

std::string fault_of_gates(const registry::Case& one_case,
                           const std::string& target,
                           const std::filesystem::path& references,
                           double share) {
  const auto reference = judge::load_reference(one_case, target, references);
  if (!reference.image) return reference.problem;
  // A rendered one: the qualification of its suite tests its gates.
  if (image::channel_index(*reference.image, "variance.R") >= 0) return "";
  const auto right = image::select_rgb(*reference.image, "");
  if (verdict_of(one_case, target, right, reference) != Verdict::Pass) return "the right image does not pass";
  const auto wrong = faults::Factor{1 + share}.apply(right);
  if (verdict_of(one_case, target, wrong, reference) != Verdict::Fail)
    return fmt::format("{} % more light does not fail", 100 * share);
  return "";
}

// `share` of the light is too much for each gate of the suite.
void expect_cases_judge(const std::string& name, double share) {
  const auto suite =
      registry::find_suite(registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json"), name);
  std::vector<std::string> complaints;
  for (const auto& one_case : registry::load_cases(suite))
    for (const auto& scene : one_case.scenes) {
      const auto fault = scene.no_reference.empty()
                             ? fault_of_gates(one_case, scene.name, suite.references, share)
                             : fault_of_checks(one_case, scene);
      if (!fault.empty()) complaints.push_back(fmt::format("{}: {}", scene.name, fault));
    }
  EXPECT_TRUE(complaints.empty()) << structure::joined(complaints);
}

}  // namespace

// The gates of parallel mirrors and of polarisers allow 0.5 %.
TEST(KnownAnswers, OfTheSuiteStabilityCanFail) { expect_cases_judge("stability", 0.007); }

TEST(KnownAnswers, OfTheSuiteKnownCanFail) { expect_cases_judge("known", 0.007); }

TEST(KnownAnswers, OfTheSuiteGiCanFail) { expect_cases_judge("gi", 0.02); }
