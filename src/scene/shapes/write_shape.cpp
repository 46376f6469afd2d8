#include "scene/shapes/write_shape.h"

#include <array>

namespace orbs::scene {

namespace {

using json::Writer;

struct FormWriter {
  Writer& out;
  const Scene& scene;

  void operator()(const SphereForm& f) const {
    out.member("type", "sphere").member("centre", f.centre_m).member("radius", f.radius_m);
  }
  void operator()(const CylinderForm& f) const {
    out.member("type", "cylinder").member("radius", f.radius_m).member("height", f.height_m);
    out.member("caps", f.has_caps);
  }
  void operator()(const ConeForm& f) const {
    out.member("type", "cone").member("radius", f.radius_m).member("top_radius", f.top_radius_m);
    out.member("height", f.height_m).member("caps", f.has_caps);
  }
  void operator()(const DiskForm& f) const { out.member("type", "disk").member("radius", f.radius_m); }
  void operator()(const ParaboloidForm& f) const {
    out.member("type", "paraboloid").member("radius", f.radius_m).member("height", f.height_m);
    out.member("caps", f.has_caps);
  }
  void operator()(const HyperboloidForm& f) const {
    out.member("type", "hyperboloid").member("radius", f.radius_m).member("waist_radius", f.waist_radius_m);
    out.member("height", f.height_m).member("caps", f.has_caps);
  }
  void operator()(const BoxForm& f) const { out.member("type", "box").member("half_sizes", f.half_sizes_m); }
  void operator()(const HalfSpaceForm&) const { out.member("type", "half_space"); }
  void operator()(const TorusForm& f) const {
    out.member("type", "torus").member("major_radius", f.major_radius_m);
    out.member("minor_radius", f.minor_radius_m);
  }
  void operator()(const SuperellipsoidForm& f) const {
    out.member("type", "superellipsoid").member("east_west", f.east_west);
    out.member("north_south", f.north_south);
  }
  void operator()(const ImplicitForm& f) const {
    out.member("type", "implicit").member("expression", f.expression.text);
    out.member("low", f.low_m).member("high", f.high_m).member("closed", f.is_closed);
  }
  void operator()(const PluginForm& f) const {
    out.member("type", "plugin").member("plugin", f.plugin).key("numbers").begin_object();
    for (const auto& [name, value] : f.numbers) out.member(name, value);
    out.end_object();
  }
  void operator()(const CsgForm& f) const {
    constexpr std::array kWords{"union", "intersection", "difference"};
    out.member("type", kWords[static_cast<std::size_t>(f.operation)]).key("operands").begin_array();
    for (const Shape& operand : f.operands) write_shape(out, scene, operand);
    out.end_array();
  }
};

}  // namespace

void write_shape(Writer& out, const Scene& scene, const Shape& shape) {
  out.begin_object();
  std::visit(FormWriter{out, scene}, shape.form);
  out.member("name", shape.name);
  out.key("matrix").numbers(shape.matrix.m);
  if (shape.material >= 0) out.member("material", material_at(scene, shape.material).name);
  out.end_object();
}

}  // namespace orbs::scene
