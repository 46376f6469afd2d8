#include "tracer/integrator/path_class.h"

namespace orbs::tracer {

std::string path_class_name(int index) {
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
