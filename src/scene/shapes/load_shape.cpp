#include "scene/shapes/load_shape.h"

#include "base/error.h"
#include "base/plain_name.h"
#include "base/text.h"
#include "scene/shapes/parse_expression.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

using json::ObjectReader;

constexpr int kDeepest = 32;              // CSG within CSG
constexpr std::size_t kMostLeaves = 256;  // of one solid; every ray that meets its bounds visits them

struct Limits {
  int depth = 0;
  std::size_t leaves = 0;
};

bool load_caps(ObjectReader& in) { return in.boolean_or("caps", true); }

ConeForm load_cone(ObjectReader& in) {
  ConeForm cone{in.number("radius", {0, kFarthest_m}), in.number_or("top_radius", 0, {0, kFarthest_m}),
                in.number("height", kLength), load_caps(in)};
  if (cone.radius_m == 0 && cone.top_radius_m == 0)
    in.fail("radius", "must be above 0 where top_radius is 0: the cone has no width");
  return cone;
}

HyperboloidForm load_hyperboloid(ObjectReader& in) {
  HyperboloidForm form{in.number("radius", kLength), in.number("waist_radius", {0, kFarthest_m}),
                       in.number("height", kLength), load_caps(in)};
  if (form.waist_radius_m >= form.radius_m)
    in.fail("waist_radius", fmt::format("must be below the radius at the ends, {}, is {}", form.radius_m,
                                        form.waist_radius_m));
  return form;
}

BoxForm load_box(ObjectReader& in) {
  const auto sizes = in.numbers("half_sizes", 3, kLength);
  return {{sizes[0], sizes[1], sizes[2]}};
}

TorusForm load_torus(ObjectReader& in) {
  const TorusForm form{in.number("major_radius", kLength), in.number("minor_radius", kLength)};
  if (form.minor_radius_m >= form.major_radius_m)
    in.fail("minor_radius",
            fmt::format("must be below the major radius, {}, is {}: the tube would cut itself",
                        form.major_radius_m, form.minor_radius_m));
  return form;
}

SuperellipsoidForm load_superellipsoid(ObjectReader& in) {
  // Powers 2 / e below 1 have cusps on which no normal is defined; above 40 all of the shape is its edges.
  constexpr json::Range kExponent{0.05, 2};
  return {in.number("east_west", kExponent), in.number("north_south", kExponent)};
}

ImplicitForm load_implicit(ObjectReader& in) {
  ImplicitForm form;
  try {
    form.expression = parse_expression(in.text("expression"));
  } catch (const InputError& e) {
    in.fail("expression", e.what());
  }
  form.low_m = in.vec3("low", kPlace);
  form.high_m = in.vec3("high", kPlace);
  if (!(form.low_m.x < form.high_m.x && form.low_m.y < form.high_m.y && form.low_m.z < form.high_m.z))
    in.fail("high", "must be above low in x, y and z");
  form.is_closed = in.boolean_or("closed", false);
  return form;
}

// Scenes come from strangers: with a slash or a point, the name would be a place on the machine of the user.
std::string load_plugin_name(ObjectReader& in) {
  auto name = in.text("plugin");
  if (!is_plain_name(name))
    in.fail("plugin",
            fmt::format("'{}' is no plain name: at most 100 letters, digits, '-' and '_'; where the plug-in "
                        "lies, --plugin or --plugin-folder of orbs-tracer says, and never a scene",
                        clean_line(name)));
  return name;
}

PluginForm load_plugin(ObjectReader& in) {
  constexpr std::size_t kMostNumbers = 64;
  PluginForm form{load_plugin_name(in), {}};
  if (!in.has("numbers")) return form;
  auto numbers = in.object("numbers");
  for (const auto& name : numbers.keys()) {
    if (!is_plain_name(name))
      numbers.fail(name, "is no plain name: at most 100 letters, digits, '-' and '_'");
    form.numbers[name] = numbers.number(name);
  }
  if (form.numbers.size() > kMostNumbers)
    in.fail("numbers", fmt::format("are {}; a shape has at most {}", form.numbers.size(), kMostNumbers));
  numbers.finish();
  return form;
}

Shape load_form(ObjectReader& in, const Names& materials, Limits& limits, bool is_operand);

CsgForm load_csg(ObjectReader& in, SetOperation operation, const Names& materials, Limits& limits) {
  if (++limits.depth > kDeepest) in.fail("operands", fmt::format("are nested more than {} deep", kDeepest));
  auto readers = in.objects("operands");
  if (readers.size() < 2)
    in.fail("operands", fmt::format("must be at least two, there are {}", readers.size()));
  CsgForm csg{operation, {}};
  for (auto& reader : readers) {
    csg.operands.push_back(load_form(reader, materials, limits, true));
    if (const auto& form = csg.operands.back().form; !is_closed(form))
      reader.fail("type", fmt::format("{} without an inside cannot be an operand{}", what_is(form),
                                      std::holds_alternative<DiskForm>(form)       ? ""
                                      : std::holds_alternative<PluginForm>(form)   ? ""
                                      : std::holds_alternative<ImplicitForm>(form) ? "; set \"closed\": true"
                                                                                   : "; set \"caps\": true"));
  }
  --limits.depth;
  return csg;
}

ShapeForm form_of(const std::string& type, ObjectReader& in, const Names& materials, Limits& limits) {
  if (type == "sphere") return SphereForm{in.vec3("centre", kPlace), in.number("radius", kLength)};
  if (type == "cylinder")
    return CylinderForm{in.number("radius", kLength), in.number("height", kLength), load_caps(in)};
  if (type == "cone") return load_cone(in);
  if (type == "disk") return DiskForm{in.number("radius", kLength)};
  if (type == "paraboloid")
    return ParaboloidForm{in.number("radius", kLength), in.number("height", kLength), load_caps(in)};
  if (type == "hyperboloid") return load_hyperboloid(in);
  if (type == "box") return load_box(in);
  if (type == "half_space") return HalfSpaceForm{};
  if (type == "torus") return load_torus(in);
  if (type == "superellipsoid") return load_superellipsoid(in);
  if (type == "implicit") return load_implicit(in);
  if (type == "plugin") return load_plugin(in);
  const auto operation = type == "union"          ? SetOperation::Union
                         : type == "intersection" ? SetOperation::Intersection
                                                  : SetOperation::Difference;
  return load_csg(in, operation, materials, limits);
}

// Reads one object up to finish().
Shape load_form(ObjectReader& in, const Names& materials, Limits& limits, bool is_operand) {
  const auto type = in.one_of(
      "type", {"sphere", "cylinder", "cone", "disk", "paraboloid", "hyperboloid", "box", "half_space",
               "torus", "superellipsoid", "implicit", "plugin", "union", "intersection", "difference"});
  if (type == "half_space" && !is_operand)
    in.fail("type",
            "a half_space has no end; it can only be an operand of union, intersection or difference");
  Shape shape;
  shape.name = in.text_or("name", "");
  shape.form = form_of(type, in, materials, limits);
  if (!std::holds_alternative<CsgForm>(shape.form) && ++limits.leaves > kMostLeaves)
    in.fail("type", fmt::format("the solid has more than {} operands", kMostLeaves));
  shape.matrix = load_matrix(in, "matrix");
  if (!is_operand || in.has("material")) shape.material = materials.find(in, "material");
  in.finish();
  return shape;
}

// Solids without an end would fill space: a half-space, a union with one, what it is taken from, and an
// intersection of nothing else.
bool is_bounded(const Shape& shape) {
  const auto* csg = std::get_if<CsgForm>(&shape.form);
  if (csg == nullptr) return !std::holds_alternative<HalfSpaceForm>(shape.form);
  if (csg->operation == SetOperation::Difference) return is_bounded(csg->operands.front());
  const bool needs_all = csg->operation == SetOperation::Union;
  for (const Shape& operand : csg->operands)
    if (is_bounded(operand) != needs_all) return !needs_all;
  return needs_all;
}

}  // namespace

void load_shape(ObjectReader& in, const Names& materials, Scene& scene) {
  const bool has_matrix = in.has("matrix");
  Limits limits;
  Shape shape = load_form(in, materials, limits, false);
  if (!is_bounded(shape))
    in.fail("operands", "the solid has no end: intersect its half-spaces with a shape that has one");
  const auto* sphere = std::get_if<SphereForm>(&shape.form);
  if (sphere != nullptr && !has_matrix)
    scene.spheres.push_back({shape.name, sphere->centre_m, sphere->radius_m, shape.material});
  else
    scene.shapes.push_back(std::move(shape));
}

}  // namespace orbs::scene
