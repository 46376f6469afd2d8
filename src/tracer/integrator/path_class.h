#pragma once

#include "tracer/bsdf/bsdf_sample.h"

#include <cstdint>
#include <string>

namespace orbs::tracer {

/// The events of a path from the eye to the light, in Heckbert's notation (1990) as ORB.S REQ_A2 to A4 use
/// it, and with G for glossy: "EDSL" is diffuse, then specular, then the light. A path with a transmission
/// anywhere ends in "-T". All paths with more than three scattering events share the class "other".
class PathClass {
 public:
  static constexpr int kMaxEvents = 3;
  /// Words of 0 to 3 of the letters D, S and G, each with and without transmission, and one class for all
  /// longer paths.
  static constexpr int kCount = 2 * (1 + 3 + 9 + 27) + 1;

  /// Appends a scattering event at the light's end.
  void append(Event event, bool is_transmitted) {
    if (length_ < kMaxEvents) word_ = word_ * 3 + static_cast<int>(event);
    ++length_;
    has_transmission_ = has_transmission_ || is_transmitted;
  }

  /// Prepends a scattering event at the eye's end.
  void prepend(Event event, bool is_transmitted) {
    constexpr int kPowers[] = {1, 3, 9};
    if (length_ < kMaxEvents) word_ += kPowers[length_] * static_cast<int>(event);
    ++length_;
    has_transmission_ = has_transmission_ || is_transmitted;
  }

  /// Number of the class in [0, kCount).
  int index() const {
    if (length_ > kMaxEvents) return kCount - 1;
    constexpr int kFirst[] = {0, 1, 4, 13};  // number of shorter words
    return 2 * (kFirst[length_] + word_) + (has_transmission_ ? 1 : 0);
  }

 private:
  int word_ = 0;
  int length_ = 0;
  bool has_transmission_ = false;
};

/// "EL", "EDSL", "EDSSL-T" or "other"; `index` in [0, kCount).
inline std::string path_class_name(int index) {
  if (index == PathClass::kCount - 1) return "other";
  int word = index / 2;
  int length = 0;
  // Words are numbered by length first. What is left after all shorter words is the word in base 3.
  for (int words = 1; word >= words; words *= 3) {
    word -= words;
    ++length;
  }
  std::string events;
  for (int i = 0; i < length; ++i) {
    events.insert(events.begin(), "DSG"[word % 3]);
    word /= 3;
  }
  return "E" + events + "L" + (index % 2 == 1 ? "-T" : "");
}

}  // namespace orbs::tracer
