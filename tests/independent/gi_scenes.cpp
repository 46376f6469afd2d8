#include "independent/gi_scenes.h"

#include <utility>

namespace independent {

namespace {

// Six faces that look outwards. The half axes are right-handed.
void add_box(Scene& scene, Vec centre, Vec a, Vec b, Vec c, Kind kind = Kind::Diffuse) {
  for (int i = 0; i < 3; ++i) {
    const Vec low = centre - a - b - c;
    scene.faces.push_back({low, 2 * c, 2 * b, kind});
    scene.faces.push_back({low + 2 * a, 2 * b, 2 * c, kind});
    const Vec first = a;
    a = b;
    b = c;
    c = first;
  }
}

void add_block(Scene& scene, Vec low, Vec high) {
  const Vec half = 0.5 * (high - low);
  add_box(scene, low + half, {half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z});
}

// Turned about the y axis.
void add_cube(Scene& scene, Vec centre, double edge, double degrees, Kind kind = Kind::Diffuse) {
  const double c = edge / 2 * std::cos(degrees * kPi / 180);
  const double s = edge / 2 * std::sin(degrees * kPi / 180);
  add_box(scene, centre, {c, 0, -s}, {0, edge / 2, 0}, {s, 0, c}, kind);
}

void add_lamp(Scene& scene, Vec corner, Vec u, Vec v) {
  scene.lamps.push_back(static_cast<int>(scene.faces.size()));
  scene.faces.push_back({corner, u, v, Kind::Lamp});
}

// Two layers of four beams, in a frame that is turned by 16.26 degrees.
Scene shadow(double lamp_degrees) {
  Scene scene;
  const Vec origin{-1.5, 0, 0}, u{0.96, 0.28, 0}, n{-0.28, 0.96, 0}, w{0, 0, 1};
  add_block(scene, {-10, -0.1, -10}, {10, 0, 10});
  for (const double k : {-0.9, -0.3, 0.3, 0.9})
    add_box(scene, origin + 1.45 * u + k * w, 1.55 * u, 0.05 * n, 0.05 * w);
  for (const double a : {0.3, 1.1, 1.9, 2.7})
    add_box(scene, origin + a * u + 0.1 * n, 0.05 * u, 0.05 * n, 1.2 * w);
  const double c = std::cos(lamp_degrees * kPi / 180), s = std::sin(lamp_degrees * kPi / 180);
  const Vec first = c * u + s * w, second = c * w - s * u;
  add_lamp(scene, Vec{-0.62, 2.34, 0} - 0.25 * first - 0.25 * second, 0.5 * first, 0.5 * second);
  scene.eye = {0.5, 3.2, 3.9};
  scene.target = {0.5, 0, 0};
  return scene;
}

Scene huge(double lamp_height, double slab_height) {
  Scene scene;
  add_block(scene, {-50, -1, -50}, {50, 0, 50});
  add_block(scene, {-5, 2, -5}, {5, 2.2, 5});
  add_block(scene, {-0.5, slab_height, -0.5}, {0.5, slab_height + 0.2, 0.5});
  add_lamp(scene, {-5, 6, -5}, {10, 0, 0}, {0, 0, 10});
  add_lamp(scene, {-0.5, lamp_height, -0.5}, {0, 0, 1}, {1, 0, 0});
  scene.eye = {0, 0.9, 4.6};
  scene.target = {0, 0.85, 0};
  return scene;
}

Scene geometric() {
  Scene scene;
  add_block(scene, {-10, -0.1, -10}, {10, 0, 10});
  add_cube(scene, {-1.05, 0.245, -0.1}, 0.5, 12);
  add_cube(scene, {1.05, 0.255, -0.1}, 0.5, -8);
  add_box(scene, {0, 0.284366, -0.85}, {0.240740478, 0.0388171066, -0.0551112925},
          {-0.0306669533, 0.2450815655, 0.038659595}, {0.0600296615, -0.0304673359, 0.2407658225});
  const Vec tip{0.0348782369, 0, 1.04878203}, left{-0.134634642, 0, 0.0581936222},
      right{0.0648781682, 0, 0.0442423275}, height{0, 0.5, 0};
  for (const auto& [from, to] : {std::pair{left, tip}, {tip, right}, {right, left}})
    scene.faces.push_back({from, to - from, height});
  scene.faces.push_back({left + height, tip - left, right - left, Kind::Diffuse, Face::Form::Triangle});
  add_lamp(scene, {-2.13452759, 2.69216699, 0.720050199}, {0.357770876, 0, 0.715541753},
           {-0.488715698, -0.584333987, 0.244357849});
  scene.eye = {0, 2.6, 3.4};
  scene.target = {0, 0.1, 0};
  return scene;
}

// `share` is the size of the card, 1 or less.
Scene secondary(double share) {
  Scene scene;
  add_block(scene, {-1, -0.1, -2}, {3, 0, 2});
  for (int i = 0; i < 6; ++i) scene.card.push_back(static_cast<int>(scene.faces.size()) + i);
  add_block(scene, {-1.6, 0.3 - 0.3 * share, -0.5 * share}, {-1.5, 0.3 + 0.3 * share, 0.5 * share});
  add_lamp(scene, {-0.75, -1, -0.5}, {0, 0, 1}, {0, 0.8, 0});
  scene.eye = {-0.5, 2.75, 1.5};
  scene.target = {-0.5, 0, 0};
  return scene;
}

}  // namespace

Scene scene_of(std::string name) {
  const auto cut = [&](const std::string& suffix) {
    const bool is_there = name.ends_with(suffix);
    if (is_there) name.resize(name.size() - suffix.size());
    return is_there;
  };
  const double share = cut("-k2") ? 0.5 : cut("-k4") ? 0.25 : cut("-k8") ? 0.125 : 1;
  const int depth = cut("-direct") ? 1 : cut("-2") ? 2 : cut("-3") ? 3 : std::numeric_limits<int>::max();
  Scene scene;
  if (name == "shadow" || name == "shadow-turned") scene = shadow(name == "shadow" ? 0 : 30);
  if (name == "huge") scene = huge(0.6, 0.2);
  if (name == "huge-inverse") scene = huge(0.2, 0.6);
  if (name == "geometric") scene = geometric();
  if (name == "secondary" || name.starts_with("caustic-")) scene = secondary(share);
  if (name == "secondary") add_cube(scene, {0, 0.2, 0}, 0.4, 30);
  if (name == "caustic-cube") add_cube(scene, {0, 0.2, 0}, 0.4, 30, Kind::Mirror);
  if (name == "caustic-sphere")
    scene.faces.push_back({{0, 0.2, 0}, {}, {}, Kind::Mirror, Face::Form::Ball, 0.2});
  scene.depth = depth;
  return scene;
}

}  // namespace independent
