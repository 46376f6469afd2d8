// The pixel hashes of references that lie in one file beside them.
#include "results/image_hashes.h"

#include "image/image_io.h"
#include "judge/provenance.h"
#include "judge/reference.h"
#include "structure/source_files.h"

#include <algorithm>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

image::Image grey_image(float value) {
  auto image = image::make_image(3, 2, {"R", "G", "B"});
  std::fill(image.pixels.begin(), image.pixels.end(), value);
  return image;
}

}  // namespace

TEST(ImageHashes, AReferenceWithOtherPixelsIsNone) {
  const structure::TestFolder scratch("judge-image-hashes");
  scratch.write("keep", "");
  registry::Case one_case;
  one_case.scenes.emplace_back();
  one_case.scenes.back().name = "a";
  image::write_exr(grey_image(0.75F), scratch.path() / "a.exr");
  results::write_image_hashes({{"a", judge::image_hash(grey_image(0.75F))}}, scratch.path());
  EXPECT_TRUE(judge::load_reference(one_case, "a", scratch.path()).image);
  image::write_exr(grey_image(0.5F), scratch.path() / "a.exr");
  const auto changed = judge::load_reference(one_case, "a", scratch.path());
  EXPECT_FALSE(changed.image);
  EXPECT_NE(changed.problem.find("image-hashes.json says"), std::string::npos) << changed.problem;
}
