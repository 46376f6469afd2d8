// The numbers of the suite gi and its references, by a path tracer that shares no code with the built-in one.
#include "base/parallel.h"
#include "image/image_io.h"
#include "registry/cases.h"
#include "registry/configuration.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr int kSeed = 1;

registry::Suite suite_gi() {
  return registry::find_suite(registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json"), "gi");
}

// Its image has a closed form.
bool is_estimated(const std::string& scene) { return !scene.starts_with("emission"); }

struct Part {
  Rectangle where;
  double mean = 0;
  double error = 0;
};

std::vector<Part> estimate(const std::string& scene, long paths, const std::vector<Rectangle>& where) {
  auto command = fmt::format("{}/tests/gi-estimate {} {} {}", ORBS_BINARY_WORD, scene, paths, kSeed);
  for (const auto& part : where) command += fmt::format(" {} {} {} {}", part.x0, part.y0, part.x1, part.y1);
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::vector<Part> parts;
  Part part;
  while (pipe && std::fscanf(pipe.get(), "%d %d %d %d %lf %lf", &part.where.x0, &part.where.y0,
                             &part.where.x1, &part.where.y1, &part.mean, &part.error) == 6)
    parts.push_back(part);
  return parts;
}

std::vector<std::string> complaints_of(const std::vector<std::function<std::vector<std::string>()>>& tasks) {
  std::mutex mutex;
  std::vector<std::string> complaints;
  for_each_index(static_cast<int>(tasks.size()), 0, [&](int index) {
    const auto found = tasks[static_cast<std::size_t>(index)]();
    const std::scoped_lock lock(mutex);
    complaints.insert(complaints.end(), found.begin(), found.end());
  });
  std::sort(complaints.begin(), complaints.end());
  return complaints;
}

// The umbra of secondary has a ten thousandth of the light, and the whole image of huge has lamps in it.
long paths_of(const registry::PixelCheck& check) {
  if (check.target == "secondary" && check.expected[0] < 1e-6) return 8'000'000;
  return check.target.starts_with("huge") ? 1'000'000 : 200'000;
}

// The light of a card by mirrors is rare for this program: its numbers are integrals over the card.
bool is_rare(const std::string& scene) { return scene.starts_with("caustic-"); }

std::vector<std::string> wrong_checks(const registry::PixelCheck& check) {
  constexpr double kErrors = 4.5;  // a hundred checks
  const auto parts = estimate(check.target, paths_of(check), {check.region});
  if (parts.size() != 1) return {fmt::format("{}: no estimate", check.target)};
  const auto [where, mean, error] = parts.front();
  const auto text = fmt::format("{} {}: {} expected, {} +- {} found", check.target,
                                fmt::join(std::vector{where.x0, where.y0, where.x1, where.y1}, " "),
                                check.expected[0], mean, error);
  if (!is_rare(check.target) && error > check.tolerance) return {text + ", which is too noisy"};
  if (std::fabs(mean - check.expected[0]) > check.tolerance / 2 + kErrors * error) return {text};
  return {};
}

// The mean of the part of the reference, and its variance.
Part part_of(const image::Image& image, const Rectangle& where) {
  Part part{where};
  const auto green = static_cast<std::size_t>(image::channel_index(image, "G"));
  const auto variance = static_cast<std::size_t>(image::channel_index(image, "variance.G"));
  double variances = 0;
  for (int y = where.y0; y < where.y1; ++y)
    for (int x = where.x0; x < where.x1; ++x) {
      part.mean += static_cast<double>(image.at(x, y, green));
      variances += static_cast<double>(image.at(x, y, variance));
    }
  const int pixels = (where.x1 - where.x0) * (where.y1 - where.y0);
  part.mean /= pixels;
  part.error = std::sqrt(variances) / pixels;
  return part;
}

std::vector<std::string> wrong_tiles(const std::string& scene, const image::Image& reference) {
  constexpr long kPaths = 40'000;
  constexpr double kErrors = 5;  // of two thousand tiles
  const auto tiles = estimate(scene, kPaths, {});
  if (tiles.size() != 64) return {scene + ": no estimate"};
  std::vector<std::string> complaints;
  double difference = 0;
  double variance = 0;
  for (const auto& tile : tiles) {
    const auto known = part_of(reference, tile.where);
    const double error = std::hypot(known.error, tile.error);
    difference += tile.mean - known.mean;
    variance += error * error;
    if (std::fabs(tile.mean - known.mean) > kErrors * error)
      complaints.push_back(fmt::format("{} at {}, {}: {} +- {} in the reference, {} +- {} found", scene,
                                       tile.where.x0, tile.where.y0, known.mean, known.error, tile.mean,
                                       tile.error));
  }
  if (std::fabs(difference) > 4 * std::sqrt(variance))
    complaints.push_back(
        fmt::format("{}: the mean is off by {} standard errors", scene, difference / std::sqrt(variance)));
  return complaints;
}

}  // namespace

TEST(IndependentEstimate, FindsWhatTheCasesOfGiExpect) {
  std::vector<std::function<std::vector<std::string>()>> tasks;
  for (const auto& one_case : registry::load_cases(suite_gi()))
    for (const auto& check : one_case.pixel_checks)
      if (is_estimated(check.target)) tasks.emplace_back([=] { return wrong_checks(check); });
  EXPECT_GT(tasks.size(), 100U);
  const auto complaints = complaints_of(tasks);
  EXPECT_TRUE(complaints.empty()) << fmt::format("{}", fmt::join(complaints, "\n"));
}

// Not those of the caustics. The light that comes by a mirror is found by chance here, so that tiles of which
// these paths have met none look certain to be dark: of a far tile of caustic-cube-3-k4, 40 thousand paths
// say (1.924 +- 0.006)e-6, 4 million (3.18 +- 0.12)e-6, and the reference has (2.86 +- 0.14)e-6. Their checks
// above take as many paths as they need.
TEST(IndependentEstimate, FindsTheReferencesOfGi) {
  const auto suite = suite_gi();
  std::vector<std::function<std::vector<std::string>()>> tasks;
  for (const auto& one_case : registry::load_cases(suite))
    for (const auto& scene : one_case.scenes)
      if (is_estimated(scene.name) && !scene.name.starts_with("caustic"))
        tasks.emplace_back([name = scene.name, file = suite.references / (scene.name + ".exr")] {
          return wrong_tiles(name, image::read_image(file));
        });
  EXPECT_EQ(tasks.size(), 19U);
  const auto complaints = complaints_of(tasks);
  EXPECT_TRUE(complaints.empty()) << fmt::format("{}", fmt::join(complaints, "\n"));
}

// Tiles of the caustics that a hundredth of these paths found dark, or too dark by many standard errors.
TEST(IndependentEstimate, FindsDimTilesOfCaustics) {
  constexpr long kPaths = 4'000'000;
  constexpr double kErrors = 4;
  const std::vector<std::pair<std::string, Rectangle>> tiles{{"caustic-cube-3-k4", {224, 0, 256, 32}},
                                                             {"caustic-cube-k4", {160, 64, 192, 96}},
                                                             {"caustic-sphere-3", {192, 96, 224, 128}},
                                                             {"caustic-sphere-3-k4", {128, 160, 160, 192}}};
  for (const auto& [scene, tile] : tiles) {
    const auto found = estimate(scene, kPaths, {tile});
    ASSERT_EQ(found.size(), 1U) << scene;
    const auto known = part_of(image::read_image(suite_gi().references / (scene + ".exr")), tile);
    EXPECT_NEAR(found[0].mean, known.mean, kErrors * std::hypot(found[0].error, known.error)) << scene;
  }
}
