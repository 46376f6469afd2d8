#pragma once

#include <vector>

namespace orbs::tracer {

/// The boundary of a plastic's coat, as its diffuse base meets it. `eta` is the index of the coat over that
/// of the outside.
struct PlasticCoat {
  float eta = 1.5F;
  float alpha = 0;  // 0 is smooth
  /// 2 times the integral of R(cos) cos over [0, 1]: what the boundary reflects back into the coat of diffuse
  /// light from inside.
  float reflected_inside = 0;
  /// What the boundary lets through where it is rough, at even steps of the cosine in [0, 1].
  std::vector<float> entering;
};

PlasticCoat make_coat(float eta, float alpha);

/// Steps of PlasticCoat::entering. At alpha 0.1, where it bends most (its second derivative is about 10),
/// linear interpolation is off by 10 / 8 / 128^2 = 8e-5.
constexpr int kCoatSteps = 128;

/// What a rough boundary lets through, linear between the steps.
inline float entering_rough(const float* steps, float cosine) {
  const float place = cosine * kCoatSteps;
  const int below = place < kCoatSteps - 1 ? static_cast<int>(place) : kCoatSteps - 1;
  const float above = place - static_cast<float>(below);
  return steps[below] * (1 - above) + steps[below + 1] * above;
}

}  // namespace orbs::tracer
