#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

/// The scenes of the suite gi as numbers, for an estimate that shares no code with orbs. y is up, in metres.
namespace independent {

struct Vec {
  double x = 0, y = 0, z = 0;
};
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec unit(Vec a) { return (1 / std::sqrt(dot(a, a))) * a; }

constexpr double kPi = std::numbers::pi;
constexpr double kReflectance = 0.5;  // of all that is diffuse
constexpr int kPixels = 256;          // of the image, either way

enum class Kind { Diffuse, Mirror, Lamp };  // a lamp has a radiance of 1 in front, on the side of u x v

// A parallelogram, a triangle (half of one), or a ball whose centre is the corner.
struct Face {
  enum class Form { Rectangle, Triangle, Ball };
  Vec corner, u, v;
  Kind kind = Kind::Diffuse;
  Form form = Form::Rectangle;
  double radius = 0;

  Vec at(double s, double t) const { return corner + s * u + t * v; }
  Vec normal() const { return unit(cross(u, v)); }
  double area() const { return std::sqrt(dot(cross(u, v), cross(u, v))); }
};

struct Scene {
  std::vector<Face> faces;
  std::vector<int> lamps;  // among the faces
  std::vector<int> card;   // faces that are a second source: lamps light them, and they light the scene
  int depth = std::numeric_limits<int>::max();  // reflections of a path, at most
  Vec eye, target, up{0, 1, 0};
};

/// By its name in the suite: caustic-cube-3-k2 has three reflections at most and a card of half the size. No
/// faces for a name that is not known; emission is not, whose image has a closed form.
Scene scene_of(std::string name);

}  // namespace independent
