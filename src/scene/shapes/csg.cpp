#include "scene/shapes/csg.h"

#include "json/object_reader.h"
#include "json/writer.h"
#include "scene/shapes/shape.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

constexpr int kDeepest = 32;  // CSG within CSG

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

}  // namespace

bool CsgForm::operator==(const CsgForm& other) const {
  return operation == other.operation && operands == other.operands;
}

void load(ShapeEntry& entry, CsgForm& loaded) {
  const std::string word = entry.in.text("type");
  const auto found = std::find(CsgForm::kTypes.begin(), CsgForm::kTypes.end(), word);
  loaded.operation = static_cast<SetOperation>(found - CsgForm::kTypes.begin());
  if (++entry.limits.depth > kDeepest)
    entry.in.fail("operands", fmt::format("are nested more than {} deep", kDeepest));
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

void write(json::Writer& out, const Scene& scene, const CsgForm& form) {
  out.key("operands").begin_array();
  for (const Shape& operand : form.operands) write_shape(out, scene, operand);
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

}  // namespace orbs::scene
