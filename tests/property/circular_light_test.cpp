// The scene of circular light: the tracer's Mueller matrices against the closed form, which has none, and
// what the case says of an image whose Stokes parameters are wrong.
#include "analytic/analytic_image.h"
#include "base/error.h"
#include "image/image.h"
#include "property/judged_case.h"
#include "registry/configuration.h"
#include "scene/load/load_scene.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace orbs;

namespace {

const registry::CaseScene& circular_light(const registry::Case& one_case) {
  const auto found = std::find_if(one_case.scenes.begin(), one_case.scenes.end(),
                                  [](const auto& scene) { return scene.name == "circular_light"; });
  if (found == one_case.scenes.end()) throw InputError("the case has no scene circular_light");
  return *found;
}

class CircularLight : public testing::Test {
 protected:
  registry::Suite suite_ =
      registry::find_suite(registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json"), "appearance");
  registry::Case case_ = [this] {
    for (auto& one_case : registry::load_cases(suite_))
      if (one_case.requirement == "E3") return one_case;
    throw InputError("the suite has no case E3");
  }();
  scene::Scene scene_ = scene::load_scene(circular_light(case_).file, {}, {});
};

struct Mean {
  double value = 0;
  double error = 0;
};

// Of the difference over a quarter of the image.
Mean difference(const image::Image& a, const image::Image& b, const std::string& channel, int x0, int y0) {
  const auto of_a = static_cast<std::size_t>(image::channel_index(a, channel));
  const auto of_b = static_cast<std::size_t>(image::channel_index(b, channel));
  double sum = 0;
  double squares = 0;
  const double count = a.width / 2 * (a.height / 2);
  for (int y = y0; y < y0 + a.height / 2; ++y)
    for (int x = x0; x < x0 + a.width / 2; ++x) {
      const double d = static_cast<double>(a.at(x, y, of_a)) - static_cast<double>(b.at(x, y, of_b));
      sum += d;
      squares += d * d;
    }
  const double mean = sum / count;
  return {mean, std::sqrt((squares / count - mean * mean) / count)};
}

}  // namespace

TEST_F(CircularLight, TheTracerShowsTheClosedForm) {
  scene_ = tests::reduced_scene(scene_, 4);
  const auto formula = analytic::analytic_image(circular_light(case_).analytic->image, scene_.camera);
  const auto rendered = tests::rendered(scene_, 4096);
  for (const char* channel :
       {"R", "G", "B", "S1.R", "S2.R", "S3.R", "S1.G", "S2.G", "S3.G", "S1.B", "S2.B", "S3.B"})
    for (const int x0 : {0, formula.width / 2})
      for (const int y0 : {0, formula.height / 2}) {
        const auto off = difference(rendered, formula, channel, x0, y0);
        EXPECT_LT(std::fabs(off.value), 4.5 * off.error + 1e-5) << channel << " at " << x0 << ", " << y0;
        EXPECT_LT(off.error, 0.006) << channel;
      }
}

TEST_F(CircularLight, AWrongParameterFails) {
  constexpr int kDivisor = registry::QuarterSize;
  const auto reduced = registry::reduced_case(case_, kDivisor);
  const auto reference =
      judge::load_reference(reduced, "circular_light", suite_.references, {}, {}, {kDivisor});
  ASSERT_TRUE(reference.image) << reference.problem;
  const auto judged = [&](const image::Image& image) {
    results::TargetRecord record;
    record.target = "circular_light";
    judge::judge_image(reduced, image, reference, {1, judge::Measured::ForTheVerdict}, record);
    return record;
  };
  auto image = tests::rendered(tests::reduced_scene(scene_, kDivisor), 4096);
  tests::expect_verdict(judged(image), results::Verdict::Pass, "");
  for (const char* channel : {"S3.R", "S3.G", "S3.B"})
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        image.at(x, y, static_cast<std::size_t>(image::channel_index(image, channel))) *= -1;
  tests::expect_verdict(judged(image), results::Verdict::Fail, " with -S3");
  EXPECT_NE(judged(image).reason.find("S3 has the other sign"), std::string::npos) << judged(image).reason;
}
