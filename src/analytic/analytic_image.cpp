#include "analytic/analytic_image.h"

#include "analytic/direct_light.h"
#include "analytic/lens.h"
#include "analytic/plastic.h"
#include "analytic/polarised_planes.h"
#include "analytic/ray.h"
#include "analytic/reflectance.h"
#include "analytic/textured_plane.h"
#include "base/error.h"
#include "base/parallel.h"
#include "scene/camera_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace orbs::analytic {

namespace {

using Rgb = std::array<double, 3>;
// At a point of the image, in pixels from its upper left corner.
using RadianceAt = std::function<Rgb(double x, double y)>;
using RadianceAlong = std::function<Rgb(const Ray&)>;

Rgb grey(double value) { return {value, value, value}; }

double albedo(const registry::OrenNayarBrdf& brdf, double reflectance, double theta) {
  return reflectance * oren_nayar_albedo(brdf.roughness, theta);
}
double albedo(const registry::GgxBrdf& brdf, double reflectance, double theta) {
  return reflectance * directional_albedo(ggx_brdf(brdf.alpha), std::cos(theta));
}
double albedo(const registry::MetalBrdf& brdf, double reflectance, double theta) {
  return directional_albedo(metal_brdf(reflectance, brdf.alpha), std::cos(theta));
}
double albedo(const registry::MetallicRoughnessBrdf& brdf, double reflectance, double theta) {
  return directional_albedo(metallic_roughness_brdf(reflectance, brdf.metallic, brdf.roughness),
                            std::cos(theta));
}
double albedo(const registry::PhongBrdf& brdf, double reflectance, double theta) {
  return directional_albedo(phong_brdf(reflectance, brdf.exponent), std::cos(theta));
}

/// The directional albedo of a ball's BRDF at an angle to the normal.
using AlbedoAt = std::function<double(double theta)>;

template <typename Brdf>
AlbedoAt albedo_of(const Brdf& brdf, double reflectance) {
  return [=](double theta) { return albedo(brdf, reflectance, theta); };
}
AlbedoAt albedo_of(const registry::PlasticBrdf& brdf, double reflectance) {
  return [plastic = PlasticAlbedo({reflectance, brdf.ior, brdf.is_nonlinear, brdf.alpha})](double theta) {
    return plastic.at(std::cos(theta));
  };
}

/// The directional albedo at even steps of the angle, linear between them: (pi / 2 / 512)^2 / 8 = 1.2e-6 of
/// its second derivative off.
class AlbedoTable {
 public:
  explicit AlbedoTable(const registry::AlbedoBall& ball) {
    const auto albedo_at =
        std::visit([&](const auto& brdf) { return albedo_of(brdf, ball.reflectance); }, ball.brdf);
    for (int i = 0; i <= kSteps; ++i) values_.push_back(albedo_at(i * std::numbers::pi / 2 / kSteps));
  }
  double at(double theta) const {
    const double place = std::min(theta / (std::numbers::pi / 2), 1.0) * kSteps;
    const auto below = std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(kSteps - 1));
    return values_[below] + (place - static_cast<double>(below)) * (values_[below + 1] - values_[below]);
  }

 private:
  static constexpr int kSteps = 512;
  std::vector<double> values_;
};

Rgb albedo_ball(const registry::AlbedoBall& ball, const AlbedoTable& albedo, const Ray& ray) {
  const auto to_centre = ball.centre - ray.origin;
  const double aside = length(cross(to_centre, ray.direction)) / ball.radius_m;
  return grey(aside < 1 ? albedo.at(std::asin(aside)) : 1);
}

Rgb sky_ball(const registry::SkyBall& ball, const Ray& ray) {
  const auto from_centre = ray.origin - ball.centre;
  const double along = dot(from_centre, ray.direction);
  const double root = along * along - dot(from_centre, from_centre) + ball.radius_m * ball.radius_m;
  const bool is_met = root > 0;
  if (!is_met && !ball.shows_sky) return {};
  const auto normal =
      (from_centre + ray.direction * (-along - std::sqrt(std::max(root, 0.0)))) / ball.radius_m;
  Rgb out{};
  for (std::size_t c = 0; c < out.size(); ++c) {
    const auto& gradient = ball.gradients.at(c);
    out.at(c) = is_met ? ball.reflectance * (ball.constant.at(c) + 2. / 3 * dot(gradient, normal))
                       : ball.constant.at(c) + dot(gradient, ray.direction);
  }
  return out;
}

// Unfolded, the ray goes straight on and crosses a mirror at each odd multiple of the half width.
double mirror_corridor(const registry::MirrorCorridor& corridor, const Ray& ray) {
  const double distance = (corridor.floor_m - ray.origin.y) / ray.direction.y;
  if (!(distance > 0)) return 0;
  const double x = (ray.origin.x + distance * ray.direction.x) / corridor.half_width_m;
  return std::pow(corridor.reflectance, std::floor((std::fabs(x) + 1) / 2));
}

// S0 is the same in all frames.
Vec3d any_across(const Ray& ray) {
  return std::fabs(ray.direction.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
}

struct RadianceOf {
  RadianceAlong operator()(const registry::ConstantImage& image) const {
    return [value = image.value](const Ray&) { return value; };
  }
  RadianceAlong operator()(const registry::DirectLight& image) const {
    return [image](const Ray& ray) { return grey(direct_light(image, ray)); };
  }
  RadianceAlong operator()(const registry::FresnelPlane& image) const {
    return [image](const Ray& ray) { return fresnel_plane(image, ray); };
  }
  RadianceAlong operator()(const registry::PolarisedPlanes& image) const {
    return [image](const Ray& ray) { return grey(polarised_planes(image, ray, any_across(ray)).front()); };
  }
  RadianceAlong operator()(const registry::AlbedoBall& image) const {
    return [image, albedo = AlbedoTable(image)](const Ray& ray) { return albedo_ball(image, albedo, ray); };
  }
  RadianceAlong operator()(const registry::SkyBall& image) const {
    return [image](const Ray& ray) { return sky_ball(image, ray); };
  }
  RadianceAlong operator()(const registry::MirrorCorridor& image) const {
    return [image](const Ray& ray) { return grey(mirror_corridor(image, ray)); };
  }
  RadianceAlong operator()(const registry::TexturedPlane& image) const {
    return [image](const Ray& ray) { return textured_plane(image, ray); };
  }
};

/// A square of the image plane, in pixels.
struct Cell {
  double x = 0;
  double y = 0;
  double side = 1;
};

class PixelMean {
 public:
  explicit PixelMean(RadianceAt radiance, double tolerance)
      : radiance_(std::move(radiance)), tolerance_(tolerance) {}

  /// The mean over the cell by the rules of Gauss and Lobatto with three points each way; where these do not
  /// agree, or the values differ much, the mean of the quarters. Lobatto's rule has the corners, of which a
  /// straight edge across the cell parts some from the others. An edge is followed to 2^-7 of a pixel.
  Rgb operator()(const Cell& cell, int depth = 0) const {
    constexpr int kDeepest = 7;
    static const auto gauss = gauss_legendre(3);
    static const Quadrature lobatto{{1e-9, 0.5, 1 - 1e-9}, {1. / 6, 4. / 6, 1. / 6}};
    const auto mean = estimate(cell, gauss).mean;
    if (depth == kDeepest || is_smooth(estimate(cell, lobatto), mean, tolerance_)) return mean;
    const double half = cell.side / 2;
    Rgb sum{};
    for (const auto& quarter :
         {Cell{cell.x, cell.y, half}, Cell{cell.x + half, cell.y, half}, Cell{cell.x, cell.y + half, half},
          Cell{cell.x + half, cell.y + half, half}}) {
      const auto part = (*this)(quarter, depth + 1);
      for (std::size_t c = 0; c < 3; ++c) sum.at(c) += part.at(c) / 4;
    }
    return sum;
  }

 private:
  struct Estimate {
    Rgb mean{};
    Rgb least{};
    Rgb largest{};
  };

  // Gauss's rule is off by the sixth power of the side where Lobatto's is by the fourth. Across an edge the
  // two may agree by chance, but then the values differ.
  static bool is_smooth(const Estimate& lobatto, const Rgb& mean, double tolerance) {
    constexpr double kEven = 0.2;
    for (std::size_t c = 0; c < 3; ++c)
      if (!(std::fabs(lobatto.mean.at(c) - mean.at(c)) <= tolerance * mean.at(c)) ||
          lobatto.largest.at(c) - lobatto.least.at(c) > kEven * lobatto.largest.at(c))
        return false;
    return true;
  }

  Estimate estimate(const Cell& cell, const Quadrature& rule) const {
    Estimate all;
    all.least.fill(std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
      for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
        const auto value = radiance_(cell.x + cell.side * rule.nodes[i], cell.y + cell.side * rule.nodes[j]);
        for (std::size_t c = 0; c < 3; ++c) {
          all.mean.at(c) += rule.weights[i] * rule.weights[j] * value.at(c);
          all.least.at(c) = std::min(all.least.at(c), value.at(c));
          all.largest.at(c) = std::max(all.largest.at(c), value.at(c));
        }
      }
    return all;
  }

  RadianceAt radiance_;
  double tolerance_;  // of each cell
};

RadianceAt radiance_at(const registry::AnalyticImage& formula, const scene::Camera& camera) {
  const auto frame = scene::camera_frame(camera);
  if (scene::has_lens(camera) && !std::holds_alternative<registry::ConstantImage>(formula)) {
    const auto* image = std::get_if<registry::DirectLight>(&formula);
    if (image == nullptr) throw InputError("the formula is not known through a lens");
    return [lens = ThinLensImage(*image, camera)](double x, double y) { return grey(lens.at(x, y)); };
  }
  return [&camera, frame, along = std::visit(RadianceOf{}, formula)](double x, double y) {
    const auto [origin, direction] = scene::camera_ray(camera, frame, x, y);
    return along({origin, normalised(direction)});
  };
}

// S0 + S_k, which is below zero nowhere: twice what a filter lets through.
RadianceAt filtered_radiance_at(const registry::PolarisedPlanes& formula,
                                const scene::Camera& camera,
                                std::size_t k) {
  if (std::holds_alternative<scene::LatitudeLongitude>(camera.projection))
    throw InputError("the formula has one direction to the right, which this projection has not");
  return [&formula, &camera, k, frame = scene::camera_frame(camera)](double x, double y) {
    const auto [origin, direction] = scene::camera_ray(camera, frame, x, y);
    const auto stokes = polarised_planes(formula, {origin, normalised(direction)}, frame.right);
    return grey(stokes.front() + stokes.at(k));
  };
}

// Into the three channels from `first` on of each pixel's `channels`.
void write_means(const PixelMean& mean,
                 std::span<const std::array<int, 2>> pixels,
                 std::size_t channels,
                 std::size_t first,
                 std::vector<float>& values) {
  for_each_index(static_cast<int>(pixels.size()), 0, [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    const auto [x, y] = pixels[i];
    const auto value = mean({static_cast<double>(x), static_cast<double>(y), 1});
    for (std::size_t c = 0; c < 3; ++c) values[channels * i + first + c] = static_cast<float>(value.at(c));
  });
}

}  // namespace

std::vector<std::string> analytic_channels(const registry::AnalyticImage& formula) {
  std::vector<std::string> channels{"R", "G", "B"};
  if (!std::holds_alternative<registry::PolarisedPlanes>(formula)) return channels;
  for (const char* layer : {"S1.", "S2.", "S3."})
    for (const char* colour : {"R", "G", "B"}) channels.push_back(std::string(layer) + colour);
  return channels;
}

std::vector<float> analytic_pixels(const registry::AnalyticImage& formula,
                                   const scene::Camera& camera,
                                   std::span<const std::array<int, 2>> pixels) {
  const auto channels = analytic_channels(formula).size();
  // Through a lens the rims of the blur cross most pixels: there the light begins as the power 3/2 of the
  // distance, which no rule of quadrature likes.
  const double tolerance = scene::has_lens(camera) ? 1e-4 : 1e-5;
  std::vector<float> values(channels * pixels.size());
  write_means(PixelMean(radiance_at(formula, camera), tolerance), pixels, channels, 0, values);
  const auto* polarised = std::get_if<registry::PolarisedPlanes>(&formula);
  if (polarised == nullptr) return values;
  for (std::size_t k = 1; k <= 3; ++k) {
    write_means(PixelMean(filtered_radiance_at(*polarised, camera, k), tolerance), pixels, channels, 3 * k,
                values);
    for (std::size_t i = 0; i < pixels.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) values[channels * i + 3 * k + c] -= values[channels * i + c];
  }
  return values;
}

image::Image analytic_image(const registry::AnalyticImage& formula, const scene::Camera& camera) {
  auto image = image::make_image(camera.width_px, camera.height_px, analytic_channels(formula));
  std::vector<std::array<int, 2>> pixels;
  pixels.reserve(image.pixel_count());
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) pixels.push_back({x, y});
  image.pixels = analytic_pixels(formula, camera, pixels);
  return image;
}

}  // namespace orbs::analytic
