
#include "image/image_io.h"
#include "judge/judge.h"
#include "judge/provenance.h"
#include "judge/reference.h"
#include "registry/image_size.h"
#include "structure/source_files.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

// 16 x 8 px, 1 in the left half of each 4 x 4 px and `right` in the other, with the variance 0.0016.
image::Image halves(float right) {
  auto image = image::make_image(16, 8, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 6; ++c) image.at(x, y, c) = c > 2 ? 0.0016F : (x % 4 < 2 ? 1.0F : right);
  image.attributes["orbs.scene_hash"] = "1234";
  image.attributes["orbs.image_hash"] = judge::image_hash(image);
  image.attributes["orbs.noise_psnr_srgb8_db"] = "0";
  return image;
}

registry::Case case_with_difference() {
  registry::Case made;
  made.requirement = "M1";
  made.scenes = {{"a", "a.json", 4}, {"b", "b.json", 4}};
  made.differences = {{"d", "a", "b"}};
  made.gates = {{"psnr_srgb8", 35}};
  return made;
}

}  // namespace

TEST(ReducedReference, HasARecordOfItsOwn) {
  const auto reduced = judge::reduced_reference(halves(0.5F), 4);
  EXPECT_EQ(reduced.at(0, 0, 0), 0.75F);
  EXPECT_FLOAT_EQ(reduced.at(0, 0, 3), 0.0001F);
  const auto provenance = judge::provenance_of(reduced);
  EXPECT_EQ(provenance.at("averaged_over"), "4 x 4 px");
  EXPECT_EQ(provenance.at("scene_hash"), "1234");
  EXPECT_EQ(provenance.at("image_hash"), judge::image_hash(reduced));
  // The slope of the sRGB curve at 0.75 is 1.055 / 2.4 * 0.75^(-7/12) = 0.5199, the deviation 0.01.
  EXPECT_NEAR(std::stod(provenance.at("noise_psnr_srgb8_db")), -20 * std::log10(0.01 * 0.5199), 0.02);
}

TEST(ReducedReference, IsReadAsItIsCopied) {
  const structure::TestFolder scratch("judge-reduced-reference");
  scratch.write("copies/keep", "");
  image::write_exr(halves(0.5F), scratch.path() / "a.exr");
  image::write_exr(halves(0.25F), scratch.path() / "b.exr");
  const auto hashes = std::map<std::string, std::string>{{"a", "1234"}, {"b", "1234"}};
  const auto folder = scratch.path() / "copies";
  const auto copies = judge::copy_references({case_with_difference()}, scratch.path(), hashes, folder, {4});
  for (const char* target : {"a", "b", "d"}) {
    const auto copied =
        judge::load_reference(case_with_difference(), target, scratch.path(), hashes, copies, {4});
    const auto read = judge::load_reference(case_with_difference(), target, scratch.path(), hashes, {}, {4});
    ASSERT_TRUE(copied.image && read.image) << copied.problem << read.problem;
    EXPECT_EQ(copied.image->width, {4});
    EXPECT_EQ(copied.image->pixels, read.image->pixels) << target;
    EXPECT_EQ(image::read_image(folder / (std::string(target) + ".exr")).height, 2);
  }
  EXPECT_EQ(judge::load_reference(case_with_difference(), "d", scratch.path(), hashes, copies, {4})
                .image->at(0, 0, 0),
            0.125F);
}

// Averaging would hide it: what is judged must be what was accepted.
TEST(ReducedReference, IsMissingWhereTheFullOneIsStale) {
  const structure::TestFolder scratch("judge-reduced-stale");
  scratch.write("copies/keep", "");
  auto changed = halves(0.5F);
  std::swap(changed.at(0, 0, 0), changed.at(3, 0, 0));  // the mean stays
  image::write_exr(changed, scratch.path() / "a.exr");
  image::write_exr(halves(0.25F), scratch.path() / "b.exr");
  const auto hashes = std::map<std::string, std::string>{{"a", "1234"}, {"b", "5678"}};
  const auto copies = judge::copy_references({case_with_difference()}, scratch.path(), hashes,
                                             scratch.path() / "copies", {4});
  for (const auto& from : {copies, judge::ReferenceCopies{}}) {
    const auto a = judge::load_reference(case_with_difference(), "a", scratch.path(), hashes, from, {4});
    EXPECT_FALSE(a.image);
    EXPECT_NE(a.problem.find("is not the image that was accepted"), std::string::npos) << a.problem;
    const auto b = judge::load_reference(case_with_difference(), "b", scratch.path(), hashes, from, {4});
    EXPECT_FALSE(b.image);
    EXPECT_NE(b.problem.find("scene 'b' has changed"), std::string::npos) << b.problem;
  }
}

TEST(ReducedReference, SaysWhichPixelsAreNotChecked) {
  auto full = case_with_difference();
  full.pixel_checks = {{"a", {0, 0, 1, 1}, {9, 9, 9}, 0.1, "single pixel"},
                       {"a", {0, 0, 8, 8}, {0.75, 0.75, 0.75}, 1e-5, "mean of halves"}};
  results::TargetRecord record;
  record.target = "a";
  const auto image = image::select_rgb(judge::reduced_reference(halves(0.5F), 4), "");
  judge::judge_image(registry::reduced_case(full, 4), image, {"a.exr", image, ""}, {}, record);
  EXPECT_NE(record.verdict, results::Verdict::Fail) << record.reason;
  ASSERT_EQ(record.checks.size(), 3U);
  EXPECT_FALSE(record.checks[1].measured);
  EXPECT_FALSE(record.checks[1].passed);
  EXPECT_EQ(record.checks[1].reason,
            "pixels [0,0,1,1]: not measured at 1/4: these pixels of the full size fill none there");
  EXPECT_TRUE(record.checks[2].measured && record.checks[2].passed) << record.checks[2].reason;
}
