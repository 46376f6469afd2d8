// What is said of images with one fault, with several, with none, and with noise alone.
#include "judge/diagnosis.h"

#include "base/random.h"
#include "image/colour.h"
#include "unit/judge/images.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr int kSide_px = 64;

// Coloured squares of 11 px with a gradient, a lamp, and nothing alike on any two sides.
float scene_at(int x, int y, std::size_t c) {
  if (x > 40 && x < 48 && y < 6) return 4;
  const float stripe = (x / 11 + 2 * (y / 11)) % 3 == 0 ? 0.6F : 0.15F;
  return stripe * (1 - 0.25F * static_cast<float>(c)) * (0.6F + static_cast<float>(x + 2 * y) / 256);
}

using Fault = std::function<float(int x, int y, std::size_t c)>;

// Noise of 3 % with the seed; 0: none.
image::Image painted(const Fault& at, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> noise(0, 0.03F);
  auto image = image::make_image(kSide_px, kSide_px, {"R", "G", "B"});
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        image.at(x, y, c) = at(x, y, c) * (seed == 0 ? 1 : 1 + noise(random));
  return image;
}

std::string said_of(const image::Image& result, const std::map<std::string, image::Image>& others = {}) {
  const auto diagnosis = judge::diagnosed({result, painted(scene_at, 1), others, {}});
  return diagnosis ? diagnosis->text : "";
}

std::string said_of(const Fault& fault) { return said_of(painted(fault, 2)); }

}  // namespace

TEST(Diagnosis, NamesTheFault) {
  EXPECT_EQ(said_of([](int x, int y, std::size_t c) { return scene_at(x - 2, y - 1, c); }),
            "shifted by (2, 1) px");
  EXPECT_EQ(said_of([](int x, int y, std::size_t c) { return scene_at(kSide_px - 1 - x, y, c); }),
            "mirrored left to right");
  EXPECT_EQ(said_of([](int x, int y, std::size_t c) { return scene_at(y, kSide_px - 1 - x, c); }),
            "turned by 90 degrees to the right");
  EXPECT_EQ(said_of([](int x, int y, std::size_t c) {
              return static_cast<float>(std::numbers::pi) * scene_at(x, y, c);
            }),
            "multiplied by pi");
  EXPECT_EQ(said_of([](int x, int y, std::size_t c) { return 0.97F * scene_at(x, y, c); }).substr(0, 15),
            "multiplied by 0");
  EXPECT_EQ(said_of([](int x, int y, std::size_t c) { return image::srgb_encode(scene_at(x, y, c)); }),
            "encoded for the screen (sRGB), not linear");
  EXPECT_EQ(said_of([](int x, int y, std::size_t c) { return scene_at(x, y, 2 - c); }),
            "with R and B swapped");
  EXPECT_EQ(said_of([](int x, int y, std::size_t c) { return x < 8 ? 0 : scene_at(x, y, c); }),
            "cropped to the pixels [8,0,64,64], black beside them");
}

// The lamp is a rectangle, so what is left looks as if it was cropped to it.
TEST(Diagnosis, TellsEmittersAloneFromACrop) {
  EXPECT_EQ(
      said_of([](int x, int y, std::size_t c) { return x > 40 && x < 48 && y < 6 ? scene_at(x, y, c) : 0; }),
      "emitters alone: no surface reflects their light, as with a trace depth of 0");
  EXPECT_EQ(said_of([](int x, int y, std::size_t c) {
              return x >= 8 && x < 30 && y >= 20 && y < 40 ? scene_at(x, y, c) : 0;
            }),
            "cropped to the pixels [8,20,30,40], black beside them");
}

// The black square is darker than half of the rest.
TEST(Diagnosis, SaysNothingOfADarkPartThatIsBlack) {
  EXPECT_EQ(said_of([](int x, int y, std::size_t c) {
              return scene_at(x, y, c) < 0.2F && x < 30 && y > 20 ? 0 : scene_at(x, y, c);
            }),
            "");
}

TEST(Diagnosis, NamesAMissingMisWeight) {
  const auto said = said_of([](int x, int y, std::size_t c) {
    return (x > 40 && x < 48 && y < 6 ? 1.0F : 2.0F) * scene_at(x, y, c);
  });
  EXPECT_EQ(said.substr(0, 46), "right at emitters and twice as bright elsewher") << said;
}

TEST(Diagnosis, NamesAClampThatLeavesOneValue) {
  auto image = painted(scene_at, 2);
  for (float& value : image.pixels) value = std::min(value, 1.0F);
  EXPECT_EQ(said_of(image), "clamped at 1");
}

TEST(Diagnosis, NamesAnAlphaThatTheImageHas) {
  const auto plain = painted(scene_at, 2);
  auto image = image::make_image(kSide_px, kSide_px, {"R", "G", "B", "A"});
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x) {
      const float alpha = y < 30 ? 0.5F : 1.0F;
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = alpha * plain.at(x, y, c);
      image.at(x, y, 3) = alpha;
    }
  EXPECT_EQ(said_of(image), "multiplied by its alpha once too often");
}

TEST(Diagnosis, NamesTheTargetWhoseImageItIs) {
  const auto one_bounce = [](int x, int y, std::size_t c) {
    return scene_at(x, y, c) * (y > 30 ? 0.5F : 0.9F);
  };
  EXPECT_EQ(said_of(painted(one_bounce, 2), {{"depth1", painted(one_bounce, 3)}}), "the image of 'depth1'");
  EXPECT_EQ(said_of(painted(one_bounce, 2)), "");
}

// Light that one diffuse surface sends to the eye is most of the image, that of two the rest.
TEST(Diagnosis, NamesTheLightPathsThatTheReferenceHoldsAsLayers) {
  auto reference = image::make_image(
      kSide_px, kSide_px,
      {"R", "G", "B", "path.EDL.R", "path.EDL.G", "path.EDL.B", "path.EDDL.R", "path.EDDL.G", "path.EDDL.B"});
  const auto indirect = [](int x, int y, std::size_t c) {
    return 0.1F + 0.1F * static_cast<float>((x / 8 + y / 8 + static_cast<int>(c)) % 2);
  };
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        reference.at(x, y, c) = scene_at(x, y, c) + indirect(x, y, c);
        reference.at(x, y, 3 + c) = scene_at(x, y, c);
        reference.at(x, y, 6 + c) = indirect(x, y, c);
      }
  const auto direct = painted(scene_at, 2);
  const auto diagnosis = judge::diagnosed({direct, reference, {}, {}});
  ASSERT_TRUE(diagnosis);
  EXPECT_EQ(diagnosis->text, "without the light paths EDDL");
}

TEST(Diagnosis, SaysNothingOfNoise) { EXPECT_EQ(said_of(painted(scene_at, 2)), ""); }

TEST(Diagnosis, SaysNothingOfTwoFaultsAtOnce) {
  EXPECT_EQ(said_of([](int x, int y, std::size_t c) {
              return (y > 32 ? 3.0F : 1.0F) * scene_at(kSide_px - 1 - x, y, c);
            }),
            "");
}

TEST(Diagnosis, SaysNothingWhereTwoFaultsLookAlike) {
  const auto grey = painted([](int, int, std::size_t) { return 0.5F; }, 0);
  const auto half = painted([](int, int, std::size_t) { return 0.25F; }, 0);
  EXPECT_FALSE(judge::diagnosed({half, grey, {}, {}}));  // halved, or 0.25 too little
}

TEST(Diagnosis, SaysNothingOfAFaultOfAnotherKind) {
  EXPECT_EQ(said_of([](int x, int y, std::size_t c) {
              return x > 20 && x < 36 && y > 20 && y < 36 ? 0.2F : scene_at(x, y, c);
            }),
            "");
}

TEST(Diagnosis, SaysWhatPsnrIsLeft) {
  const auto reference = painted(scene_at, 0);
  const auto twice = painted([](int x, int y, std::size_t c) { return 2 * scene_at(x, y, c); }, 0);
  EXPECT_EQ(judge::diagnosis_text(judge::diagnosed({twice, reference, {}, {}})),
            "multiplied by 2: else equal to the reference");
  EXPECT_EQ(judge::diagnosis_text(judge::diagnosed({painted(scene_at, 2), painted(scene_at, 0), {}, {}})),
            results::kNoUsualFault);
  const auto noisy = painted([](int x, int y, std::size_t c) { return 2 * scene_at(x, y, c); }, 2);
  const auto text = judge::diagnosis_text(judge::diagnosed({noisy, reference, {}, {}}));
  EXPECT_EQ(text.substr(0, 23), "multiplied by 2: then 4") << text;  // noise of 3 %
}

// With the fault undone it is the reference; the reference with the fault is the result.
TEST(Diagnosis, HasAnImageThatShowsIt) {
  const auto reference = painted(scene_at, 0);
  const auto twice = painted([](int x, int y, std::size_t c) { return 2 * scene_at(x, y, c); }, 0);
  const auto diagnosis = judge::diagnosed({twice, reference, {}, {}});
  ASSERT_TRUE(diagnosis);
  const auto& wanted = diagnosis->is_undone ? reference : twice;
  ASSERT_EQ(diagnosis->proof.pixels.size(), wanted.pixels.size());
  for (std::size_t i = 0; i < wanted.pixels.size(); ++i)
    EXPECT_NEAR(diagnosis->proof.pixels[i], wanted.pixels[i], 1e-5F);
}

TEST(Diagnosis, LeavesOutMaskedPixels) {
  auto image = painted([](int x, int y, std::size_t c) { return 2 * scene_at(x, y, c); }, 2);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x)
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = 0.05F;
  EXPECT_EQ(said_of(image), "");
  const auto masked = judge::diagnosed({image, painted(scene_at, 1), {}, {{{0, 0, 20, 20}}, {}}});
  ASSERT_TRUE(masked);
  EXPECT_EQ(masked->text, "multiplied by 2");
}
