#include "tracer/integrator/path_class.h"

#include <set>

#include <gtest/gtest.h>

using namespace orbs::tracer;

TEST(PathClass, HasTheNotationOfTheSpecification) {
  PathClass path;
  EXPECT_EQ(path_class_name(path.index()), "EL");
  path.append(Event::Diffuse, false);
  EXPECT_EQ(path_class_name(path.index()), "EDL");
  path.append(Event::Specular, true);
  EXPECT_EQ(path_class_name(path.index()), "EDSL-T");
  path.append(Event::Glossy, false);
  EXPECT_EQ(path_class_name(path.index()), "EDSGL-T");
  path.append(Event::Glossy, false);
  EXPECT_EQ(path_class_name(path.index()), "other");
}

TEST(PathClass, EveryNumberHasItsOwnName) {
  std::set<std::string> names;
  for (int i = 0; i < PathClass::kCount; ++i) names.insert(path_class_name(i));
  EXPECT_EQ(static_cast<int>(names.size()), PathClass::kCount);
}
