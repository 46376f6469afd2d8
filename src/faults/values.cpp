#include "faults/values.h"

#include "base/in_double.h"
#include "faults/pixels.h"
#include "image/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace orbs::faults {

namespace {

using image::Image;

// The variance follows by the slope as a quotient: the sRGB curve has a kink, and no variance needs more.
template <typename Map>
Image with_curve(const Image& image, Map map) {
  return with_each_value(image, [&](float& value, float& variance) {
    constexpr float kStep = 1e-3F;
    const float slope = (map(value + kStep) - map(value - kStep)) / (2 * kStep);
    value = map(value);
    variance *= slope * slope;
  });
}

float power(float value, float exponent) {
  return std::copysign(in_double::pow(std::fabs(value), exponent), value);
}

float encode_22(float value) { return power(value, 1 / 2.2F); }
float decode_22(float value) { return power(value, 2.2F); }
float clamp_and_encode(float value) { return image::srgb_encode(std::clamp(value, 0.0F, 1.0F)); }

struct KnownCurve {
  const char* text;
  float (*map)(float);
  std::optional<Curve::Kind> inverse;
};

// In the order of Curve::Kind.
constexpr std::array<KnownCurve, 5> kCurves{
    {{"encoded for the screen (sRGB), not linear", image::srgb_encode, Curve::Kind::SrgbDecoded},
     {"decoded from sRGB though it was linear", image::srgb_decode, Curve::Kind::SrgbEncoded},
     {"encoded for the screen (gamma 2.2), not linear", encode_22, Curve::Kind::Gamma22Decoded},
     {"decoded from gamma 2.2 though it was linear", decode_22, Curve::Kind::Gamma22Encoded},
     {"encoded for the screen (sRGB) and clamped to 1, not linear", clamp_and_encode, std::nullopt}}};

const KnownCurve& known(Curve::Kind kind) { return kCurves.at(static_cast<std::size_t>(kind)); }

}  // namespace

Image Factor::apply(const Image& image) const {
  const auto factor = static_cast<float>(by);
  return with_each_value(image, [&](float& value, float& variance) {
    value *= factor;
    variance *= factor * factor;
  });
}

Image Factor::undo(const Image& image) const {
  const auto factor = static_cast<float>(by);
  return with_each_value(image, [&](float& value, float& variance) {
    value /= factor;
    variance /= factor * factor;
  });
}

// Radiance and exitance differ by pi, and halves, quarters and powers of ten are what is forgotten most.
std::string Factor::text() const {
  constexpr double kPi = std::numbers::pi;
  struct Named {
    const char* name;
    double value;
  };
  constexpr std::array<Named, 12> kNamed{{{"pi", kPi},
                                          {"1/pi", 1 / kPi},
                                          {"2 pi", 2 * kPi},
                                          {"1/(2 pi)", 1 / (2 * kPi)},
                                          {"4 pi", 4 * kPi},
                                          {"1/(4 pi)", 1 / (4 * kPi)},
                                          {"2", 2},
                                          {"1/2", 0.5},
                                          {"4", 4},
                                          {"1/4", 0.25},
                                          {"10", 10},
                                          {"1/10", 0.1}}};
  constexpr double kNear = 0.01;
  for (const auto& [name, value] : kNamed)
    if (std::fabs(by / value - 1) < kNear) return fmt::format("multiplied by {}", name);
  return fmt::format("multiplied by {:.4g}", by);
}

Image Offset::apply(const Image& image) const {
  const auto offset = static_cast<float>(by);
  return with_each_value(image, [&](float& value, float&) { value += offset; });
}

Image Offset::undo(const Image& image) const { return Offset{-by}.apply(image); }

std::string Offset::text() const { return fmt::format("off by {:+.3g} in every pixel", by); }

Image Curve::apply(const Image& image) const { return with_curve(image, known(kind).map); }

std::optional<Image> Curve::undo(const Image& image) const {
  const auto& inverse = known(kind).inverse;
  return inverse ? std::optional(with_curve(image, known(*inverse).map)) : std::nullopt;
}

std::string Curve::text() const { return known(kind).text; }

Image Clamp::apply(const Image& image) const {
  return with_each_value(image, [this](float& value, float& variance) {
    if (value <= at) return;
    value = at;
    variance = 0;
  });
}

std::string Clamp::text() const { return fmt::format("clamped at {:.4g}", at); }

Image Contrast::apply(const Image& image) const {
  return with_each_value(image, [this](float& value, float& variance) {
    value = static_cast<float>(middle + by * (static_cast<double>(value) - middle));
    variance *= static_cast<float>(by * by);
  });
}

Image Power::apply(const Image& image) const {
  return with_curve(image, [this](float value) {
    if (value <= 0) return value;
    return static_cast<float>(middle * std::pow(static_cast<double>(value) / middle, exponent));
  });
}

// A step has no slope, and what rounding takes away is far below the noise: the variance stays.
Image Steps::apply(const Image& image) const {
  const auto rounded = [this](float value) {
    if (value < 0 || value > 1) return value;
    const auto encoded = static_cast<double>(image::srgb_encode(value));
    return image::srgb_decode(static_cast<float>(std::round(encoded * levels) / levels));
  };
  return with_each_value(image, [&](float& value, float&) {
    value = kind == Kind::RoundedAsSrgb
                ? rounded(value)
                : static_cast<float>(std::floor(static_cast<double>(value) * levels) / levels);
  });
}

Image Constant::apply(const Image& image) const {
  const auto mean = static_cast<float>(mean_radiance(image));
  return with_each_value(image, [&](float& value, float& variance) {
    value = mean;
    variance = 0;
  });
}

Image InvalidPixel::apply(const Image& image) const {
  Image out = image;
  out.at(image.width / 2, image.height / 2, colour_index(image, 1)) = std::numeric_limits<float>::quiet_NaN();
  return out;
}

}  // namespace orbs::faults
