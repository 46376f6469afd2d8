// Shapes by their formula: how they are read, refused, written and turned into triangles.
#include "base/error.h"
#include "scene/effects/features.h"
#include "scene/load/load_scene.h"
#include "scene/load/write_scene.h"
#include "scene/lower/geometry.h"
#include "scene/lower/lower.h"
#include "scene/shapes/expression.h"
#include "structure/source_files.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

scene::Scene scene_with(const std::string& shapes) {
  return scene::load_scene_text("scene.json",
                                R"({"format": "orbs-scene/1", "name": "s",
"camera": {"position": [0, 0, 5], "look_at": [0, 0, 0]},
"materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]},
              {"name": "glass", "type": "glass", "ior": 1.5}],
"shapes": [)" + shapes + "]}",
                                ".");
}

std::string refusal(const std::string& shape) {
  try {
    scene_with(shape);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

double value(const std::string& text, double x, double y, double z) {
  const auto formula = scene::parse_expression(text);
  std::vector<double> values(formula.steps.size());
  return scene::evaluate<double>(formula, {x, y, z}, values);
}

std::string formula_refusal(const std::string& text) {
  try {
    scene::parse_expression(text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

const char* const kAllForms = R"(
{"type": "sphere", "centre": [1, 2, 3], "radius": 2, "matrix": [{"scale": [1, 2, 3]}], "material": "m"},
{"type": "cylinder", "radius": 0.5, "height": 2, "material": "m"},
{"type": "cone", "radius": 0.5, "top_radius": 0.25, "height": 2, "caps": false, "material": "m"},
{"type": "disk", "radius": 0.5, "material": "m"},
{"type": "paraboloid", "radius": 0.5, "height": 2, "material": "m"},
{"type": "hyperboloid", "radius": 0.5, "waist_radius": 0.2, "height": 2, "material": "m"},
{"type": "box", "half_sizes": [1, 2, 3], "material": "m"},
{"type": "torus", "major_radius": 1, "minor_radius": 0.3, "material": "m"},
{"type": "superellipsoid", "east_west": 0.3, "north_south": 1.2, "material": "m"},
{"type": "implicit", "expression": "x^2 + y^2 - z", "low": [-1, -1, -1], "high": [1, 1, 1], "closed": true, "material": "m"},
{"type": "plugin", "plugin": "sad-dle_2", "numbers": {"half_size": 0.1, "k": -3}, "material": "m"},
{"type": "difference", "material": "glass", "operands": [
  {"type": "box", "half_sizes": [1, 1, 1]},
  {"type": "union", "matrix": [{"rotate_y": 30}], "operands": [
    {"type": "sphere", "centre": [0, 0, 0], "radius": 1, "material": "m"}, {"type": "half_space"}]}]})";

}  // namespace

TEST(Formula, IsReadAsItIsWrittenOnPaper) {
  EXPECT_EQ(value("2 + 3 * x ^ 2", 2, 0, 0), 14);
  EXPECT_EQ(value("-x^2", 3, 0, 0), -9);
  EXPECT_EQ(value("2^3^2", 0, 0, 0), 512);
  EXPECT_EQ(value("8 / 4 / 2 - 1 - 1", 0, 0, 0), -1);
  EXPECT_EQ(value("min(x, max(y, z))", 5, 2, 3), 3);
  EXPECT_EQ(value("pow(abs(x), 0.5) + sqrt(z)", -4, 0, 9), 5);
  EXPECT_EQ(value("x", 7, 0, 0), 7);
  EXPECT_EQ(value("1.5e1 - -x", 1, 0, 0), 16);
  EXPECT_NEAR(value("sin(pi / 2 * x) + cos(y) + exp(log(z))", 1, 0, 3), 5, 1e-15);
}

TEST(Formula, EqualPartsAreOneStep) {
  // x, x^2, y, x^2 + y, its square
  EXPECT_EQ(scene::parse_expression("(x * x + y) * (x^2 + y)").steps.size(), 5U);
  EXPECT_EQ(scene::parse_expression("x + (1 + sqrt(5)) / 2").steps.size(), 3U);
}

TEST(Formula, RefusesSayWhere) {
  expect_part(formula_refusal("x +"),
              "column 4 of the formula: expected a number, x, y, z, a function or '(', found the end");
  expect_part(formula_refusal("x ? y"),
              "column 3 of the formula: expected an operator or the end, found '?'");
  expect_part(formula_refusal("x + sine(y)"),
              "column 5 of the formula: there is no 'sine' (did you mean 'sin'?)");
  expect_part(formula_refusal("(x + y"), "expected ')', found the end");
  expect_part(formula_refusal("x^y"), "the exponent must be a constant; write exp(b * log(a)) for a^b");
  expect_part(formula_refusal("x + 1 / 0"), "this constant has no finite value");
  expect_part(formula_refusal("sin(x, y)"), "expected ')', found ','");
  expect_part(formula_refusal(fmt::format("{}x", std::string(200, '('))), "more than 100 brackets");
  expect_part(formula_refusal(std::string(20000, ' ')), "at most 10000 are read");
}

TEST(Shapes, AllFormsAreReadAndWritten) {
  const structure::TestFolder folder("shapes");
  const auto read = scene_with(kAllForms);
  ASSERT_EQ(read.shapes.size(), 12U);
  EXPECT_TRUE(read.spheres.empty());
  scene::write_scene(read, folder.path() / "scene.json");
  EXPECT_EQ(scene::load_scene(folder.path() / "scene.json"), read);
}

TEST(Shapes, ASphereWithoutAMatrixStaysASphere) {
  const auto read = scene_with(R"({"type": "sphere", "centre": [1, 2, 3], "radius": 2, "material": "m"})");
  EXPECT_EQ(read.spheres.size(), 1U);
  EXPECT_TRUE(read.shapes.empty());
}

TEST(Shapes, RefusalsSayWhereAndWhatToDo) {
  expect_part(refusal(R"({"type": "conus", "material": "m"})"), "/shapes/0/type: 'conus' is not one of");
  expect_part(refusal(R"({"type": "cylinder", "radius": 1, "material": "m"})"), "key 'height' is missing");
  expect_part(refusal(R"({"type": "disk", "radius": 1, "height": 1, "material": "m"})"),
              "/shapes/0/height: unknown key");
  expect_part(refusal(R"({"type": "half_space", "material": "m"})"), "it can only be an operand");
  expect_part(refusal(R"({"type": "torus", "major_radius": 1, "minor_radius": 2, "material": "m"})"),
              "/shapes/0/minor_radius: must be below the major radius, 1, is 2");
  expect_part(
      refusal(R"({"type": "hyperboloid", "radius": 1, "waist_radius": 2, "height": 1, "material": "m"})"),
      "/shapes/0/waist_radius: must be below the radius at the ends, 1, is 2");
  expect_part(
      refusal(
          R"({"type": "implicit", "expression": "x +* y", "low": [0, 0, 0], "high": [1, 1, 1], "material": "m"})"),
      "/shapes/0/expression: column 4 of the formula");
  expect_part(
      refusal(
          R"({"type": "implicit", "expression": "x", "low": [0, 0, 0], "high": [1, 0, 1], "material": "m"})"),
      "/shapes/0/high: must be above low in x, y and z");
  for (const char* formula : {"x / 0", "x / (y - y)", "log(-1 - x^2) + y"})
    expect_part(refusal(R"({"type": "implicit", "expression": ")" + std::string(formula) +
                        R"(", "low": [0, 0, 0], "high": [1, 1, 1], "material": "m"})"),
                "/shapes/0/expression: has no finite value anywhere in its box, as x / 0 has none");
  expect_part(
      refusal(
          R"({"type": "union", "material": "m", "operands": [{"type": "box", "half_sizes": [1, 1, 1]}]})"),
      "/shapes/0/operands: must be at least two, there are 1");
  expect_part(
      refusal(R"({"type": "union", "material": "m", "operands": [{"type": "box", "half_sizes": [1, 1, 1]},
    {"type": "cone", "radius": 1, "height": 1, "caps": false}]})"),
      R"(/shapes/0/operands/1/type: a cone without an inside cannot be an operand; set "caps": true)");
  expect_part(
      refusal(R"({"type": "union", "material": "m", "operands": [{"type": "box", "half_sizes": [1, 1, 1]},
    {"type": "half_space"}]})"),
      "the solid has no end");
  expect_part(refusal(R"({"type": "box", "half_sizes": [1, 1, 1]})"), "key 'material' is missing");
}

// A scene of a stranger names a plug-in, and never a place.
TEST(Shapes, OfPluginsHavePlainNames) {
  for (const char* name :
       {"../saddle", "/lib/saddle.so", "a/b", "saddle.so", "", "-o", ".", "a b", "a\\u0000b"})
    expect_part(
        refusal(fmt::format(R"({{"type": "plugin", "plugin": "{}", "material": "m"}})", name)),
        "is no plain name: at most 100 letters, digits, '-' and '_'; where the plug-in lies, --plugin or "
        "--plugin-folder of orbs-tracer says, and never a scene");
  expect_part(refusal(R"({"type": "plugin", "plugin": "a", "numbers": {"b c": 1}, "material": "m"})"),
              "/shapes/0/numbers/b c: is no plain name");
  expect_part(refusal(R"({"type": "plugin", "plugin": "a", "numbers": {"b": "1"}, "material": "m"})"),
              "/shapes/0/numbers/b: must be a number");
  expect_part(
      refusal(R"({"type": "union", "material": "m", "operands": [{"type": "box", "half_sizes": [1, 1, 1]},
    {"type": "plugin", "plugin": "a"}]})"),
      "/shapes/0/operands/1/type: a plug-in's surface without an inside cannot be an operand");
}

TEST(Shapes, CallForTheLevelsOfTheirForms) {
  const auto levels = [](const std::string& shapes) {
    std::string found;
    for (const auto& feature : scene::features_called_for(scene_with(shapes)))
      if (feature.requirement.front() == 'S') found += feature.requirement;
    return found;
  };
  EXPECT_EQ(levels(kAllForms), "S1S2S3S4S7");
  EXPECT_EQ(levels(R"({"type": "torus", "major_radius": 1, "minor_radius": 0.3, "material": "m"})"), "S2");
}

TEST(Shapes, WithoutTheirLevelsBecomeTrianglesOrAReason) {
  const std::string quadric = R"({"type": "cylinder", "radius": 0.5, "height": 2, "material": "m"})";
  const scene::Capabilities orbs{"G1", "G2", "G3", "G4", "G5", "M1", "M8"};
  const auto lowered = std::get<scene::Scene>(scene::lower(scene_with(quadric), orbs));
  EXPECT_TRUE(lowered.shapes.empty());
  EXPECT_EQ(lowered.meshes.size(), 1U);
  auto with_s1 = orbs;
  with_s1.insert("S1");
  EXPECT_EQ(std::get<scene::Scene>(scene::lower(scene_with(quadric), with_s1)).shapes.size(), 1U);
  const auto reason = std::get<std::string>(scene::lower(
      scene_with(
          R"({"type": "implicit", "name": "blob", "expression": "x", "low": [0, 0, 0], "high": [1, 1, 1], "material": "m"})"),
      with_s1));
  EXPECT_EQ(reason, "shape 'blob' is an implicit surface by its formula, which needs S3");
}

namespace {

// Distance of the vertices from the surface, as a residual of its formula, and of the normals from its
// gradient.
void expect_on_surface(const scene::ShapeForm& form, const std::string& formula, double tolerance) {
  const auto mesh = scene::tessellated(form);
  ASSERT_TRUE(mesh);
  for (std::size_t i = 0; i < mesh->positions.size(); ++i) {
    const Vec3f p = mesh->positions[i];
    const Vec3f n = mesh->normals[i];
    ASSERT_NEAR(value(formula, p.x, p.y, p.z), 0, tolerance) << what_is(form);
    ASSERT_NEAR(length(n), 1, 1e-5);
    constexpr float kStep = 1e-3F;
    // Along the normal f grows, as the inside is f < 0.
    ASSERT_GT(value(formula, p.x + n.x * kStep, p.y + n.y * kStep, p.z + n.z * kStep), 0) << what_is(form);
    ASSERT_GE(mesh->uvs[i].x, 0);
    ASSERT_LE(mesh->uvs[i].y, 1);
  }
}

}  // namespace

TEST(Tessellation, LiesOnTheFormulaWithNormalsOutwards) {
  expect_on_surface(scene::CylinderForm{1, 2, true}, "max(sqrt(x^2 + z^2) - 1, abs(y - 1) - 1)", 1e-6);
  expect_on_surface(scene::ConeForm{1, 0.5, 2, true}, "max(sqrt(x^2 + z^2) - 1 + y / 4, abs(y - 1) - 1)",
                    1e-6);
  expect_on_surface(scene::ParaboloidForm{1, 2, true}, "max(x^2 + z^2 - y / 2, y - 2)", 1e-6);
  expect_on_surface(scene::HyperboloidForm{1, 0.5, 2, true},
                    "max(x^2 + z^2 - 0.25 - 0.75 * (y - 1)^2, abs(y - 1) - 1)", 1e-6);
  expect_on_surface(scene::BoxForm{{1, 2, 3}}, "max(abs(x) - 1, max(abs(y) - 2, abs(z) - 3))", 1e-6);
  expect_on_surface(scene::TorusForm{1, 0.3}, "(sqrt(x^2 + z^2) - 1)^2 + y^2 - 0.09", 1e-6);
  expect_on_surface(scene::SuperellipsoidForm{0.5, 1.5},
                    "(abs(x)^4 + abs(z)^4)^(0.5 / 1.5) + abs(y)^(2 / 1.5) - 1", 1e-5);
}
