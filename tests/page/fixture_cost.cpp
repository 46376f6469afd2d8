#include "page/fixture_cost.h"

#include "base/files.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "results/study_kinds.h"
#include "studies/cost/json.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace orbs::page_tests {

namespace {

namespace fs = std::filesystem;

// relMSE(t) = bias_squared + variance / t^exponent, t in CPU seconds above the fixed cost.
struct Model {
  double bias_squared, variance, exponent, fixed_seconds, seconds_per_sample;
};

constexpr std::array kRenderers{"orbs", "cycles", "povray"};
constexpr std::array kTargets{"101", "110", "205", "248", "301", "g4-lambert"};
constexpr std::array kTitles{"Lambertian reflection", "Glass",          "Area light",
                             "Indirect light",        "Depth of field", "Furnace <b>test</b>"};
constexpr int kSettings = 6;
constexpr int kSettingOfSelf = 2;
constexpr std::size_t kSeeds = 4;
constexpr double kReferenceNoise = 4e-5;  // relMSE
constexpr int kWidth = 64, kHeight = 48;

Model model_of(std::size_t target, std::size_t renderer) {
  const double scale = std::pow(2.5, static_cast<double>(target));
  if (renderer == 0) return {0.0, 1e-3 * scale, 1.0, 0.05, 2e-3};
  // The two are alike on the third target.
  if (renderer == 1 && target != 2) return {0.0, 2.2e-3 * scale, 1.0, 0.4, 3e-3};
  if (renderer == 1) return {0.0, 1e-3 * scale, 1.0, 0.05, 3e-3};
  return {5e-4, 4e-3 * scale, 0.8, 0.1, 4e-3};
}

int spp_of(int setting) { return 4 << (2 * setting); }
double seconds_of(const Model& model, int setting) {
  return model.fixed_seconds + model.seconds_per_sample * spp_of(setting);
}
double error_at(const Model& model, double seconds) {
  return model.bias_squared + model.variance / std::pow(seconds - model.fixed_seconds, model.exponent);
}
double decibels_of(double error) { return 10.0 - 10.0 * std::log10(error); }

// Four values around `value` whose mean and median are it.
std::array<double, kSeeds> around(double value, double relative) {
  return {value * (1 - relative), value, value, value * (1 + relative)};
}

// The renders of one purpose on a setting: the times and errors of the model, with a scatter that is known.
void add_renders(studies::CostRecord& record, studies::CostRender render, const Model& model, int setting) {
  const double seconds =
      render.purpose == studies::Purpose::FixedCost ? model.fixed_seconds : seconds_of(model, setting);
  const auto times = around(seconds, 0.05);
  const auto errors =
      around(render.purpose == studies::Purpose::FixedCost ? 1.0 : error_at(model, seconds), 0.1);
  for (std::size_t seed = 0; seed < kSeeds; ++seed) {
    render.seed = static_cast<int>(seed);
    render.order = static_cast<int>(record.renders.size());
    render.cpu_seconds = times.at(seed);
    render.wall_seconds = 0.6 * times.at(seed);
    // POV-Ray reports no render time here.
    if (render.renderer != 2) render.render_seconds = 0.5 * times.at(seed);
    if (render.renderer == 0) render.trial_seconds = 0.1 * times.at(seed);
    render.other_share = 0.01;
    if (render.purpose != studies::Purpose::FixedCost) {
      render.relmse = errors.at(seed) + kReferenceNoise;
      render.mse = 0.1 * (errors.at(seed) + kReferenceNoise);
      render.psnr_srgb8 = decibels_of(errors.at(seed));
      render.flip = std::sqrt(errors.at(seed));
    }
    record.renders.push_back(render);
  }
}

void add_sweep(studies::CostRecord& record, std::size_t t, std::size_t r) {
  const auto model = model_of(t, r);
  studies::Sweep sweep{t, r, {}, "", model.bias_squared > 0 ? "block (8, 16) is too bright" : ""};
  studies::CostRender render{.target = t, .renderer = r, .purpose = studies::Purpose::FixedCost};
  add_renders(record, render, model, 0);
  render.purpose = studies::Purpose::Sweep;
  for (int setting = 0; setting < kSettings; ++setting) {
    render.spp = spp_of(setting);
    render.setting = fmt::format("{} spp", render.spp);
    sweep.settings.push_back({render.setting, render.spp});
    add_renders(record, render, model, setting);
  }
  if (r == 0) {
    render.purpose = studies::Purpose::Again;
    render.spp = spp_of(kSettingOfSelf);
    render.setting = sweep.settings[kSettingOfSelf].name;
    add_renders(record, render, model, kSettingOfSelf);
  }
  record.sweeps.push_back(std::move(sweep));
}

studies::CostRecord made_up_record() {
  studies::CostRecord record;
  record.orbs_version = "0.0";
  record.started = "2026-01-02T03:04:05";
  record.is_finished = true;
  record.suite = "orbs";
  record.size = "1/4";
  record.settings.threads = 2;
  record.host.name = "host";
  record.host.cpu = "a processor";
  record.host.cores = 2;
  record.host.system = "Linux";
  record.load = 0.2;
  record.load_end = 0.4;
  for (const char* name : kRenderers)
    record.renderers.push_back({name, fmt::format("{} 1.0", name), studies::SweepOf::Samples,
                                std::string(name) == "povray" ? "radiosity" : ""});
  for (std::size_t t = 0; t < kTargets.size(); ++t)
    record.targets.push_back({kTargets.at(t),
                              fmt::format("M{}", t + 1),
                              kTitles.at(t),
                              kWidth,
                              kHeight,
                              fmt::format("images/reference/{}.exr", kTargets.at(t)),
                              {kReferenceNoise, 0.1 * kReferenceNoise, decibels_of(kReferenceNoise)}});
  for (std::size_t t = 0; t < kTargets.size(); ++t)
    for (std::size_t r = 0; r < kRenderers.size(); ++r) add_sweep(record, t, r);
  // One more render, of which other work took so much that it is in no number.
  auto disturbed = record.renders.back();
  disturbed.seed = static_cast<int>(kSeeds);
  disturbed.cpu_seconds *= 10;
  disturbed.other_share = 0.3;
  disturbed.repeats = 2;
  record.renders.push_back(disturbed);
  return record;
}

image::Image ramp_with_noise(double error, std::uint64_t seed) {
  auto image = image::make_image(kWidth, kHeight, {"R", "G", "B"});
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const double truth = c == 0 ? x / 64.0 : c == 1 ? y / 48.0 : 0.25;
        seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;  // Knuth's generator, MMIX
        const double random = static_cast<double>(seed >> 40U) / static_cast<double>(1U << 24U) - 0.5;
        image.at(x, y, c) = static_cast<float>(truth * (1.0 + std::sqrt(12.0 * error) * random));
      }
  return image;
}

void write_images(const fs::path& folder) {
  for (std::size_t t = 0; t < kTargets.size(); ++t) {
    fs::create_directories(folder / "images/reference");
    image::write_exr(ramp_with_noise(0.0, 0),
                     folder / fmt::format("images/reference/{}.exr", kTargets.at(t)));
    for (std::size_t r = 0; r < kRenderers.size(); ++r)
      for (int setting = 0; setting < kSettings; ++setting) {
        const auto model = model_of(t, r);
        const auto image =
            ramp_with_noise(error_at(model, seconds_of(model, setting)), 1000 * t + 10 * r + 1);
        const auto stem = folder / fmt::format("images/{}/{}", kRenderers.at(r), kTargets.at(t));
        fs::create_directories(stem);
        image::write_exr(image, stem / fmt::format("{}.exr", setting));
        image::write_png(image::display_image(image), stem / fmt::format("{}.png", setting));
      }
  }
}

}  // namespace

void write_cost_study(const fs::path& folder) {
  write_images(folder);
  write_file(folder / results::kCost.file, studies::cost_json(made_up_record()));
}

void write_later_cost_study(const fs::path& folder) {
  write_images(folder);
  auto record = made_up_record();
  record.started = "2026-01-03T03:04:05";
  record.renderers[0].version = "orbs 1.1";
  for (auto& render : record.renders)
    if (render.renderer == 0) render.cpu_seconds *= 1.5;
  write_file(folder / results::kCost.file, studies::cost_json(record));
}

}  // namespace orbs::page_tests
