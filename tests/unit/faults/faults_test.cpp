// Each row of the catalogue on a painted image: it is the fault that it is called.
#include "faults/fault.h"
#include "image/colour.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

using namespace orbs;
using faults::Use;

namespace {

constexpr int kSide_px = 96;

// A coloured pattern with edges, a highlight of 3, shadows, and noise of 2 % that the variance knows.
image::Image painted() {
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0, 0.02F);
  auto image =
      image::make_image(kSide_px, kSide_px, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        float value = (x / 11 + y / 11) % 2 == 0 ? 0.5F : 0.1F;
        if (x < 11 && y < 11) value = 3;
        if (x > 80) value = 0.005F;
        value *= 1 - 0.3F * static_cast<float>(c);
        image.at(x, y, c) = value * (1 + noise(random));
        image.at(x, y, c + 3) = 0.0004F * value * value;
      }
  return image;
}

image::Image applied(Use use, const std::string& name, const image::Image& image) {
  for (const auto& row : faults::rows_of(use, image))
    if (row.name == name) return faults::applied(row, image);
  ADD_FAILURE() << "no row " << name;
  return image;
}

}  // namespace

TEST(Faults, AreTheFaultThatTheyAreCalled) {
  const auto image = painted();
  const auto mutant = [&](const std::string& name) { return applied(Use::Mutation, name, image); };
  EXPECT_FLOAT_EQ(mutant("half the light").at(50, 50, 1), 0.5F * image.at(50, 50, 1));
  EXPECT_FLOAT_EQ(mutant("+2 % light").at(50, 50, 1), 1.02F * image.at(50, 50, 1));
  EXPECT_FLOAT_EQ(mutant("+2 % light").at(50, 50, 4), 1.0404F * image.at(50, 50, 4));
  EXPECT_EQ(mutant("shifted by 1 px").at(50, 50, 0), image.at(49, 50, 0));
  EXPECT_EQ(mutant("R and B swapped").at(50, 50, 0), image.at(50, 50, 2));
  EXPECT_EQ(mutant("R and B swapped").at(50, 50, 3), image.at(50, 50, 5));
  EXPECT_EQ(mutant("clamped at 1").at(3, 3, 0), 1.0F);
  EXPECT_EQ(mutant("clamped at 1").at(3, 3, 3), 0.0F);
  EXPECT_FLOAT_EQ(
      mutant("half resolution").at(51, 50, 0),
      (image.at(50, 50, 0) + image.at(51, 50, 0) + image.at(50, 51, 0) + image.at(51, 51, 0)) / 4);
  EXPECT_TRUE(std::isnan(mutant("one NaN").at(48, 48, 1)));
  const auto typical = [&](const std::string& name) { return applied(Use::Diagnosis, name, image); };
  EXPECT_EQ(typical("shifted by (2, 1) px").at(50, 50, 0), image.at(48, 49, 0));
  EXPECT_EQ(typical("mirrored").at(5, 50, 0), image.at(kSide_px - 6, 50, 0));
  EXPECT_EQ(typical("sRGB encoded").at(50, 50, 0), image::srgb_encode(image.at(50, 50, 0)));
  EXPECT_EQ(typical("cropped").at(11, 50, 0), 0);
  EXPECT_EQ(typical("cropped").at(12, 50, 0), image.at(12, 50, 0));
}

TEST(Faults, TurnsAreTheTurnsOfTheirText) {
  auto image = image::make_image(3, 3, {"R", "G", "B"});
  image.at(2, 0, 0) = 1;  // the upper right corner
  image.at(1, 0, 0) = 2;  // the middle of the upper edge
  const faults::Turn right{.mirrors_y = true, .exchanges = true};
  EXPECT_EQ(right.text(), "turned by 90 degrees to the right");
  EXPECT_EQ(right.apply(image).at(2, 2, 0), 1);
  EXPECT_EQ(right.apply(image).at(2, 1, 0), 2);
  const faults::Turn left{.mirrors_x = true, .exchanges = true};
  EXPECT_EQ(left.text(), "turned by 90 degrees to the left");
  EXPECT_EQ(left.apply(image).at(0, 0, 0), 1);
  EXPECT_EQ(left.apply(image).at(0, 1, 0), 2);
  EXPECT_EQ(faults::Turn{.mirrors_x = true}.apply(image).at(0, 0, 0), 1);
  EXPECT_EQ(faults::Turn{.mirrors_y = true}.apply(image).at(1, 2, 0), 2);
}

// Between whole pixels a line stays a line, by either interpolation, and whole shifts copy.
TEST(Faults, InterpolationKeepsLines) {
  auto image = image::make_image(32, 4, {"R", "G", "B"});
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 32; ++x) image.at(x, y, 0) = static_cast<float>(x);
  for (const auto between : {faults::Between::Linear, faults::Between::Cubic})
    EXPECT_FLOAT_EQ((faults::Shift{0.25, 0, between}.apply(image).at(16, 2, 0)), 15.75F);
  EXPECT_FLOAT_EQ((faults::Magnification{2}.apply(image).at(31, 2, 0)), 23.25F);
}

// What the image loses with a fault that can be undone is rounding.
TEST(Faults, UndoingGivesTheImageBack) {
  const auto image = painted();
  const auto expect_same = [&](const image::Image& undone) {
    for (std::size_t i = 0; i < image.pixels.size(); i += image.channel_count())
      ASSERT_NEAR(undone.pixels[i], image.pixels[i], 1e-5F);
  };
  const faults::Factor factor{0.7};
  expect_same(factor.undo(factor.apply(image)));
  const faults::Offset offset{0.7};
  expect_same(offset.undo(offset.apply(image)));
  using Kind = faults::Curve::Kind;
  for (const auto kind : {Kind::SrgbEncoded, Kind::SrgbDecoded, Kind::Gamma22Encoded, Kind::Gamma22Decoded}) {
    const faults::Curve curve{kind};
    expect_same(*curve.undo(curve.apply(image)));
  }
  EXPECT_FALSE(faults::Curve{Kind::SrgbEncodedAndClamped}.undo(image));
}

// Two rows of one name would be one row of the reports, and a row that changes nothing is no fault.
TEST(Faults, HaveNamesOfTheirOwnAndChangeTheImage) {
  const auto image = painted();
  for (const auto use : {Use::Mutation, Use::Sensitivity, Use::Diagnosis}) {
    std::set<std::string> names;
    for (const auto& row : faults::rows_of(use, image)) {
      EXPECT_TRUE(names.insert(row.name).second) << row.name;
      EXPECT_FALSE(image::has_same_colours(faults::applied(row, image), image)) << row.name;
    }
    EXPECT_GE(names.size(), 11U);
  }
}

// The study of the diagnosis compares its answers with these words: a kind that is renamed must be renamed
// there.
TEST(Faults, RightDiagnosesBeginAsTheirFaultIsCalled) {
  int compared = 0;
  for (const auto& row : faults::catalogue(painted())) {
    if (row.diagnosis.empty()) continue;
    const auto text = std::visit(
        [](const auto& fault) -> std::string {
          if constexpr (requires { fault.text(); }) return fault.text();
          return "(the diagnosis does not know this kind)";
        },
        row.fault);
    EXPECT_TRUE(text.starts_with(row.diagnosis)) << row.name << ": " << text << ", not " << row.diagnosis;
    ++compared;
  }
  EXPECT_EQ(compared, 25);
}

TEST(Faults, OfTheColoursAloneLeaveTheVariances) {
  const auto image = painted();
  for (const auto& row : faults::catalogue(image)) {
    if (row.reach != faults::Reach::Colours) continue;
    const auto faulty = faults::applied(row, image);
    EXPECT_EQ(faulty.channels, image.channels) << row.name;
    for (std::size_t i = 3; i < image.pixels.size(); i += 6)
      ASSERT_EQ(faulty.pixels[i], image.pixels[i]) << row.name;
  }
}

TEST(Faults, ALeakAvoidsTheMask) {
  std::vector<std::uint8_t> included(static_cast<std::size_t>(kSide_px) * kSide_px, 1);
  std::fill_n(included.begin(), 60 * kSide_px, std::uint8_t{0});
  const auto where = faults::leak_of_mean_light(painted(), included).where;
  EXPECT_GE(where.y0, 60);
  EXPECT_EQ(where.x1 - where.x0, 16);
  EXPECT_EQ(where.x0 % 16, 4);
}
