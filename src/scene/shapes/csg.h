#pragma once

#include "scene/shapes/shape_type.h"

#include <array>
#include <vector>

namespace orbs::scene {

enum class SetOperation { Union, Intersection, Difference };

struct Shape;

/// Constructive solid geometry, operand after operand: a - b - c is (a - b) - c. The operands are closed.
struct CsgForm {
  static constexpr std::array kTypes{"union", "intersection", "difference"};
  static constexpr const char* kWhat = "a solid by CSG";
  static constexpr const char* kLevel = "S4";
  SetOperation operation = SetOperation::Union;
  std::vector<Shape> operands;  // two or more
  bool operator==(const CsgForm& other) const;
};

inline const char* type_word(const CsgForm& form) {
  return CsgForm::kTypes[static_cast<std::size_t>(form.operation)];
}

/// Its operands are shapes again, so that these are in shape.cpp.
void load(ShapeEntry& entry, CsgForm& loaded);
void write(json::Writer& out, const MaterialList& materials, const CsgForm& form);
inline bool is_closed(const CsgForm&) { return true; }
/// Nothing: its operands have bounds, each under its own matrix (bounding_corners).
inline std::optional<LocalBox> bounds(const CsgForm&) { return std::nullopt; }
inline std::optional<Mesh> tessellated(const CsgForm&) { return std::nullopt; }

/// Whether the solid has an end. Those without one would fill space: a half-space, a union with one, what it
/// is taken from, and an intersection of nothing else.
bool is_bounded(const Shape& shape);

}  // namespace orbs::scene
