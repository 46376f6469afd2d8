#include "metrics/layer_faults.h"

#include "image/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <fmt/format.h>

namespace orbs::metrics {

namespace {

using Parts = std::array<double, 3>;

// The pixels that tell, as vectors of the layer's channels.
struct Points {
  std::size_t parts = 1;
  std::vector<Parts> result;
  std::vector<Parts> reference;
  std::vector<double> radius_squared;  // from the middle of the image, in px
};

double range_of(const ComparedLayer& layer) {
  double range = 0;
  for (const auto& channel : layer.channels) {
    const auto [least, most] = std::minmax_element(channel.reference.begin(), channel.reference.end());
    range = std::max(range, static_cast<double>(*most) - static_cast<double>(*least));
  }
  return range;
}

Points points_of(const PairSamples& samples, const ComparedLayer& layer) {
  constexpr double kEven = 0.05;
  const double most_range = kEven * range_of(layer);
  Points points{.parts = layer.channels.size(), .result = {}, .reference = {}, .radius_squared = {}};
  for (std::size_t i = 0; i < samples.pixel_count(); ++i) {
    if (samples.included[i] == 0 || samples.layers->coverage[i] < 1) continue;
    Parts result{};
    Parts reference{};
    bool is_even = true;
    for (std::size_t c = 0; c < points.parts; ++c) {
      const auto& channel = layer.channels[c];
      result.at(c) = static_cast<double>(channel.result[i]);
      reference.at(c) = static_cast<double>(channel.reference[i]);
      is_even = is_even && std::isfinite(channel.result[i]) &&
                static_cast<double>(channel.most[i]) - static_cast<double>(channel.least[i]) <= most_range;
    }
    if (!is_even) continue;
    const int column = static_cast<int>(i) % samples.width;
    const int row = static_cast<int>(i) / samples.width;
    const double x = column + 0.5 - samples.width / 2.0;
    const double y = row + 0.5 - samples.height / 2.0;
    points.result.push_back(result);
    points.reference.push_back(reference);
    points.radius_squared.push_back(x * x + y * y);
  }
  return points;
}

double squared_distance(const Parts& a, const Parts& b) {
  double sum = 0;
  for (std::size_t c = 0; c < a.size(); ++c) sum += (a.at(c) - b.at(c)) * (a.at(c) - b.at(c));
  return sum;
}

// What the layer would be by the mistake; `result` is what it is.
using Mistake = std::function<Parts(const Parts& reference, double radius_squared, const Parts& result)>;

double squared_error(const Points& points, const Mistake& mistake) {
  double sum = 0;
  for (std::size_t i = 0; i < points.result.size(); ++i)
    sum += squared_distance(points.result[i],
                            mistake(points.reference[i], points.radius_squared[i], points.result[i]));
  return sum;
}

Mistake each(std::function<double(double)> of_one) {
  return [of_one = std::move(of_one)](const Parts& reference, double, const Parts&) {
    Parts out{};
    for (std::size_t c = 0; c < out.size(); ++c) out.at(c) = of_one(reference.at(c));
    return out;
  };
}

struct Named {
  std::string name;
  Mistake mistake;
};

// By least squares: the factor of another unit.
double fitted_factor(const Points& points) {
  double product = 0;
  double norm = 0;
  for (std::size_t i = 0; i < points.result.size(); ++i)
    for (std::size_t c = 0; c < points.parts; ++c) {
      product += points.result[i].at(c) * points.reference[i].at(c);
      norm += points.reference[i].at(c) * points.reference[i].at(c);
    }
  return norm > 0 ? product / norm : 1;
}

// Of (result / reference)^2 - 1 = k r^2.
double fitted_curvature(const Points& points) {
  double product = 0;
  double norm = 0;
  for (std::size_t i = 0; i < points.result.size(); ++i) {
    if (points.reference[i][0] == 0) continue;
    const double ratio = points.result[i][0] / points.reference[i][0];
    product += (ratio * ratio - 1) * points.radius_squared[i];
    norm += points.radius_squared[i] * points.radius_squared[i];
  }
  return norm > 0 ? std::max(0.0, product / norm) : 0;
}

std::vector<Named> depth_mistakes(const Points& points) {
  const double k = fitted_curvature(points);
  const double factor = fitted_factor(points);
  return {{"along the ray and not along the axis",
           [k](const Parts& z, double r2, const Parts&) {
             return Parts{z[0] * std::sqrt(1 + k * r2), 0, 0};
           }},
          {fmt::format("{:.4g} times what it should be: another unit", factor),
           each([factor](double z) { return factor * z; })},
          {"the reciprocal of what it should be", each([](double z) { return z == 0 ? 0 : 1 / z; })}};
}

std::vector<Named> uv_mistakes() {
  return {{"counted from the other end in v",
           [](const Parts& uv, double, const Parts&) {
             return Parts{uv[0], 1 - uv[1], 0};
           }},
          {"swapped in u and v",
           [](const Parts& uv, double, const Parts&) {
             return Parts{uv[1], uv[0], 0};
           }},
          {"without whole numbers", each([](double t) { return t - std::floor(t); })}};
}

std::vector<Named> albedo_mistakes() {
  const auto encoded = [](double value) {
    return static_cast<double>(image::srgb_encode(static_cast<float>(std::clamp(value, 0.0, 1.0))));
  };
  const auto decoded = [](double value) {
    return static_cast<double>(image::srgb_decode(static_cast<float>(std::clamp(value, 0.0, 1.0))));
  };
  return {{"encoded as sRGB", each(encoded)}, {"decoded as sRGB once too often", each(decoded)}};
}

Parts negated(const Parts& n) { return {-n[0], -n[1], -n[2]}; }

std::vector<Named> normal_mistakes() {
  const auto either_side = [](const Parts& n, double, const Parts& result) {
    return squared_distance(result, n) <= squared_distance(result, negated(n)) ? n : negated(n);
  };
  return {{"without signs, in absolute values", each([](double n) { return std::fabs(n); })},
          {"turned to the far side", each([](double n) { return -n; })},
          {"halved and moved into [0, 1], as for the screen", each([](double n) { return 0.5 * n + 0.5; })},
          {"swapped in y and z",
           [](const Parts& n, double, const Parts&) {
             return Parts{n[0], n[2], n[1]};
           }},
          {"not turned to the viewer everywhere", either_side}};
}

using Matrix = std::array<Parts, 3>;

Parts times(const Matrix& m, const Parts& v) {
  Parts out{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) out.at(r) += m.at(r).at(c) * v.at(c);
  return out;
}

// The rotation that leads the reference closest to the result: the polar factor of sum(result reference^T),
// by Higham's iteration X <- (X + X^-T) / 2. The identity where the vectors span no space.
Matrix fitted_rotation(const Points& points) {
  Matrix x{};
  for (std::size_t i = 0; i < points.result.size(); ++i)
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) x.at(r).at(c) += points.result[i].at(r) * points.reference[i].at(c);
  constexpr Matrix kIdentity{Parts{1, 0, 0}, Parts{0, 1, 0}, Parts{0, 0, 1}};
  constexpr int kSteps = 40;
  for (int step = 0; step < kSteps; ++step) {
    Matrix cofactors{};
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) {
        const auto at = [&](std::size_t i, std::size_t j) { return x.at((r + i) % 3).at((c + j) % 3); };
        cofactors.at(r).at(c) = at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
      }
    double determinant = 0;
    for (std::size_t c = 0; c < 3; ++c) determinant += x[0].at(c) * cofactors[0].at(c);
    if (!(std::fabs(determinant) > 0)) return kIdentity;
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c)
        x.at(r).at(c) = (x.at(r).at(c) + cofactors.at(r).at(c) / determinant) / 2;
  }
  return x;
}

Named other_space(const Points& points) {
  const Matrix rotation = fitted_rotation(points);
  const double trace = rotation[0][0] + rotation[1][1] + rotation[2][2];
  const double angle = std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)) * 180 / std::numbers::pi;
  return {fmt::format("in another space, as that of the camera, turned by {:.3g} degrees", angle),
          [rotation](const Parts& n, double, const Parts&) { return times(rotation, n); }};
}

std::vector<Named> mistakes_of(const ComparedLayer& layer, const Points& points) {
  const auto name = layer.layer->name;
  if (name == "depth") return depth_mistakes(points);
  if (name == "uv") return uv_mistakes();
  if (name == "albedo") return albedo_mistakes();
  if (name == "position")
    return {{"relative to another origin or in another unit",
             each([f = fitted_factor(points)](double p) { return f * p; })}};
  if (name != "normal") return {};
  auto mistakes = normal_mistakes();
  mistakes.push_back(other_space(points));
  return mistakes;
}

}  // namespace

std::string layer_fault(const PairSamples& samples, const ComparedLayer& layer) {
  constexpr double kLeft = 0.01;
  const auto points = points_of(samples, layer);
  const double off =
      squared_error(points, [](const Parts& reference, double, const Parts&) { return reference; });
  std::string best;
  double least = kLeft * off;
  for (const auto& [name, mistake] : mistakes_of(layer, points)) {
    const double left = squared_error(points, mistake);
    if (!(left < least)) continue;
    least = left;
    best = name;
  }
  return best;
}

}  // namespace orbs::metrics
