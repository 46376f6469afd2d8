#include "scene/lights/ies.h"

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"

#include <filesystem>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;

scene::IesProfile load(const std::string& name) {
  const auto file = std::filesystem::path(ORBS_SOURCE_DIR) / "data/common/ies" / name;
  return scene::parse_ies(file.string(), read_file(file));
}

std::string small_file(const std::string& numbers) {
  return "IESNA:LM-63-2002\n[TEST] x\nTILT=NONE\n" + numbers;
}

}  // namespace

// I = 400 c (1 + 3.2 s^2)(1 + .45 s cos f + .25 s sin f + .15 s^2 cos 2f), stored every 2.5 by 15 degrees.
TEST(Ies, TheAsymmetricBatwingHasItsFormula) {
  const auto profile = load("batwing_asymmetric.ies");
  EXPECT_NEAR(scene::candela_at(profile, 0, 0), 400, 5e-3);
  EXPECT_NEAR(scene::candela_at(profile, 45, 90), 810.0, 0.5);
  EXPECT_NEAR(scene::candela_at(profile, 45, 270), 550.0, 0.5);
  EXPECT_EQ(scene::candela_at(profile, 90.5, 0), 0);
  EXPECT_NEAR(scene::candela_at(profile, 45, 90 + 720), scene::candela_at(profile, 45, 90), 1e-9);
}

// Our azimuth: 0 is +X, 90 is +Z of the light, and vertical 0 is -Y.
TEST(Ies, DirectionsAreThoseOfTheLight) {
  const auto profile = load("batwing_asymmetric.ies");
  const double s = std::numbers::sqrt2 / 2;
  EXPECT_NEAR(scene::candela_towards(profile, {0, -3, 0}), 400, 5e-3);
  EXPECT_NEAR(scene::candela_towards(profile, {0, -s, s}), scene::candela_at(profile, 45, 90), 1e-6);
  EXPECT_NEAR(scene::candela_towards(profile, {s, -s, 0}), scene::candela_at(profile, 45, 0), 1e-6);
  EXPECT_EQ(scene::candela_towards(profile, {0, 1, 0}), 0);
}

TEST(Ies, InterpolatesBilinearly) {
  const auto p = scene::parse_ies(
      "x", small_file("1 -1 2 3 3 1 2 0 0 0 0.5 1 10\n0,10 20\n0 90 180\n1 2 3\n3 4 5\n5 6 7\n"));
  EXPECT_DOUBLE_EQ(p.max_candela,
                   7);  // multiplier 2 x ballast 0.5; the third factor of a 2002 file never multiplies
  EXPECT_DOUBLE_EQ(scene::candela_at(p, 5, 45), 2.5);
  EXPECT_DOUBLE_EQ(scene::candela_at(p, 5, 315), 2.5) << "0 to 180 mirrors at the plane of 0 and 180";
  EXPECT_DOUBLE_EQ(scene::candela_at(p, 20, 180), 7);
}

TEST(Ies, UnfoldsTheSymmetryThatTheRangeOfPlanesStates) {
  const auto axial = scene::parse_ies("x", small_file("1 1 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n8 4\n"));
  for (const double phi : {0.0, 77.0, 200.0, 359.0}) EXPECT_DOUBLE_EQ(scene::candela_at(axial, 45, phi), 6);
  const auto quadrant =
      scene::parse_ies("x", small_file("1 1 1 2 3 1 2 0 0 0 1 1 1\n0 90\n0 30 90\n1 1\n2 2\n4 4\n"));
  for (const double phi : {30.0, 150.0, 210.0, 330.0})
    EXPECT_DOUBLE_EQ(scene::candela_at(quadrant, 10, phi), 2) << phi;
  const auto turned =
      scene::parse_ies("x", small_file("1 1 1 2 3 1 2 0 0 0 1 1 1\n0 90\n90 180 270\n1 1\n2 2\n5 5\n"));
  EXPECT_DOUBLE_EQ(scene::candela_at(turned, 10, 0), 2);
  EXPECT_DOUBLE_EQ(scene::candela_at(turned, 10, 45), 1.5);
  EXPECT_DOUBLE_EQ(scene::candela_at(turned, 10, 315), 3.5);
}

// Planes at 90, 140 and 270 mirror to 40; on the circle 0 lies 90 degrees after 270 and 40 before the next.
TEST(Ies, HalvesThatMeetWithoutAPlaneAreJoinedByTheirNeighbours) {
  const auto half =
      scene::parse_ies("x", small_file("1 1 1 2 3 1 2 0 0 0 1 1 1\n0 90\n90 140 270\n1 1\n13 13\n26 26\n"));
  EXPECT_DOUBLE_EQ(scene::candela_at(half, 45, 40), 13);
  EXPECT_DOUBLE_EQ(scene::candela_at(half, 45, 0), 17);
  EXPECT_DOUBLE_EQ(scene::candela_at(half, 45, 360), 17);
  EXPECT_DOUBLE_EQ(scene::candela_at(half, 45, 20), 15);
  EXPECT_DOUBLE_EQ(scene::candela_at(half, 45, 315), 21.5);
}

namespace {

// One candela value a plane, straight down.
std::string planes_file(const std::string& planes, int count) {
  std::string candela;
  for (int i = 0; i < count; ++i) candela += fmt::format("{} {}\n", 10 + i, 10 + i);
  return small_file(fmt::format("1 1 1 2 {} 1 2 0 0 0 1 1 1\n0 90\n{}\n{}", count, planes, candela));
}

std::string refusal_of_planes(const std::string& planes, int count) {
  try {
    scene::parse_ies("x.ies", planes_file(planes, count));
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(Ies, PlanesThatStopWhereNoSymmetryBeginsAreRefused) {
  for (const char* right :
       {"0 90", "0 45 90", "0 180", "0 90 180", "0 180 360", "90 270", "0 120 240", "0 90 180 270"}) {
    const auto count = static_cast<int>(words_of(right).size());
    EXPECT_EQ(refusal_of_planes(right, count), "") << right;
  }
  const auto refused = refusal_of_planes("0 60", 2);
  EXPECT_NE(refused.find("x.ies: not a usable LM-63 file: horizontal angles of type C run from 0 to 0, 90, "
                         "180 or 360, or from 90 to 270, and these from 0 to 60"),
            std::string::npos)
      << refused;
  for (const char* wrong : {"0 45", "0 30 60", "0 22.5 45", "0 30 135", "0 90 181", "0 90 200", "0 180 361",
                            "90 180", "45 90", "180 270"}) {
    const auto count = static_cast<int>(words_of(wrong).size());
    EXPECT_NE(refusal_of_planes(wrong, count), "") << wrong;
  }
}

TEST(Ies, PlanesThatGoAroundWithoutTheLastOneCloseTheCircle) {
  const auto profile = scene::parse_ies("x", planes_file("0 90 180 270", 4));
  EXPECT_DOUBLE_EQ(scene::candela_at(profile, 0, 315), 11.5);
}

// Text files of the world: the keyword in any case and with blanks, and line ends of three systems.
TEST(Ies, TheTiltLineIsFoundHoweverItIsWritten) {
  const std::string numbers = "1 1 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n8 4\n";
  for (const char* line : {"TILT=NONE", "Tilt=none", "TILT = NONE", " tilt\t= None ", "TILT=none"}) {
    const auto text = std::string("IESNA:LM-63-2002\n[TEST] x\n") + line + "\n" + numbers;
    EXPECT_DOUBLE_EQ(scene::parse_ies("x", text).max_candela, 8) << line;
    for (const char* end : {"\r", "\r\n"}) {
      std::string other;
      for (const char c : text) other += c == '\n' ? std::string(end) : std::string(1, c);
      EXPECT_EQ(scene::parse_ies("x", other), scene::parse_ies("x", text)) << line;
    }
  }
  const auto included =
      scene::parse_ies("x", "IESNA:LM-63-2002\nTilt = Include\n1\n2\n0 90\n0.5 1\n" + numbers);
  EXPECT_DOUBLE_EQ(included.max_candela, 4);
}

// Whether the third factor of the ballast line multiplies depends on what the first line says.
TEST(Ies, TheVersionIsFoundHoweverItIsWritten) {
  const std::string rest = "\nTILT=NONE\n1 1 1 2 1 1 2 0 0 0 1 0.5 1\n0 90\n0\n8 4\n";
  for (const char* version : {"IESNA:LM-63-2002", "iesna:lm-63-2002", "\xEF\xBB\xBFIESNA:LM-63-1995"})
    EXPECT_DOUBLE_EQ(scene::parse_ies("x", version + rest).max_candela, 8) << version;
  EXPECT_DOUBLE_EQ(scene::parse_ies("x", "IESNA91" + rest).max_candela, 4);
}

// 100 million numbers would be 800 MB.
TEST(Ies, NumbersThatCannotBeInTheFileAskForNoMemory) {
  std::string angles;
  for (int i = 0; i < 10000; ++i) angles += std::to_string(i * 180.0 / 9999) + "\n";
  try {
    scene::parse_ies("x", small_file("1 1 1 10000 10000 1 2 0 0 0 1 1 1\n" + angles + angles));
    FAIL() << "no error";
  } catch (const InputError& e) {
    EXPECT_STREQ(
        e.what(),
        "x: not a usable LM-63 file: the file ends before its 100000000 numbers called candela value");
  }
}

TEST(Ies, ComplainsAboutWhatItCannotUse) {
  const auto error = [](const std::string& text) {
    try {
      scene::parse_ies("x.ies", text);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(error("").find("no line that starts with TILT="), std::string::npos);
  const std::string wide("I\0E\0S\0", 6);
  for (const auto& text : {"\xFF\xFE" + wide, std::string("\xFE\xFF\0I", 4) + wide, wide})
    EXPECT_NE(error(text).find("its text is in UTF-16; save it in ASCII or UTF-8"), std::string::npos);
  EXPECT_NE(error("TILT=lamp.tlt\n1").find("only NONE and INCLUDE"), std::string::npos);
  EXPECT_NE(error(small_file("1 1 1 2 1 2 2 0 0 0 1 1 1\n")).find("only type C"), std::string::npos);
  EXPECT_NE(error(small_file("1 1 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n8\n"))
                .find("ends where candela value should stand"),
            std::string::npos);
  EXPECT_NE(error(small_file("1 1 1 2 1 1 2 0 0 0 1 1 1\n90 0\n0\n8 4\n")).find("must ascend"),
            std::string::npos);
  EXPECT_NE(error(small_file("1 1 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n8 x\n")).find("'x'"), std::string::npos);
  EXPECT_NE(error(small_file("1 1 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n0 0\n")).find("one must be above 0"),
            std::string::npos);
}
