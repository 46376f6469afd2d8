#pragma once

#include "base/random.h"
#include "judge/judge.h"

#include <cstdint>
#include <string>
#include <vector>

/// Small images and a case for the tests of judging.
namespace orbs::judge_images {

// Uniform grey with a variance of the mean; `variance` < 0 leaves the variance out.
inline image::Image grey(float value, float variance = -1) {
  auto image = image::make_image(
      16, 12,
      variance < 0 ? std::vector<std::string>{"R", "G", "B"}
                   : std::vector<std::string>{"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = i % image.channel_count() < 3 ? value : variance;
  return image;
}

inline image::Image grey_32(float value) {
  auto image = image::make_image(32, 32, {"R", "G", "B"});
  image.pixels.assign(image.pixels.size(), value);
  return image;
}

// 32 x 32 px of mean `value`, each off by `deviation` to one side or the other at random, and a variance that
// says so.
inline image::Image noisy_grey(float value, float deviation, std::uint64_t seed = 1) {
  auto image = image::make_image(32, 32, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const bool is_up = unit_random(mix(seed, i / 6)) < 0.5;
    image.pixels[i] = i % 6 < 3 ? value + (is_up ? deviation : -deviation) : deviation * deviation;
  }
  return image;
}

inline registry::Case one_case() {
  registry::Case made;
  made.requirement = "M1";
  made.scenes = {{"a", "a.json", 4}, {"b", "b.json", 4}};
  made.gates = {{"psnr_srgb8", 35}};
  return made;
}

inline results::TargetRecord judged(const registry::Case& by,
                                    const image::Image& result,
                                    const image::Image& reference,
                                    const std::string& image = "a") {
  results::TargetRecord record;
  record.target = image;
  judge::judge_image(by, result, {"a.exr", reference, ""}, {}, record);
  return record;
}

}  // namespace orbs::judge_images
