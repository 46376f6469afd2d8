#include "references/store.h"

#include "base/files.h"
#include "base/local_time.h"
#include "base/text.h"
#include "image/image_io.h"
#include "image/layers.h"
#include "image/reduced_precision.h"
#include "judge/provenance.h"
#include "references/history.h"
#include "results/image_hashes.h"
#include "run/execute.h"
#include "run/host.h"
#include "run/plan/scenes.h"
#include "scene/load/load_scene.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::references {

namespace {

// Rounding to p bits moves a value m 2^e, 1 <= m < 2, by at most 2^-p in m, evenly: 2^-p / sqrt(3) in the
// mean square, and over log-uniform m the relative error is sqrt(3 / (8 ln 2)) of it. For p = 9 that is
// 0.083 %. On the sRGB curve, S = 1.055 x^(1/2.4) - 0.055, a relative error e of x is (S + 0.055) / 2.4 e,
// at most 0.44 e: 68 dB on a white image, more on a darker one. The noise of a reference, which is allowed
// to reach 45 dB, has 200 times that power.
constexpr unsigned kColourBits = 9;
// Rounding to 2 bits is off by 11 % in the mean square and by -0.5 % in the mean, over log-uniform values. A
// variance out of n pieces of a pixel is itself off by some sqrt(2 / (n - 1)), 53 % for 8 of them.
constexpr unsigned kVarianceBits = 2;

std::string commands_of(const RenderedReference& rendered, bool split_paths) {
  std::vector<std::string> commands;
  for (const auto& pass : rendered.sum.passes)
    commands.push_back(
        fmt::format("--spp {} --seed {}{}", pass.spp, pass.seed, split_paths ? " --split-paths" : ""));
  return fmt::format("{}", fmt::join(commands, " + "));
}

// What rendered and computed references have in common.
void stamp_origin(const WantedReference& wanted, const std::string& reason, image::Image& image) {
  auto& provenance = image.attributes;
  provenance["orbs.scene_hash"] =
      hash_text(run::scene_content_hash(scene::load_scene(wanted.file, {}, wanted.camera), wanted.file));
  provenance["orbs.date"] = local_time_now();
  provenance["orbs.reason"] = reason.empty() ? "first reference of this scene" : reason;
}

void stamp(const RenderedReference& rendered,
           const WantedReference& wanted,
           const std::string& reason,
           image::Image& image) {
  auto& provenance = image.attributes;
  const auto version = provenance.contains("orbs.version") ? provenance.at("orbs.version") : "unknown";
  const auto plus = version.find('+');
  provenance["orbs.commit"] = plus == std::string::npos ? "unknown" : version.substr(plus + 1);
  provenance["orbs.spp"] = std::to_string(rendered.sum.spp);
  provenance["orbs.settings"] = commands_of(rendered, wanted.split_paths);
  provenance["orbs.bad_samples"] = std::to_string(rendered.sum.bad_samples);
  provenance["orbs.cpu"] = run::this_host().cpu;
  provenance["orbs.noise_psnr_srgb8_db"] = fmt::format("{:.2f}", rendered.noise.psnr_db);
  provenance["orbs.noise_mean"] = fmt::format("{:.2g}", rendered.noise.mean);
  provenance["orbs.noise_tile"] = fmt::format("{:.2g}", rendered.noise.tile);
  stamp_origin(wanted, reason, image);
  for (const auto& [name, share] : path_shares(rendered.image))
    provenance["orbs.path." + name] = fmt::format("{:.6g}", share);
}

// The image as a reader of the file will see it: half floats round small numbers.
image::Image as_stored(const image::Image& image, image::Precision precision) {
  const ScratchFolder scratch("orbs-reference");
  image::write_exr(image, scratch.path() / "stored.exr", precision);
  return image::read_image(scratch.path() / "stored.exr");
}

void write_reference(image::Image image,
                     const WantedReference& wanted,
                     const std::string& reason,
                     image::Precision precision) {
  image.attributes["orbs.image_hash"] = judge::image_hash(as_stored(image, precision));
  std::error_code ignored;
  if (std::filesystem::exists(wanted.target, ignored)) note_replaced(wanted.target, reason);
  image::write_exr(image, wanted.target, precision);
  auto hashes = results::read_image_hashes(wanted.target.parent_path());
  hashes[wanted.target.stem().string()] = image.attributes["orbs.image_hash"];
  results::write_image_hashes(hashes, wanted.target.parent_path());
}

}  // namespace

std::map<std::string, double> path_shares(const image::Image& image) {
  std::vector<double> sums(image.channel_count());
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    sums[i % sums.size()] += static_cast<double>(image.pixels[i]);
  double whole = 0;
  std::map<std::string, double> shares;
  for (std::size_t c = 0; c < sums.size(); ++c) {
    const std::string_view name = image.channels[c];
    if (name == "R" || name == "G" || name == "B") whole += sums[c];
    if (name.starts_with("path.") && name.size() > 7)
      shares[std::string(name.substr(5, name.size() - 7))] += sums[c];
  }
  for (auto& [name, share] : shares) share = whole > 0 ? share / whole : 0;
  return shares;
}

image::Image shortened_image(const image::Image& image) {
  std::vector<std::string> channels{"R", "G", "B", "variance.R", "variance.G", "variance.B"};
  // S0 is the colour itself.
  for (const auto& name : image.channels)
    if ((name.starts_with("S") && !name.starts_with("S0.")) || image::is_layer_channel(name))
      channels.push_back(name);
  auto out = image::make_image(image.width, image.height, channels);
  out.attributes = image.attributes;
  const auto colour = image::select_rgb(image, "");
  const auto variance = image::select_rgb(image, "variance.");
  for (std::size_t pixel = 0; pixel < out.pixel_count(); ++pixel)
    for (std::size_t c = 0; c < 3; ++c) {
      const float mean = colour.pixels[3 * pixel + c];
      const float spread = variance.pixels[3 * pixel + c];
      out.pixels[channels.size() * pixel + c] =
          spread == 0 ? mean : image::rounded_to_bits(mean, kColourBits);
      out.pixels[channels.size() * pixel + 3 + c] = image::rounded_to_bits(spread, kVarianceBits);
    }
  for (std::size_t c = 6; c < channels.size(); ++c) {
    const auto from = static_cast<std::size_t>(image::channel_index(image, channels[c]));
    for (std::size_t pixel = 0; pixel < out.pixel_count(); ++pixel) {
      const float value = image.pixels[image.channel_count() * pixel + from];
      out.pixels[channels.size() * pixel + c] =
          image::stays_float(channels[c]) ? value : image::rounded_to_bits(value, kColourBits);
    }
  }
  return out;
}

image::Precision precision_of(const image::Image& image) {
  constexpr float kStep = 1.0F / 2048;  // half of the last of 11 bits, for colours that are not rounded
  const auto is_half = [](float x) {
    return std::fabs(x) <= image::kLargestHalf &&
           std::fabs(image::float_of_half(image::half_bits(x)) - x) <= kStep * std::fabs(x);
  };
  bool fits = true;
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    fits = fits &&
           (image::is_layer_channel(image.channels[i % image.channel_count()]) || is_half(image.pixels[i]));
  return fits ? image::Precision::Half : image::Precision::Float;
}

void store_reference(const RenderedReference& rendered,
                     const WantedReference& wanted,
                     const std::string& reason) {
  auto image = shortened_image(rendered.image);
  const auto precision = precision_of(image);
  stamp(rendered, wanted, reason, image);
  write_reference(std::move(image), wanted, reason, precision);
}

void store_analytic_reference(const image::Image& computed,
                              const WantedReference& wanted,
                              const std::string& reason) {
  auto image = computed;
  image.attributes["orbs.kind"] = "analytic";
  image.attributes["orbs.program"] = "orbs reference";
  image.attributes["orbs.law"] = wanted.analytic->law;
  image.attributes["orbs.source"] = wanted.analytic->source;
  image.attributes["orbs.noise_psnr_srgb8_db"] = "inf";
  stamp_origin(wanted, reason, image);
  write_reference(std::move(image), wanted, reason, image::Precision::Float);
}

int note_image_hashes(const std::filesystem::path& references) {
  auto hashes = results::read_image_hashes(references);
  int noted = 0;
  for (const auto& entry : std::filesystem::directory_iterator(references)) {
    if (entry.path().extension() != ".exr") continue;
    auto& hash = hashes[entry.path().stem().string()];
    if (!hash.empty()) continue;
    hash = judge::image_hash(image::read_image(entry.path()));
    ++noted;
  }
  if (noted > 0) results::write_image_hashes(hashes, references);
  return noted;
}

}  // namespace orbs::references
