#include "scene/shapes/shape.h"

#include "base/nth.h"
#include "json/writer.h"
#include "scene/load/entry.h"
#include "scene/load/kind.h"
#include "scene/material.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

constexpr int kDeepestSolid = 32;         // CSG within CSG
constexpr std::size_t kMostLeaves = 256;  // of one solid; every ray that meets its bounds visits them

// What to write so that the form gets an inside, as the end of a message.
std::string remedy(const ShapeForm& form) {
  return std::visit(
      [](const auto& f) -> std::string {
        using Form = std::decay_t<decltype(f)>;
        if constexpr (requires { Form::kClosedBy; }) return fmt::format("; set {}", Form::kClosedBy);
        return "";
      },
      form);
}

// Reads one object up to finish().
Shape load_form(ShapeEntry& entry, bool is_operand) {
  auto& in = entry.in;
  Shape shape;
  shape.name = in.text_or("name", "");
  shape.form = load_kind<ShapeForm>(in, entry);
  if (std::holds_alternative<CsgForm>(shape.form)) {
    if (!is_operand && !is_bounded(shape))
      in.fail("operands", "the solid has no end: intersect its half-spaces with a shape that has one");
  } else if (!is_operand && !bounds(shape.form)) {
    in.fail("type",
            fmt::format("a {} has no end; it can only be an operand of union, intersection or difference",
                        type_name(shape.form)));
  } else if (++entry.limits.leaves > kMostLeaves) {
    in.fail("type", fmt::format("the solid has more than {} operands", kMostLeaves));
  }
  shape.matrix = load_matrix(in, "matrix");
  refuse_motion(in, "shapes by their formula");
  if (!is_operand || in.has("material")) shape.material = entry.materials.find(in, "material");
  in.finish();
  return shape;
}

void add_corners(const Shape& shape, const Mat4& around, std::vector<Vec3d>& corners) {
  const Mat4 matrix = around * shape.matrix;
  if (const auto* csg = std::get_if<CsgForm>(&shape.form))
    for (const Shape& operand : csg->operands) add_corners(operand, matrix, corners);
  const auto box = bounds(shape.form);
  if (!box) return;
  for (const double x : {box->low.x, box->high.x})
    for (const double y : {box->low.y, box->high.y})
      for (const double z : {box->low.z, box->high.z}) corners.push_back(transform_point(matrix, {x, y, z}));
}

}  // namespace

bool CsgForm::operator==(const CsgForm& other) const {
  return operation == other.operation && operands == other.operands;
}

void load(ShapeEntry& entry, CsgForm& loaded) {
  const std::string word = entry.in.text("type");
  const auto found = std::find(CsgForm::kTypes.begin(), CsgForm::kTypes.end(), word);
  loaded.operation = static_cast<SetOperation>(found - CsgForm::kTypes.begin());
  if (++entry.limits.depth > kDeepestSolid)
    entry.in.fail("operands", fmt::format("are nested more than {} deep", kDeepestSolid));
  auto readers = entry.in.objects("operands");
  if (readers.size() < 2)
    entry.in.fail("operands", fmt::format("must be at least two, there are {}", readers.size()));
  for (auto& reader : readers) {
    ShapeEntry operand{reader, entry.materials, entry.limits};
    loaded.operands.push_back(load_operand(operand));
    if (const auto& form = loaded.operands.back().form; !is_closed(form))
      reader.fail("type",
                  fmt::format("{} without an inside cannot be an operand{}", what_is(form), remedy(form)));
  }
  --entry.limits.depth;
}

void write(json::Writer& out, const MaterialList& materials, const CsgForm& form) {
  out.key("operands").begin_array();
  for (const Shape& operand : form.operands) write_shape(out, materials, operand);
  out.end_array();
}

bool is_bounded(const Shape& shape) {
  const auto* csg = std::get_if<CsgForm>(&shape.form);
  if (csg == nullptr) return bounds(shape.form).has_value();
  if (csg->operation == SetOperation::Difference) return is_bounded(csg->operands.front());
  const bool needs_all = csg->operation == SetOperation::Union;
  for (const Shape& operand : csg->operands)
    if (is_bounded(operand) != needs_all) return !needs_all;
  return needs_all;
}

const char* type_name(const ShapeForm& form) {
  return std::visit(
      [](const auto& f) {
        if constexpr (requires { f.kType; })
          return f.kType;
        else
          return type_word(f);
      },
      form);
}

const char* what_is(const ShapeForm& form) {
  return std::visit([](const auto& f) { return f.kWhat; }, form);
}

const char* level_of(const ShapeForm& form) {
  return std::visit([](const auto& f) { return f.kLevel; }, form);
}

bool is_closed(const ShapeForm& form) {
  return std::visit([](const auto& f) { return is_closed(f); }, form);
}

std::optional<LocalBox> bounds(const ShapeForm& form) {
  return std::visit([](const auto& f) { return bounds(f); }, form);
}

std::optional<Mesh> tessellated(const ShapeForm& form) {
  return std::visit([](const auto& f) { return tessellated(f); }, form);
}

Shape load_shape(json::ObjectReader& in, const Names& materials) {
  SolidLimits limits;
  ShapeEntry entry{in, materials, limits};
  return load_form(entry, false);
}

Shape load_operand(ShapeEntry& entry) { return load_form(entry, true); }

void write_shape(json::Writer& out, const MaterialList& materials, const Shape& shape) {
  out.begin_object().member("type", type_name(shape.form));
  std::visit([&](const auto& form) { write(out, materials, form); }, shape.form);
  out.member("name", shape.name);
  out.key("matrix").numbers(shape.matrix.m);
  if (shape.material >= 0) out.member("material", nth(materials, shape.material).name);
  out.end_object();
}

std::vector<Vec3d> bounding_corners(const Shape& shape) {
  std::vector<Vec3d> corners;
  add_corners(shape, Mat4{}, corners);
  return corners;
}

}  // namespace orbs::scene
