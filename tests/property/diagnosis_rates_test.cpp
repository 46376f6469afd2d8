// How often the diagnosis of a wrong image is right: typical faults of the suite's references at 1/4 of their
// size, with the noise of a run. `orbs qualify --diagnoses` measures the same on images of a run; the
// numbers in docs/understand/verdicts.md are from there.
#include "studies/qualify/diagnosis_rates.h"

#include "base/parallel.h"
#include "base/random.h"
#include "judge/noise.h"
#include "judge/reference.h"
#include "registry/cases.h"
#include "registry/configuration.h"
#include "registry/image_size.h"

#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr int kDivisor = 4;

// A normally distributed number of mean 0 and variance 1 (Box and Muller 1958).
double normal(std::uint64_t at) {
  const double u = 1 - unit_random(mix(at, 1));
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * unit_random(mix(at, 2)));
}

// The reference with noise upon it, as uneven as its own and of 40 dB.
image::Image control_of(const image::Image& reference) {
  constexpr double kNoise_db = 40;
  const auto own = judge::noise_mse_srgb8(reference, reference);
  if (!own || *own <= 0) return reference;
  const double factor = 255 * 255 * std::pow(10, -kNoise_db / 10) / *own;
  auto control = reference;
  for (const char* colour : {"R", "G", "B"}) {
    const auto value = static_cast<std::size_t>(image::channel_index(reference, colour));
    const auto variance =
        static_cast<std::size_t>(image::channel_index(reference, std::string("variance.") + colour));
    for (std::size_t i = 0; i < control.pixels.size(); i += control.channel_count()) {
      control.pixels[i + variance] *= static_cast<float>(factor);
      const double deviation = std::sqrt(static_cast<double>(control.pixels[i + variance]));
      control.pixels[i + value] =
          std::max(0.0F, control.pixels[i + value] + static_cast<float>(deviation * normal(i + value)));
    }
  }
  return control;
}

struct Subject {
  registry::Case one_case;
  std::string target;
};

std::vector<Subject> subjects(const registry::Suite& suite) {
  std::vector<Subject> found;
  std::set<std::string> names;
  for (const auto& one_case : registry::load_cases(suite))
    for (const auto& scene : one_case.scenes)
      if (names.insert(scene.name).second)
        found.push_back({registry::reduced_case(one_case, kDivisor), scene.name});
  return found;
}

image::Image reference_of(const registry::Suite& suite,
                          const registry::Case& one_case,
                          const std::string& target) {
  auto reference = judge::load_reference(one_case, target, suite.references, {}, {}, {kDivisor});
  EXPECT_TRUE(reference.image) << reference.problem;
  return std::move(*reference.image);
}

}  // namespace

// Every fourth fault of each target, another quarter each time: 300 images.
TEST(DiagnosisRates, AreHighAndSeldomWrong) {
  const auto suite = registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json").suites.front();
  const auto all = subjects(suite);
  std::vector<std::vector<studies::FaultDiagnosis>> found(all.size());
  for_each_index(static_cast<int>(all.size()), 2, [&](int index) {
    constexpr int kStep = 4;
    const auto& [one_case, target] = all[static_cast<std::size_t>(index)];
    std::map<std::string, image::Image> others;
    for (const auto& scene : one_case.scenes)
      if (scene.name != target) others[scene.name] = reference_of(suite, one_case, scene.name);
    const auto reference = reference_of(suite, one_case, target);
    found[static_cast<std::size_t>(index)] =
        studies::diagnose_faults({one_case, target, reference, control_of(reference), others}, index, kStep);
  });
  std::vector<studies::FaultDiagnosis> diagnoses;
  for (const auto& one : found) diagnoses.insert(diagnoses.end(), one.begin(), one.end());
  const auto rates = studies::rates_of(diagnoses);
  EXPECT_GE(rates.usual, 200);
  EXPECT_GE(rates.right, 0.95 * rates.usual) << studies::diagnoses_text(diagnoses);
  EXPECT_LE(rates.wrong, 0.01 * static_cast<double>(diagnoses.size())) << studies::diagnoses_text(diagnoses);
  EXPECT_EQ(rates.controls_said, 0) << studies::diagnoses_text(diagnoses);
}
