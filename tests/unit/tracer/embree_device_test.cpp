// Images are equal to the bit on every x86-64 only if Embree takes the same kernels on each of them, whatever
// the processor could do beyond. This program's own rtcNewDevice notes what the tracer asks Embree's for.
#include "base/text.h"
#include "tracer/accel/embree_api.h"
#include "unit/tracer/scenes.h"

#include <string>
#include <vector>

#include <dlfcn.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

std::vector<std::string>& asked() {
  static std::vector<std::string> settings;
  return settings;
}

// What Embree says of a device with these settings: one line for each of its own.
std::vector<std::string> description_of(const std::string& settings) {
  testing::internal::CaptureStdout();
  rtcReleaseDevice(rtcNewDevice((settings + ",verbose=2").c_str()));
  return orbs::split(testing::internal::GetCapturedStdout(), '\n');
}

// The last line of the description that starts so: the processor's comes first, the device's own below it.
std::string last_line(const std::vector<std::string>& lines, const std::string& start) {
  for (auto line = lines.rbegin(); line != lines.rend(); ++line)
    if (orbs::trim(*line).starts_with(start)) return *line;
  return "";
}

}  // namespace

extern "C" RTCDevice rtcNewDevice(const char* settings) {
  using Make = RTCDevice (*)(const char*);
  static const auto make = reinterpret_cast<Make>(dlsym(RTLD_NEXT, "rtcNewDevice"));
  asked().emplace_back(settings == nullptr ? "" : settings);
  return make(settings);
}

TEST(EmbreeDevice, IsAskedForTheKernelsThatEveryMachineHas) {
  asked().clear();
  const auto text =
      orbs::tests::scene_text("[0, 0, 1]", "[0, 0, 0]", 2, 1,
                              R"("materials": [{"name": "m", "type": "lambert", "reflectance": [1, 1, 1]}],
         "meshes": [{"name": "p", "generator": "plane", "half_size": 1, "material": "m"}],
         "instances": [{"mesh": "p"}])");
  orbs::tracer::make_world(orbs::scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR));
  ASSERT_EQ(asked().size(), 1u) << "one device for each world";
  EXPECT_EQ(asked().front(), orbs::tracer::kDeviceSettings);
}

TEST(EmbreeDevice, TakesAvx2WhateverElseTheProcessorHas) {
#if !defined(__x86_64__)
  GTEST_SKIP() << "this processor has one set of kernels";
#endif
  const auto lines = description_of(orbs::tracer::kDeviceSettings);
  const auto kernels = last_line(lines, "ISA");
  EXPECT_NE(kernels.find(" AVX2 "), std::string::npos) << kernels;
  EXPECT_EQ(kernels.find("AVX512"), std::string::npos) << kernels;
  const auto trees = last_line(lines, "frequency_level");
  EXPECT_NE(trees.find("simd256"), std::string::npos) << trees;
  // The two settings are read at all: with others Embree says others.
  const auto older = description_of("isa=sse2,frequency_level=simd128");
  EXPECT_EQ(last_line(older, "ISA").find("AVX"), std::string::npos) << last_line(older, "ISA");
  EXPECT_NE(last_line(older, "frequency_level").find("simd128"), std::string::npos);
}
