// What `orbs effect-cost` measured: the lines of docs/understand/effects.md are made of the files beside the
// references.
#include "results/effect_costs.h"
#include "structure/documentation.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

struct Line {
  const char* suite;
  const char* scene;
  const char* calls_for;
  const char* instead;
};

constexpr std::array kLines{
    Line{"appearance", "ggx_copper_60", "spectral", "rgb"},
    Line{"appearance", "ggx_copper_60", "spectral", "polarised"},
    Line{"appearance", "ggx_copper_60", "spectral", "without measured metal"},
    Line{"appearance", "macbeth_chart_D65", "spectral", "rgb"},
    Line{"appearance", "macbeth_chart_D65", "spectral", "polarised"},
    Line{"appearance", "polarizing_spheres", "polarised", "spectral"},
    Line{"appearance", "polarizing_spheres", "polarised", "polarised-bispectral"},
    Line{"appearance", "fluorescent_sphere_D50_red", "bispectral", "rgb"},
    Line{"appearance", "fluorescent_sphere_D50_red", "bispectral", "spectral"},
    Line{"appearance", "iridescent_spheres_film", "spectral", "rgb"},
    Line{"appearance", "iridescent_spheres_film", "spectral", "polarised"},
    Line{"appearance", "iridescent_spheres_film", "spectral", "without thin film"},
    Line{"appearance", "prism_SF10", "spectral", "rgb"},
    Line{"appearance", "prism_SF10", "spectral", "without dispersion"},
    Line{"appearance", "prism_achromatic", "rgb", "spectral"},
    Line{"appearance", "caustic_BK7", "spectral", "rgb"},
    Line{"appearance", "caustic_BK7", "spectral", "without dispersion"},
    Line{"orbs", "100", "rgb", "spectral"},
    Line{"orbs", "110", "rgb", "spectral"},
    Line{"orbs", "g2-camera-defaults", "rgb", "polarised-bispectral"},
    Line{"orbs", "123-blue", "rgb", "spectral"},
    Line{"everyday", "n3-mask", "rgb", "without opacity"},
    Line{"everyday", "n1-right", "rgb", "without turned normals"},
    Line{"everyday", "d5-court", "rgb", "without environment map"},
    Line{"everyday", "v1-room", "rgb", "without layers of the surface"},
};

std::filesystem::path file_of(const std::string& suite) {
  return std::filesystem::path(ORBS_SOURCE_DIR) / "data/references" / suite / orbs::results::kEffectCostsFile;
}

std::string row(const Line& line) {
  const auto costs = orbs::results::read_effect_costs(file_of(line.suite));
  const auto& own = costs.at(line.scene);
  const auto cost =
      std::find_if(own.begin(), own.end(), [&](const auto& one) { return one.name == line.instead; });
  if (cost == own.end()) return fmt::format("{} has no {}\n", line.scene, line.instead);
  const auto noise = cost->error_ratio > 0 ? fmt::format("{:.2f}", cost->error_ratio) : "-";
  return fmt::format("| {} | {} | {} | {:.2f} ({:.2f} to {:.2f}) | {} | {} |\n", line.scene, line.calls_for,
                     line.instead, cost->time_ratio, cost->time_low.value_or(0), cost->time_high.value_or(0),
                     noise, cost->change);
}

std::string conditions(const std::string& suite) {
  const auto study = *orbs::results::read_effect_study(file_of(suite));
  return fmt::format(
      "- Suite `{}`: {} px, {} samples, {} rounds, {} cores of {}. Others took more than 5 % of the machine in {} of {} "
      "renders. The same scene twice: × {:.3f} ({:.3f} to {:.3f}) over {} scenes, of which {} alone differ.\n",
      suite, study.size_px, study.spp, study.rounds, study.cores, study.cpu, study.disturbed.value_or(-1),
      study.renders.value_or(-1), study.self_ratio.value_or(0), study.self_low.value_or(0),
      study.self_high.value_or(0), study.self_scenes.value_or(0), study.self_differing.value_or(0));
}

}  // namespace

TEST(EffectCostTable, ThePageShowsTheCommittedFiles) {
  std::string text =
      conditions("appearance") + conditions("orbs") + conditions("everyday") +
      "\n| scene | calls for | instead | time × | to equal noise × | image |\n|---|---|---|---|---|---|\n";
  for (const auto& line : kLines) text += row(line);
  const auto page = std::filesystem::path(ORBS_SOURCE_DIR) / "docs/understand/effects.md";
  EXPECT_EQ(orbs::structure::check_generated_part(page, "effect costs", text), "");
}

// A file that was measured beside other work, or whose scenes differ from themselves, is not published.
TEST(EffectCostTable, TheCommittedFilesAreOfASteadyMachine) {
  for (const char* suite : {"appearance", "orbs", "everyday"}) {
    const auto study = *orbs::results::read_effect_study(file_of(suite));
    EXPECT_LE(study.self_low.value_or(2), 1) << suite;
    EXPECT_GE(study.self_high.value_or(0), 1) << suite;
    EXPECT_LE(study.disturbed.value_or(100) * 100, study.renders.value_or(0))
        << suite << ": 1 % of the renders";
  }
}
