// Every target of every suite refuses what no right renderer makes: black, one colour all over, half the
// light.
#include "base/parallel.h"
#include "image/image.h"
#include "judge/judge.h"
#include "judge/noise.h"
#include "registry/cases.h"
#include "registry/image_size.h"
#include "scene/load/load_scene.h"
#include "structure/source_files.h"

#include <algorithm>
#include <array>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;

namespace {

struct Target {
  registry::Suite suite;
  registry::Case one_case;  // at the size of `right`
  std::string name;
  judge::Reference reference;
  image::Image right;  // an image that passes
};

// Where there is no reference, the image that is black but for what the checks expect.
image::Image image_of_checks(const registry::Case& one_case, const registry::CaseScene& scene) {
  const auto camera = scene::load_scene(scene.file, {}, scene.camera).camera;
  auto image = image::make_image(camera.width_px, camera.height_px, {"R", "G", "B"});
  for (const auto& check : one_case.pixel_checks) {
    if (check.target != scene.name) continue;
    for (int y = check.region.y0; y < check.region.y1; ++y)
      for (int x = check.region.x0; x < check.region.x1; ++x)
        for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = static_cast<float>(check.expected.at(c));
  }
  return image;
}

// A quarter of the size, where the pixels are those of the reference all the same, for a sixteenth of the
// time.
std::optional<Target> target_of(const registry::Suite& suite,
                                const registry::Case& one_case,
                                const std::string& name) {
  for (const auto& scene : one_case.scenes)
    if (scene.name == name && !scene.no_reference.empty())
      return Target{suite, one_case, name, {}, image_of_checks(one_case, scene)};
  auto reference = judge::load_reference(one_case, name, suite.references);
  if (!reference.image) return std::nullopt;
  constexpr int kFewest_px = 128;
  const auto [width, height] = std::pair(reference.image->width, reference.image->height);
  auto sized = one_case;
  if (width % registry::QuarterSize == 0 && height % registry::QuarterSize == 0 && width >= kFewest_px) {
    reference.image = judge::reduced_reference(*reference.image, registry::QuarterSize);
    sized = registry::reduced_case(one_case, registry::QuarterSize);
  }
  auto right = judge::without_variances(*reference.image);
  return Target{suite, sized, name, std::move(reference), std::move(right)};
}

results::Verdict verdict_on(const Target& target, const image::Image& image) {
  results::TargetRecord record;
  record.target = target.name;
  judge::judge_image(
      target.one_case, image, target.reference,
      {.measured = judge::Measured::ForTheVerdict, .result_noise = metrics::ResultNoise::NoiseFree}, record);
  return record.verdict;
}

image::Image scaled(image::Image image, float factor) {
  for (auto& value : image.pixels) value *= factor;
  return image;
}

image::Image constant_of(const image::Image& image) {
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < image.pixels.size(); i += image.channel_count())
    for (std::size_t c = 0; c < 3; ++c) sum.at(c) += static_cast<double>(image.pixels[i + c]);
  auto constant = image::make_image(image.width, image.height, {"R", "G", "B"});
  const auto count = static_cast<double>(constant.pixels.size() / 3);
  for (std::size_t i = 0; i < constant.pixels.size(); ++i)
    constant.pixels[i] = static_cast<float>(sum.at(i % 3) / count);
  return constant;
}

bool is_equal(const image::Image& a, const image::Image& b) { return a.pixels == b.pixels; }

// What the target lets pass that it must not.
std::vector<std::string> let_through(const Target& target) {
  const auto right = image::select_rgb(target.right, "");
  const std::array<std::pair<const char*, image::Image>, 3> wrong{{{"black", scaled(right, 0)},
                                                                   {"one colour", constant_of(right)},
                                                                   {"half the light", scaled(right, 0.5F)}}};
  std::vector<std::string> complaints;
  for (const auto& [name, image] : wrong)
    if (!is_equal(image, right) && results::passes(verdict_on(target, image)))
      complaints.push_back(fmt::format("{}: {} passes for {}", target.suite.name, name, target.name));
  return complaints;
}

}  // namespace

// A closed room is black by right, and a furnace of one colour: there the wrong image is the right one.
TEST(EveryTarget, RefusesBlackOneColourAndHalfTheLight) {
  std::vector<std::function<std::optional<Target>()>> targets;
  for (const auto& suite : registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json").suites)
    for (const auto& one_case : registry::load_cases(suite))
      for (const auto& name : registry::target_names(one_case))
        targets.emplace_back([=] { return target_of(suite, one_case, name); });
  std::mutex mutex;
  std::set<std::string> complaints;
  int tried = 0;
  for_each_index(static_cast<int>(targets.size()), 0, [&](int index) {
    const auto target = targets[static_cast<std::size_t>(index)]();
    if (!target) return;
    const auto passed = let_through(*target);
    const std::lock_guard lock(mutex);
    ++tried;
    complaints.insert(passed.begin(), passed.end());
  });
  EXPECT_GT(tried, 200);
  EXPECT_TRUE(complaints.empty()) << structure::joined({complaints.begin(), complaints.end()});
}
