// The noise of a reference stays, however many samples a renderer takes. Its variance may be half of what a
// pass leaves room for: then it costs a right renderer twice the samples at most, and leaves none undecided.
#include "base/parallel.h"
#include "judge/judge.h"
#include "references/noise_limits.h"
#include "registry/cases.h"
#include "registry/configuration.h"

#include <algorithm>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

using namespace orbs;

namespace {

// Its light lies on a few tiles, in colours of which a part is outside of Rec. 709 and negative: a tile has a
// standard error of 2.5 %, in red of 8 %. Seven times the samples would do for green and blue.
bool is_known_to_be_noisy(const std::string& name) { return name == "appearance prism_SF10"; }

// What the noise of the reference leaves of the room for a verdict; the PSNR is no matter here.
std::vector<std::string> too_noisy(const std::string& name,
                                   const registry::Case& one_case,
                                   const image::Image& reference) {
  auto noise = references::noise_of(reference);
  const auto most = references::most_noise(one_case.gates);
  noise.psnr_db = most.psnr_db;
  if (references::times_too_noisy(noise, most) <= 1) return {};
  return {fmt::format("{}: the reference has a noise of {}, at most {} is wanted", name,
                      references::noise_text(noise), references::noise_text(most))};
}

}  // namespace

TEST(EveryReference, LeavesRoomForADecision) {
  std::vector<std::function<std::vector<std::string>()>> tasks;
  for (const auto& suite : registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json").suites)
    for (const auto& one_case : registry::load_cases(suite))
      for (const auto& name : registry::target_names(one_case))
        tasks.emplace_back([=]() -> std::vector<std::string> {
          const auto reference = judge::load_reference(one_case, name, suite.references);
          if (!reference.image || judge::is_difference(one_case, name)) return {};
          const std::string display_name = suite.name + " " + name;
          auto complaints = too_noisy(display_name, one_case, *reference.image);
          if (!is_known_to_be_noisy(display_name)) return complaints;
          if (complaints.empty())
            complaints.push_back(display_name + ": is no longer noisy, and is to be no exception");
          else
            complaints.clear();
          return complaints;
        });
  std::mutex mutex;
  std::vector<std::string> complaints;
  for_each_index(static_cast<int>(tasks.size()), 0, [&](int index) {
    auto found = tasks[static_cast<std::size_t>(index)]();
    const std::lock_guard lock(mutex);
    complaints.insert(complaints.end(), found.begin(), found.end());
  });
  std::sort(complaints.begin(), complaints.end());
  EXPECT_TRUE(complaints.empty()) << fmt::format("{}", fmt::join(complaints, "\n"));
}
