#include "adapters/obj/lamp_words.h"

#include "adapters/light_frame.h"

#include <fmt/format.h>

namespace orbs::adapters::obj {

namespace {

void write_corners(json::Writer& out, const LightFrame& frame, const scene::RectShape& rect) {
  const Vec3d u = frame.u * rect.half_width_m;
  const Vec3d v = frame.v * rect.half_length_m;
  out.key("corners_m").begin_array();
  for (const Vec3d corner : {u * -1.0 - v, u - v, u + v, v - u}) out.value(frame.centre + corner);
  out.end_array();
}

struct ShapeWords {
  json::Writer& out;
  const LightFrame& frame;
  const Mat4& matrix;

  void operator()(const scene::RectShape& rect) const {
    out.member("shape", "rectangle")
        .member(
            "in_words",
            "corners_m are its corners in the world, counter-clockwise as "
            "seen from where it shines to. It shines on that side alone; its back is black, opaque and visible");
    out.member("width_m", 2 * rect.half_width_m).member("length_m", 2 * rect.half_length_m);
    write_corners(out, frame, rect);
    out.member("shines_towards", frame.facing);
  }
  void operator()(const scene::DiskShape& disk) const {
    out.member("shape", "disk")
        .member("in_words",
                "its edge in the world is centre_m + cos(t) axis_u_m + sin(t) "
                "axis_v_m. It shines on one side alone; its back is black, opaque and visible");
    out.member("radius_m", disk.radius_m).member("centre_m", frame.centre);
    out.member("axis_u_m", frame.u * disk.radius_m).member("axis_v_m", frame.v * disk.radius_m);
    out.member("shines_towards", frame.facing);
  }
  void operator()(const scene::SphereShape& sphere) const {
    out.member("shape", "sphere")
        .member("in_words",
                "it shines outwards; centre_m and world_radius_m are those "
                "in the world");
    out.member("radius_m", sphere.radius_m).member("centre_m", frame.centre);
    out.member("world_radius_m", sphere.radius_m * length(frame.u));
  }
  void operator()(const scene::PointShape&) const {
    out.member("shape", "point")
        .member("in_words",
                "it has no area, so that nobody sees it and no ray meets it; a surface at the "
                "distance d gets the irradiance intensity cos / d^2");
    out.member("position_m", frame.centre);
  }
  void operator()(const scene::SpotShape& spot) const {
    out.member("shape", "spot")
        .member(
            "in_words",
            "a point without an area, so that nobody sees it and no ray meets it, whose intensity falls with the angle to "
            "its axis: all of it within the inner half angle, none beyond the outer one, and between them times t^2 (3 - 2 "
            "t), t = (cos angle - cos outer) / (cos inner - cos outer)");
    out.member("position_m", frame.centre).member("shines_towards", shining_direction(matrix));
    out.member("inner_half_angle_deg", spot.inner_deg).member("outer_half_angle_deg", spot.outer_deg);
  }
  void operator()(const scene::DirectionalShape&) const {
    out.member("shape", "directional")
        .member(
            "in_words",
            "parallel light from beyond all that is drawn; a surface gets the irradiance times the cosine at it");
    out.member("shines_towards", shining_direction(matrix));
  }
};

// The unit of what a lamp emits, after the name that the scene file has for it.
std::string emission_key(const scene::LightShape& shape) {
  return std::visit(
      [](const auto& s) -> std::string {
        const std::string key = s.kEmission;
        return key == "intensity" ? key + "_W_per_sr" : key == "irradiance" ? key + "_W_per_m2" : key;
      },
      shape);
}

}  // namespace

std::string profile_file(std::size_t lamp, const std::string& stem) {
  return fmt::format("{}-lamp{}.ies", stem, lamp);
}

void write_lamp(json::Writer& out, const scene::Light& light, std::size_t index, const std::string& stem) {
  const LightFrame frame = light_frame(light.matrix);
  out.begin_object().member("name", light.name.empty() ? fmt::format("lamp {}", index) : light.name);
  std::visit(ShapeWords{out, frame, light.matrix}, light.shape);
  out.member(emission_key(light.shape), light.radiance);
  out.member(
      "matrix_in_words",
      has_area(light.shape)
          ? "it has placed, turned and scaled the shape of this width, length or radius, which lies about the "
            "origin, flat in the plane y = 0 and shining towards -y; the radiance stays"
          : "it has placed and turned the lamp, which stood at the origin and shone towards -y; its scale does "
            "nothing");
  out.key("matrix").numbers(light.matrix.m);
  if (light.ies) {
    out.key("ies").begin_object().member("file", profile_file(index, stem));
    out.member("point_area", light.ies->point_area);
    out.member(
        "in_words",
        fmt::format("what it emits is multiplied by candela / the largest candela towards the direction from "
                    "{}. Vertical angle 0 is the lamp's local -y; azimuth 0 is its local +x and 90 degrees "
                    "its local +z; this matrix turns the profile within the lamp's frame",
                    light.ies->point_area ? "the lamp's centre" : "the point on the lamp"));
    out.key("matrix").numbers(light.ies->matrix.m).end_object();
  }
  out.end_object();
}

}  // namespace orbs::adapters::obj
