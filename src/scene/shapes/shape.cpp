#include "scene/shapes/shape.h"

#include "scene/shapes/parse_expression.h"

#include <fmt/format.h>

namespace orbs::scene {

namespace {

struct Words {
  const char* what;
  const char* level;
};

struct WordsOf {
  Words operator()(const SphereForm&) const { return {"an ellipsoid", "S1"}; }
  Words operator()(const CylinderForm&) const { return {"a cylinder", "S1"}; }
  Words operator()(const ConeForm&) const { return {"a cone", "S1"}; }
  Words operator()(const DiskForm&) const { return {"a disk", "S1"}; }
  Words operator()(const ParaboloidForm&) const { return {"a paraboloid", "S1"}; }
  Words operator()(const HyperboloidForm&) const { return {"a hyperboloid", "S1"}; }
  Words operator()(const BoxForm&) const { return {"a box", "S1"}; }
  Words operator()(const HalfSpaceForm&) const { return {"a half-space", "S4"}; }
  Words operator()(const TorusForm&) const { return {"a torus", "S2"}; }
  Words operator()(const SuperellipsoidForm&) const { return {"a superellipsoid", "S2"}; }
  Words operator()(const ImplicitForm&) const { return {"an implicit surface", "S3"}; }
  Words operator()(const PluginForm&) const { return {"a plug-in's surface", "S7"}; }
  Words operator()(const CsgForm&) const { return {"a solid by CSG", "S4"}; }
};

}  // namespace

bool CsgForm::operator==(const CsgForm& other) const {
  return operation == other.operation && operands == other.operands;
}

RevolvedQuadric revolved(const CylinderForm& form) {
  return {form.radius_m * form.radius_m, 0, 0, 0, form.height_m, form.has_caps};
}

RevolvedQuadric revolved(const ConeForm& form) {
  // (r + s y)^2; a cone that ends in its apex has no second nappe between 0 and its height.
  const double slope = (form.top_radius_m - form.radius_m) / form.height_m;
  return {form.radius_m * form.radius_m,
          2 * form.radius_m * slope,
          slope * slope,
          0,
          form.height_m,
          form.has_caps};
}

RevolvedQuadric revolved(const ParaboloidForm& form) {
  return {0, form.radius_m * form.radius_m / form.height_m, 0, 0, form.height_m, form.has_caps};
}

RevolvedQuadric revolved(const HyperboloidForm& form) {
  // waist^2 + (radius^2 - waist^2) (2 y / height - 1)^2
  const double excess = form.radius_m * form.radius_m - form.waist_radius_m * form.waist_radius_m;
  const double per_height = 2 / form.height_m;
  return {form.radius_m * form.radius_m,
          -2 * excess * per_height,
          excess * per_height * per_height,
          0,
          form.height_m,
          form.has_caps};
}

ImplicitForm implicit(const TorusForm& form) {
  // Nearly the distance, so that enclosures are tight: the quartic's are several times as wide.
  constexpr double kRoom = 1 + 1e-6;  // so that the surface does not touch the box
  const double reach = kRoom * (form.major_radius_m + form.minor_radius_m);
  const double height = kRoom * form.minor_radius_m;
  return {parse_expression(
              fmt::format("(sqrt(x^2 + z^2) - {})^2 + y^2 - {}^2", form.major_radius_m, form.minor_radius_m)),
          {-reach, -height, -reach},
          {reach, height, reach},
          true};
}

ImplicitForm implicit(const SuperellipsoidForm& form) {
  constexpr double kReach = 1 + 1e-6;
  const double e = form.east_west;
  const double n = form.north_south;
  return {
      parse_expression(fmt::format("(abs(x)^{} + abs(z)^{})^{} + abs(y)^{} - 1", 2 / e, 2 / e, e / n, 2 / n)),
      {-kReach, -kReach, -kReach},
      {kReach, kReach, kReach},
      true};
}

const char* what_is(const ShapeForm& form) { return std::visit(WordsOf{}, form).what; }
const char* level_of(const ShapeForm& form) { return std::visit(WordsOf{}, form).level; }

bool is_closed(const ShapeForm& form) {
  return std::visit(
      [](const auto& f) {
        if constexpr (requires { f.has_caps; }) return f.has_caps;
        if constexpr (requires { f.is_closed; }) return f.is_closed;
        using Form = std::decay_t<decltype(f)>;
        return !std::is_same_v<Form, DiskForm> && !std::is_same_v<Form, PluginForm>;
      },
      form);
}

}  // namespace orbs::scene
