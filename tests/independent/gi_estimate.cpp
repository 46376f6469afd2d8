// Means of parts of the images of the suite gi, by a plain path tracer in double precision. It shares no code
// with any part of orbs and links none: scenes are the numbers of gi_scenes.cpp, every ray is tested against
// every face, lamps are sampled by their area, and random numbers are independent.
//
//   gi-estimate SCENE PATHS SEED [X0 Y0 X1 Y1]...
//
// writes for each rectangle of pixels, or for each of 8 x 8 tiles of the image, as many paths each,
// "x0 y0 x1 y1 mean standard-error".
#include "independent/gi_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

using namespace independent;

namespace {

struct Random {
  std::uint64_t state;
  // SplitMix64 (Steele, Lea and Flood 2014).
  double next() {
    std::uint64_t z = state += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
};

struct Hit {
  int face = -1;
  double distance = std::numeric_limits<double>::infinity();
};

// Distance along a unit direction, infinite where the face is not met. `from` lies on no part of the face: a
// ray does not test the face that it starts from, which is flat, or a ball that it leaves.
double distance_to(const Face& face, Vec from, Vec direction) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (face.form == Face::Form::Ball) {
    const Vec to_centre = face.corner - from;
    const double middle = dot(to_centre, direction);
    const double square = middle * middle - dot(to_centre, to_centre) + face.radius * face.radius;
    if (square < 0 || middle < 0) return kNone;
    return middle - std::sqrt(square);
  }
  const Vec n = cross(face.u, face.v);
  const double slope = dot(n, direction);
  if (slope == 0) return kNone;
  const double distance = dot(n, face.corner - from) / slope;
  if (!(distance > 0)) return kNone;
  const Vec p = from + distance * direction - face.corner;
  const double s = dot(cross(p, face.v), n) / dot(n, n);
  const double t = dot(cross(face.u, p), n) / dot(n, n);
  const bool is_inside =
      s >= 0 && t >= 0 && (face.form == Face::Form::Triangle ? s + t <= 1 : s <= 1 && t <= 1);
  return is_inside ? distance : kNone;
}

Hit nearest(const Scene& scene, Vec from, Vec direction, int start) {
  Hit hit;
  for (int i = 0; i < static_cast<int>(scene.faces.size()); ++i) {
    if (i == start) continue;
    const double distance = distance_to(scene.faces[static_cast<std::size_t>(i)], from, direction);
    if (distance < hit.distance) hit = {i, distance};
  }
  return hit;
}

// A point of a surface that is diffuse, and the normal of the side that is looked at.
struct Point {
  Vec at, normal;
  int face = -1;
};

// A point of the face with equal chance, and cos cos A / d^2 of the light that comes from there, 0 where
// something is between.
double geometry_of(const Scene& scene, const Point& point, int face, Random& random, Vec& chosen) {
  const auto& source = scene.faces[static_cast<std::size_t>(face)];
  const double s = random.next();
  chosen = source.at(s, random.next());
  const Vec to = chosen - point.at;
  const double squared = dot(to, to);
  const Vec direction = (1 / std::sqrt(squared)) * to;
  const double cosines = dot(point.normal, direction) * -dot(source.normal(), direction);
  if (!(dot(point.normal, direction) > 0) || !(cosines > 0)) return 0;
  if (nearest(scene, point.at, direction, point.face).face != face) return 0;
  return cosines * source.area() / squared;
}

// What the point reflects of the light that comes straight from the lamps, each by one point of it.
double lamp_light(const Scene& scene, const Point& point, Random& random) {
  double sum = 0;
  Vec ignored;
  for (const int lamp : scene.lamps) sum += geometry_of(scene, point, lamp, random, ignored);
  return kReflectance / kPi * sum;
}

Vec cosine_direction(Vec normal, Random& random) {
  const Vec a = unit(cross(normal, std::fabs(normal.x) < 0.5 ? Vec{1, 0, 0} : Vec{0, 1, 0}));
  const double turn = 2 * kPi * random.next();
  const double square = random.next();  // of the sine
  return std::sqrt(square) * (std::cos(turn) * a + std::sin(turn) * cross(normal, a)) +
         std::sqrt(1 - square) * normal;
}

// Paths end with the chance that a surface absorbs, so that the others lose nothing. `is_sampled`: the last
// point was diffuse, so that light of lamps was counted there, and of the card what lamps light on it.
double radiance(const Scene& scene, Vec from, Vec direction, Random& random) {
  double light = 0;
  int start = -1;
  bool is_sampled = false;
  for (int reflections = 1;; ++reflections) {
    const Hit hit = nearest(scene, from, direction, start);
    if (hit.face < 0) return light;
    const auto& face = scene.faces[static_cast<std::size_t>(hit.face)];
    from = from + hit.distance * direction;
    start = hit.face;
    const Vec outside = face.form == Face::Form::Ball ? unit(from - face.corner) : face.normal();
    const double cosine = dot(outside, direction);
    if (face.kind == Kind::Lamp) return !is_sampled && cosine < 0 ? light + 1 : light;
    if (reflections > scene.depth) return light;
    if (face.kind == Kind::Mirror) {
      direction = direction - 2 * cosine * outside;
      is_sampled = false;
      continue;
    }
    const Point point{from, cosine < 0 ? outside : -1.0 * outside, hit.face};
    const bool is_card = std::find(scene.card.begin(), scene.card.end(), hit.face) != scene.card.end();
    if (!(is_sampled && is_card)) light += lamp_light(scene, point, random);
    for (std::size_t i = 0; i < scene.card.size() && reflections < scene.depth; ++i) {
      Point on_card{{}, scene.faces[static_cast<std::size_t>(scene.card[i])].normal(), scene.card[i]};
      const double share = geometry_of(scene, point, scene.card[i], random, on_card.at);
      if (share > 0) light += kReflectance / kPi * share * lamp_light(scene, on_card, random);
    }
    if (random.next() >= kReflectance) return light;
    direction = cosine_direction(point.normal, random);
    is_sampled = true;
  }
}

struct Estimate {
  double mean = 0, error = 0;
};

Estimate mean_over(const Scene& scene, const std::array<double, 4>& part, long paths, Random& random) {
  const Vec forward = unit(scene.target - scene.eye);
  const Vec right = unit(cross(forward, scene.up));
  const Vec up = cross(right, forward);
  const double half = std::tan(kPi / 8);  // of 45 degrees
  double sum = 0, squares = 0;
  for (long i = 0; i < paths; ++i) {
    const double x = part[0] + (part[2] - part[0]) * random.next();
    const double y = part[1] + (part[3] - part[1]) * random.next();
    const Vec direction = forward + half * (2 * x / kPixels - 1) * right + half * (1 - 2 * y / kPixels) * up;
    const double light = radiance(scene, scene.eye, unit(direction), random);
    sum += light;
    squares += light * light;
  }
  const double n = static_cast<double>(paths);
  return {sum / n, std::sqrt(std::fmax(0, squares / n - sum / n * sum / n) / n)};
}

}  // namespace

int main(int count, char** words) {
  const Scene scene = count < 4 ? Scene{} : scene_of(words[1]);
  if (scene.faces.empty() || (count - 4) % 4 != 0) {
    std::fputs("gi-estimate SCENE PATHS SEED [X0 Y0 X1 Y1]...; emission is no scene of it\n", stderr);
    return 2;
  }
  const long paths = std::atol(words[2]);
  const auto seed = std::strtoull(words[3], nullptr, 10);
  constexpr int kTiles = 8;  // either way
  const int parts = count > 4 ? (count - 4) / 4 : kTiles * kTiles;
  for (int i = 0; i < parts; ++i) {
    constexpr double kTile = kPixels / kTiles;
    const double left = i % kTiles * kTile, top = i / kTiles * kTile;
    std::array<double, 4> part{left, top, left + kTile, top + kTile};
    for (std::size_t k = 0; k < 4 && count > 4; ++k)
      part[k] = std::atof(words[4 + 4 * i + static_cast<int>(k)]);
    // The part is in the seed, so that its number does not depend on the others.
    const auto corner = static_cast<std::uint64_t>(part[0] * kPixels + part[1]);
    Random random{seed + (corner << 32)};
    const auto found = mean_over(scene, part, paths, random);
    std::printf("%g %g %g %g %.9g %.3g\n", part[0], part[1], part[2], part[3], found.mean, found.error);
  }
  return 0;
}
