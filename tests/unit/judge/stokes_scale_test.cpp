// What the gates of the Stokes parameters' scales and turn say of planted faults, in noise.
#include "metrics/stokes_scale.h"

#include "judge/gate.h"
#include "metrics/image_pair.h"
#include "metrics/table.h"

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <regex>

#include <gtest/gtest.h>

namespace stokes_scale_test {

using namespace orbs;
using results::Verdict;

namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 48;

struct Stokes {
  double s1 = 0;
  double s2 = 0;
  double s3 = 0;
};

using Fault = Stokes (*)(Stokes);

Stokes as_it_is(Stokes s) { return s; }

Stokes turned(Stokes s, double degrees) {
  const double angle = 2 * degrees * std::numbers::pi / 180;
  return {s.s1 * std::cos(angle) - s.s2 * std::sin(angle), s.s1 * std::sin(angle) + s.s2 * std::cos(angle),
          s.s3};
}

// Grey of 0.5, mostly polarised, and `circular` of it circularly; each pixel has noise of its own.
image::Image polarised(Fault fault, double noise, std::uint32_t seed, double circular = 0.6) {
  std::vector<std::string> channels;
  for (const char* layer : {"", "S1.", "S2.", "S3."})
    for (const char* colour : {"R", "G", "B"}) channels.push_back(std::string(layer) + colour);
  auto image = image::make_image(kWidth, kHeight, channels);
  std::mt19937 random(seed);
  std::normal_distribution<double> scatter(0, 1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const auto s = fault({-0.1 - 0.2 * x / kWidth, 0.4 - 0.2 * y / kHeight, 0.5 * circular});
      const std::array values{0.5, s.s1, s.s2, s.s3};
      for (std::size_t i = 0; i < values.size(); ++i) {
        const auto value = static_cast<float>(values.at(i) + noise * scatter(random));
        for (std::size_t c = 0; c < 3; ++c) image.at(x, y, 3 * i + c) = value;
      }
    }
  return image;
}

constexpr double kNoise = 0.02;

metrics::ImagePair pair_of(Fault fault, double noise, std::uint32_t seed, double circular = 0.6) {
  return metrics::make_image_pair(polarised(fault, noise, seed, circular),
                                  polarised(as_it_is, 0, 0, circular));
}

judge::GateResult checked(const std::string& metric, const metrics::ImagePair& pair) {
  const double limit = metric == "stokes_turn" ? 1 : 0.03;
  const auto& info = metrics::find_metric(metric);
  const auto result = info.compute(pair);
  return judge::check_gate(
      {metric, -limit, limit},
      {&info, result.value, {}, result.low, result.high, result.absence, result.what, result.to_pass}, pair);
}

const std::array kGates{"stokes_scale_s1", "stokes_scale_s2", "stokes_scale_s3", "stokes_turn"};

// By the gates that fail, what they say; the others must be met.
void expect_failures(Fault fault, const std::map<std::string, std::string>& words) {
  const auto pair = pair_of(fault, kNoise, 3);
  for (const auto* gate : kGates) {
    const auto result = checked(gate, pair);
    const auto found = words.find(gate);
    EXPECT_EQ(result.verdict, found == words.end() ? Verdict::Pass : Verdict::Fail)
        << gate << ": " << result.reason;
    if (found != words.end()) {
      EXPECT_TRUE(std::regex_search(result.reason, std::regex(found->second))) << result.reason;
    }
  }
}

}  // namespace

TEST(StokesScale, ARightImagePassesWithAnyNoiseOrFewPixels) {
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    const auto pair = pair_of(as_it_is, kNoise, seed);
    for (const auto* gate : kGates)
      EXPECT_EQ(checked(gate, pair).verdict, Verdict::Pass) << gate << ", seed " << seed;
  }
  expect_failures(as_it_is, {});
  const auto exact = pair_of(as_it_is, 0, 1);
  for (const auto* gate : kGates) EXPECT_EQ(checked(gate, exact).verdict, Verdict::Pass) << gate;
}

TEST(StokesScale, EachParametersSignIsJudged) {
  expect_failures(
      [](Stokes s) {
        return Stokes{s.s1, s.s2, -s.s3};
      },
      {{"stokes_scale_s3", "S3 has the other sign"}});
  const auto other_s2 = pair_of([](Stokes s) { return Stokes{s.s1, -s.s2, s.s3}; }, kNoise, 3);
  EXPECT_EQ(checked("stokes_scale_s2", other_s2).verdict, Verdict::Fail);
  EXPECT_EQ(checked("stokes_scale_s1", other_s2).verdict, Verdict::Pass);
}

TEST(StokesScale, AMissingParameterIsNamed) {
  expect_failures([](Stokes s) { return Stokes{s.s1, s.s2, 0}; }, {{"stokes_scale_s3", "S3 is missing"}});
  const auto none = pair_of([](Stokes) { return Stokes{}; }, 0, 3);
  for (const auto* gate : {"stokes_scale_s1", "stokes_scale_s2", "stokes_scale_s3"})
    EXPECT_NE(checked(gate, none).reason.find("is missing"), std::string::npos) << checked(gate, none).reason;
  EXPECT_EQ(checked("stokes_turn", none).verdict, Verdict::Inconclusive);
}

TEST(StokesScale, AFactorIsNamedForEachParameter) {
  expect_failures(
      [](Stokes s) {
        return Stokes{0.95 * s.s1, 0.95 * s.s2, 0.95 * s.s3};
      },
      {{"stokes_scale_s1", "S1 is [45][^ ]* % too small"},
       {"stokes_scale_s2", "S2 is [45][^ ]* % too small"},
       {"stokes_scale_s3", "S3 is [45][^ ]* % too small"}});
}

// And the scales are those of the image whose frame is right.
TEST(StokesScale, ATurnOfTheFrameIsNoFaultOfS1OrS2) {
  expect_failures([](Stokes s) { return turned(s, 2); },
                  {{"stokes_turn", "its frame is turned by 2 degrees"}});
  expect_failures([](Stokes s) { return turned(s, -2); },
                  {{"stokes_turn", "its frame is turned by 2 degrees"}});
  EXPECT_EQ(checked("stokes_turn", pair_of([](Stokes s) { return turned(s, 0.5); }, kNoise, 3)).verdict,
            Verdict::Pass);
}

TEST(StokesScale, WhatNoiseHidesIsInconclusive) {
  const auto noisy = pair_of(as_it_is, 20, 3);
  for (const auto* gate : kGates)
    EXPECT_EQ(checked(gate, noisy).verdict, Verdict::Inconclusive) << checked(gate, noisy).reason;
}

TEST(StokesScale, AParameterThatTheReferenceHardlyHasIsNotJudged) {
  const auto negated = [](Stokes s) { return Stokes{s.s1, s.s2, -s.s3}; };
  const auto result = checked("stokes_scale_s3", pair_of(negated, kNoise, 3, 0.0013));
  EXPECT_EQ(result.verdict, Verdict::Pass);
  EXPECT_EQ(result.reason,
            "S3 of the reference is 0.13 % of the light, too little to judge its scale and sign");
}

TEST(StokesScale, LayersMustBeThere) {
  const auto reference = polarised(as_it_is, 0, 0);
  const auto without = metrics::make_image_pair(image::select_rgb(reference, ""), reference);
  const auto neither =
      metrics::make_image_pair(image::select_rgb(reference, ""), image::select_rgb(reference, ""));
  for (const auto* gate : kGates) {
    EXPECT_EQ(checked(gate, without).verdict, Verdict::Fail) << gate;
    EXPECT_EQ(checked(gate, neither).verdict, Verdict::Pass) << gate;
  }
}

// What noise moves a right image by lies within the interval, which is not much wider.
TEST(StokesScale, TheIntervalIsThatOfTheNoise) {
  double squares = 0;
  double reach = 0;
  constexpr int kSeeds = 100;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    const auto scales = metrics::stokes_scales(pair_of(as_it_is, kNoise, seed));
    ASSERT_TRUE(scales && scales->turn_deg);
    squares += scales->turn_deg->value * scales->turn_deg->value / kSeeds;
    reach += scales->turn_deg->standard_error / kSeeds;
  }
  EXPECT_NEAR(reach, std::sqrt(squares), 0.25 * reach);
}

}  // namespace stokes_scale_test
