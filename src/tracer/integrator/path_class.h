#pragma once

#include "tracer/bsdf/bsdf_sample.h"

#include <cstdint>
#include <string>

namespace orbs::tracer {

/// The events of a path from the eye to the light, in Heckbert's notation as used by ORB.S REQ_A2 to A4:
/// "EDSL" is diffuse, then specular, then the light. Paths with more than three scattering events share one
/// class. A path with a transmission is of the class "...-T".
class PathClass {
 public:
  static constexpr int kMostEvents = 3;
  /// 40 words of up to three letters out of three, each with and without transmission, and one class for the
  /// rest.
  static constexpr int kCount = 2 * (1 + 3 + 9 + 27) + 1;

  /// Appends a scattering event at the light's end.
  void append(Event event, bool is_transmitted) {
    if (length_ < kMostEvents) word_ = word_ * 3 + static_cast<int>(event);
    ++length_;
    has_transmission_ = has_transmission_ || is_transmitted;
  }

  /// Prepends a scattering event at the eye's end.
  void prepend(Event event, bool is_transmitted) {
    constexpr int kPowers[] = {1, 3, 9};
    if (length_ < kMostEvents) word_ += kPowers[length_] * static_cast<int>(event);
    ++length_;
    has_transmission_ = has_transmission_ || is_transmitted;
  }

  /// Number of the class in [0, kCount).
  int index() const {
    if (length_ > kMostEvents) return kCount - 1;
    constexpr int kFirst[] = {0, 1, 4, 13};  // number of shorter words
    return 2 * (kFirst[length_] + word_) + (has_transmission_ ? 1 : 0);
  }

 private:
  int word_ = 0;
  int length_ = 0;
  bool has_transmission_ = false;
};

/// "EL", "EDSL", "EDSSL-T" or "other"; `index` in [0, kCount).
std::string path_class_name(int index);

}  // namespace orbs::tracer
