#include "judge/nearest_reading.h"

#include "image/radiance.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace orbs::judge {

namespace {

constexpr std::array kColours{"R", "G", "B"};

// The colours of an image and of its reference, and the steps.
struct Channels {
  std::array<std::size_t, 3> result{};
  std::array<std::size_t, 3> steps{};
  std::array<std::size_t, 3> reference{};
};

std::optional<Channels> channels_of(const image::Image& result, const image::Image& reference) {
  Channels channels;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::array found{image::channel_index(result, kColours.at(c)),
                           image::channel_index(result, image::kRgbeSteps.at(c)),
                           image::channel_index(reference, kColours.at(c))};
    if (std::any_of(found.begin(), found.end(), [](int index) { return index < 0; })) return std::nullopt;
    channels.result.at(c) = static_cast<std::size_t>(found[0]);
    channels.steps.at(c) = static_cast<std::size_t>(found[1]);
    channels.reference.at(c) = static_cast<std::size_t>(found[2]);
  }
  return channels;
}

// The largest of three colours has a mantissa of at least 128, or 64 where COLORCORR halves one of them. More
// than a step of that is none of this format, whatever a file says.
float believable(float step, const image::Image& result, const Channels& channels, std::size_t pixel) {
  constexpr float kSmallestMantissa = 64;
  float largest = 0;
  for (const auto channel : channels.result)
    largest = std::max(largest, result.pixels[pixel * result.channel_count() + channel]);
  return step > 0 && step <= largest / kSmallestMantissa ? step : 0;
}

// Calls take(pixel, colour, value, value of the reference, step) for each that has a step.
template <typename Take>
void for_each_step(const image::Image& result,
                   const image::Image& reference,
                   const Channels& channels,
                   const Take& take) {
  for (std::size_t pixel = 0; pixel < result.pixel_count(); ++pixel)
    for (std::size_t c = 0; c < 3; ++c) {
      const float* values = &result.pixels[pixel * result.channel_count()];
      const float step = believable(values[channels.steps.at(c)], result, channels, pixel);
      const float expected = reference.pixels[pixel * reference.channel_count() + channels.reference.at(c)];
      if (step > 0) take(pixel, c, values[channels.result.at(c)], expected, step);
    }
}

// By the mean of how many steps the reference lies above the image: 0 where its writer has rounded, a half
// where it has cut off. Far errors are none of the format's, and count alike on both sides.
bool is_cut_off(const image::Image& result, const image::Image& reference, const Channels& channels) {
  constexpr double kBetween = 0.25;
  constexpr double kFarthest = 1.75;
  double sum = 0;
  for_each_step(result, reference, channels, [&](auto, auto, float value, float expected, float step) {
    const double steps =
        (static_cast<double>(expected) - static_cast<double>(value)) / static_cast<double>(step);
    sum += std::clamp(steps - kBetween, -kFarthest, kFarthest);
  });
  return sum > 0;
}

}  // namespace

std::optional<image::Image> nearest_reading(const image::Image& result, const image::Image& reference) {
  const auto channels = channels_of(result, reference);
  if (!channels || result.width != reference.width || result.height != reference.height) return std::nullopt;
  const float given_back = is_cut_off(result, reference, *channels) ? 0.5F : 0;
  auto read = result;
  for_each_step(result, reference, *channels,
                [&](std::size_t pixel, std::size_t c, float value, float expected, float step) {
                  constexpr float kKept = 15.0F / 16;
                  const float middle = value + given_back * step;
                  read.pixels[pixel * read.channel_count() + channels->result.at(c)] =
                      middle + kKept * std::clamp(expected - middle, -step / 2, step / 2);
                });
  return read;
}

}  // namespace orbs::judge
