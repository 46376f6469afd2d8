// What a case may say of the reference of a scene: a formula, none, or another scene's.
#include "base/error.h"
#include "registry/case.h"
#include "structure/source_files.h"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;

namespace {

std::string case_with(const std::string& scene, const std::string& more = "") {
  return fmt::format(
      R"({{"format": "orbs-case/2", "requirement": "M1", "title": "t", "tests": "t", "typical_mistake": "m",
"scenes": [{{"name": "a", "file": "a.json"{}}}, {{"name": "b", "file": "a.json"}}]{}}})",
      scene, more);
}

registry::Case loaded(const std::string& text) {
  const structure::TestFolder scratch("registry-analytic");
  scratch.write("m/a.json", "{}");
  return registry::parse_case(scratch.path() / "m" / "case.json", text);
}

std::string message_of(const std::string& text) {
  try {
    loaded(text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

constexpr const char* kCheck =
    R"(, "pixel_checks": [{"scene": "a", "region": [0,0,1,1], "expected": [0,0,0], "tolerance": 0, "standard_errors": 4, "why": "w"}])";

}  // namespace

TEST(AnalyticCases, AFormulaIsReadWithItsLawAndItsSource) {
  const auto one_case =
      loaded(case_with(R"(, "wall_seconds": 7, "analytic": {"formula": "direct_light", "law": "L = rho F",
 "source": "s", "environment": 2, "surfaces": [{"corners": [[0,0,0],[1,0,0],[0,1,0]], "reflectance": 0.5},
 {"centre": [0,0,0], "normal": [0,2,0], "radius": 3, "radiance": 1}],
 "sources": [{"centre": [0,9,0], "radius": 1, "radiance": 4, "candela_centre": [0,9,0], "candela": [[0,1],[90,0]]}]})"));
  const auto& scene = one_case.scenes[0];
  EXPECT_EQ(scene.wall_seconds, 7);
  ASSERT_TRUE(scene.analytic);
  EXPECT_EQ(scene.analytic->law, "L = rho F");
  const auto& image = std::get<registry::DirectLight>(scene.analytic->image);
  EXPECT_EQ(image.environment, 2);
  EXPECT_EQ(image.surfaces[0].reflectance, 0.5);
  EXPECT_EQ(std::get<registry::RoundDisk>(image.surfaces[1].shape).normal, (Vec3d{0, 1, 0}));
  EXPECT_EQ(std::get<registry::FormulaSphere>(image.sources[0].shape).radius_m, 1);
  EXPECT_EQ(image.sources[0].candela[1], (std::pair<double, double>(90, 0)));
  EXPECT_FALSE(one_case.scenes[1].analytic);
}

TEST(AnalyticCases, MistakesAreNamed) {
  const auto analytic = [](const std::string& members) {
    return message_of(case_with(fmt::format(R"(, "analytic": {{"law": "l", "source": "s", {}}})", members)));
  };
  EXPECT_NE(analytic(R"("formula": "constnat", "value": [1,1,1])").find("did you mean"), std::string::npos);
  EXPECT_NE(analytic(R"("formula": "constant", "value": [1,1])").find("value"), std::string::npos);
  EXPECT_NE(analytic(R"("formula": "albedo_ball", "centre": [0,0,0], "radius": 1, "reflectance": 1)")
                .find("needs one of 'oren_nayar_roughness', 'ggx_alpha', 'metal_alpha'"),
            std::string::npos);
  EXPECT_NE(analytic(R"("formula": "direct_light", "surfaces": [])").find("at least one surface"),
            std::string::npos);
  EXPECT_NE(
      analytic(
          R"("formula": "direct_light", "shadows": true, "surfaces": [{"centre": [0,0,0], "radius": 1}])")
          .find("where all surfaces and sources are polygons"),
      std::string::npos);
  EXPECT_NE(message_of(case_with(R"(, "reference": "b", "no_reference": "why")", kCheck))
                .find("has more than one of 'reference', 'analytic' and 'no_reference'"),
            std::string::npos);
}

// It would pass whatever it shows.
TEST(AnalyticCases, ASceneWithoutReferenceNeedsAPixelCheck) {
  EXPECT_NE(message_of(case_with(R"(, "no_reference": "it is black")"))
                .find("'a' has no reference and no pixel check"),
            std::string::npos);
  const auto checked = loaded(case_with(R"(, "no_reference": "it is black")", kCheck));
  EXPECT_EQ(registry::no_reference_reason(checked, "a"), "it is black");
  EXPECT_EQ(registry::no_reference_reason(checked, "b"), "");
  EXPECT_EQ(checked.pixel_checks[0].standard_errors, 4);
  EXPECT_NE(message_of(case_with(R"(, "no_reference": "it is black")",
                                 fmt::format("{}{}", kCheck,
                                             R"(, "differences": [{"name": "d", "of": "a", "minus": "b"}])")))
                .find("'d' is of a scene with a reference and one without"),
            std::string::npos);
}
