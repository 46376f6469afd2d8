#include "page/fixture_cost.h"

#include "base/files.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "json/writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

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
constexpr std::array kDecibels{30.0, 35.0, 40.0, 45.0};
constexpr std::array kRelativeErrors{1e-2, 1e-3, 1e-4};
constexpr int kRungs = 6;
constexpr int kSeeds = 4;
constexpr int kWidth = 64, kHeight = 48;

Model model_of(std::size_t target, std::size_t renderer) {
  const double scale = std::pow(2.5, static_cast<double>(target));
  if (renderer == 0) return {0.0, 1e-3 * scale, 1.0, 0.05, 2e-3};
  // The two are alike on the third target.
  if (renderer == 1) return {0.0, (target == 2 ? 1.0 : 2.2) * 1e-3 * scale, 1.0, 0.4, 3e-3};
  return {5e-4, 4e-3 * scale, 0.8, 0.1, 4e-3};
}

double spp_of(int rung) { return std::pow(4.0, rung + 1); }
double seconds_of(const Model& model, int rung) {
  return model.fixed_seconds + model.seconds_per_sample * spp_of(rung);
}
double error_at(const Model& model, double seconds) {
  return model.bias_squared + model.variance / std::pow(seconds - model.fixed_seconds, model.exponent);
}
double decibels_of(double error) { return 10.0 - 10.0 * std::log10(error); }
double error_of_decibels(double decibels) { return std::pow(10.0, (10.0 - decibels) / 10.0); }

// Seconds to this error; none where the rungs do not reach it.
std::optional<double> price_of(const Model& model, double error) {
  if (error <= model.bias_squared) return std::nullopt;
  const double seconds =
      model.fixed_seconds + std::pow(model.variance / (error - model.bias_squared), 1.0 / model.exponent);
  if (seconds < seconds_of(model, 0) || seconds > seconds_of(model, kRungs - 1)) return std::nullopt;
  return seconds;
}

void interval(json::Writer& out, const char* name, double value, double relative) {
  out.key(name).begin_object().member("value", value);
  out.member("low", value * (1 - relative)).member("high", value * (1 + relative)).end_object();
}

void write_head(json::Writer& out) {
  out.member("format", "orbs-cost/1").member("orbs_version", "0.0").member("started", "2026-01-02T03:04:05");
  out.member("finished", true).member("suite", "orbs").member("size", "1/4");
  out.key("settings").begin_object().member("target_db", 35).member("budget_seconds", 1200);
  out.member("seeds", kSeeds).member("threads", 2).member("order_seed", 1).end_object();
  out.key("host").begin_object().member("name", "host").member("cpu", "a processor").member("cores", 2);
  out.member("system", "Linux").end_object().member("load", 0.2).member("load_end", 0.4);
  out.key("definitions").begin_array();
  for (const auto& [name, text] : {std::pair("relmse", "mean of squared relative errors <i>made up</i>"),
                                   std::pair("cpu_seconds", "user and system time of all processes")})
    out.begin_object().member("name", name).member("text", text).end_object();
  out.end_array().key("metrics").begin_array();
  for (const char* name : {"relmse", "mse", "psnr_srgb8", "flip"}) {
    const bool is_psnr = std::string(name) == "psnr_srgb8";
    out.begin_object().member("name", name).member("unit", is_psnr ? "dB" : "");
    out.member("lower_is_better", !is_psnr).member("log", !is_psnr).end_object();
  }
  out.end_array().key("renderers").begin_array();
  for (const char* name : kRenderers) {
    const bool is_povray = std::string(name) == "povray";
    out.begin_object().member("name", name).member("version", fmt::format("{} 1.0", name));
    out.member("ladder", is_povray ? "settings" : "samples").member("biased", is_povray ? "radiosity" : "");
    out.end_object();
  }
  out.end_array();
}

void write_targets(json::Writer& out) {
  out.key("targets").begin_array();
  for (std::size_t t = 0; t < kTargets.size(); ++t) {
    out.begin_object().member("name", kTargets.at(t)).member("requirement", fmt::format("M{}", t + 1));
    out.member("title", kTitles.at(t)).member("width", kWidth).member("height", kHeight);
    out.member("reference", fmt::format("images/reference/{}.exr", kTargets.at(t)));
    out.key("reference_noise").begin_object().member("relmse", 4e-5).member("mse", 4e-6);
    out.member("psnr_srgb8", decibels_of(4e-5)).key("flip").null().end_object().end_object();
  }
  out.end_array();
}

bool is_on_frontier(std::size_t target, std::size_t renderer, int rung) {
  const double seconds = seconds_of(model_of(target, renderer), rung);
  const double error = error_at(model_of(target, renderer), seconds);
  for (std::size_t r = 0; r < kRenderers.size(); ++r)
    for (int k = 0; k < kRungs; ++k) {
      const double other = seconds_of(model_of(target, r), k);
      if (other < seconds && error_at(model_of(target, r), other) < error) return false;
    }
  return true;
}

void write_point(json::Writer& out, std::size_t t, std::size_t r, int rung) {
  const auto model = model_of(t, r);
  const double seconds = seconds_of(model, rung);
  const double error = error_at(model, seconds);
  out.begin_object().member("rung", fmt::format("{} spp", spp_of(rung))).member("spp", spp_of(rung));
  out.member("renders", kSeeds);
  interval(out, "cpu_seconds", seconds, 0.05);
  interval(out, "wall_seconds", 0.6 * seconds, 0.06);
  // POV-Ray reports no render time here.
  if (r == 2) out.key("render_seconds").null();
  if (r != 2) interval(out, "render_seconds", 0.5 * seconds, 0.05);
  out.key("errors").begin_object();
  interval(out, "relmse", error, 0.15);
  interval(out, "mse", 0.1 * error, 0.15);
  interval(out, "psnr_srgb8", decibels_of(error), 0.015);
  interval(out, "flip", std::sqrt(error), 0.05);
  out.end_object().member("below_reference_noise", error < 2 * 4e-5);
  out.member("on_frontier", is_on_frontier(t, r, rung));
  const auto stem = fmt::format("images/{}/{}/{}", kRenderers.at(r), kTargets.at(t), rung);
  out.member("image", stem + ".png").member("exr", stem + ".exr").end_object();
}

void write_price(json::Writer& out, const Model& model, const char* metric, double level, double error) {
  const auto seconds = price_of(model, error);
  out.begin_object().member("metric", metric).member("level", level);
  if (seconds) interval(out, "cpu_seconds", *seconds, 0.1);
  if (!seconds) out.key("cpu_seconds").null();
  const bool is_cheap = error > error_at(model, seconds_of(model, 0));
  out.member("note", seconds ? std::string()
                     : is_cheap
                         ? fmt::format("cheaper than the first rung: at most {:.2g} s", seconds_of(model, 0))
                         : fmt::format("not reached: at least {:.3g} s", seconds_of(model, kRungs - 1)));
  out.end_object();
}

void write_curve(json::Writer& out, std::size_t t, std::size_t r) {
  const auto model = model_of(t, r);
  out.begin_object().member("target", static_cast<int>(t)).member("renderer", static_cast<int>(r));
  interval(out, "fixed_cpu_seconds", model.fixed_seconds, 0.02);
  out.key("points").begin_array();
  for (int rung = 0; rung < kRungs; ++rung) write_point(out, t, r, rung);
  out.end_array().key("fit").begin_object();
  interval(out, "bias_squared", model.bias_squared, 0.2);
  interval(out, "variance", model.variance, 0.1);
  interval(out, "exponent", model.exponent, 0.03);
  out.member("has_floor", model.bias_squared > 0);
  out.member("floor_named", model.bias_squared > 0 ? "block (8, 16) is too bright" : "").end_object();
  out.key("prices").begin_array();
  for (const double level : kDecibels) write_price(out, model, "psnr_srgb8", level, error_of_decibels(level));
  for (const double level : kRelativeErrors) write_price(out, model, "relmse", level, level);
  out.end_array();
  interval(out, "efficiency", 1 / model.variance, 0.1);
  interval(out, "seconds_per_db", std::pow(10.0, 0.1 / model.exponent) - 1, 0.02);
  out.member("note", "").end_object();
}

struct Level {
  const char* metric;
  double level, error;
};

void write_comparison(json::Writer& out, const Level& level, std::size_t t, std::size_t a, std::size_t b) {
  const auto first = price_of(model_of(t, a), level.error);
  const auto second = price_of(model_of(t, b), level.error);
  out.begin_object().member("target", static_cast<int>(t)).member("metric", level.metric);
  out.member("level", level.level).member("first", static_cast<int>(a)).member("second", static_cast<int>(b));
  const double ratio = first && second ? *second / *first : 0.0;
  if (ratio > 0) interval(out, "time_ratio", ratio, 0.15);
  if (ratio <= 0) out.key("time_ratio").null();
  out.member("verdict", ratio <= 0           ? "not comparable"
                        : ratio * 0.85 > 1.0 ? "dearer"
                        : ratio * 1.15 < 1.0 ? "cheaper"
                                             : "no difference shown");
  out.member("note", "").end_object();
}

void write_comparisons(json::Writer& out) {
  std::vector<Level> levels;
  for (const double db : kDecibels) levels.push_back({"psnr_srgb8", db, error_of_decibels(db)});
  for (const double error : kRelativeErrors) levels.push_back({"relmse", error, error});
  out.key("comparisons").begin_array();
  for (const auto& level : levels)
    for (std::size_t t = 0; t < kTargets.size(); ++t)
      for (std::size_t a = 0; a < kRenderers.size(); ++a)
        for (std::size_t b = a + 1; b < kRenderers.size(); ++b) write_comparison(out, level, t, a, b);
  out.end_array();
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
      for (int rung = 0; rung < kRungs; ++rung) {
        const auto model = model_of(t, r);
        const auto image = ramp_with_noise(error_at(model, seconds_of(model, rung)), 1000 * t + 10 * r + 1);
        const auto stem = folder / fmt::format("images/{}/{}", kRenderers.at(r), kTargets.at(t));
        fs::create_directories(stem);
        image::write_exr(image, stem / fmt::format("{}.exr", rung));
        image::write_png(image::display_image(image), stem / fmt::format("{}.png", rung));
      }
  }
}

}  // namespace

void write_cost_study(const fs::path& folder) {
  json::Writer out;
  out.begin_object();
  write_head(out);
  write_targets(out);
  out.key("curves").begin_array();
  for (std::size_t t = 0; t < kTargets.size(); ++t)
    for (std::size_t r = 0; r < kRenderers.size(); ++r) write_curve(out, t, r);
  out.end_array();
  write_comparisons(out);
  out.key("self_comparison").begin_object().member("renderer", 0).member("target", 0).member("pairs", 4);
  interval(out, "time_ratio", 1.002, 0.03);
  interval(out, "error_ratio", 0.998, 0.04);
  out.member("passed", true).member("note", "the same renderer twice under two names").end_object();
  out.key("renders").begin_array().end_array().end_object();
  write_images(folder);
  write_file(folder / "cost.json", out.text());
}

}  // namespace orbs::page_tests
