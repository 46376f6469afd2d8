#pragma once

#include "base/vec.h"

#include <array>

namespace orbs::tracer {

/// What paths at four wavelengths carry, in one register.
using Float4 = float __attribute__((vector_size(16)));

inline Float4 float4(const std::array<float, 4>& v) { return Float4{v[0], v[1], v[2], v[3]}; }

/// A factor that is known at N wavelengths of a path as what the path carries.
template <typename Value, std::size_t N>
Value broadcast(const std::array<float, N>& each) {
  if constexpr (N == 1)
    return Value{each[0], each[0], each[0]};
  else
    return float4(each);
}

}  // namespace orbs::tracer
