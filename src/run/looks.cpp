#include "run/looks.h"

#include "base/duration.h"
#include "base/files.h"
#include "base/two_digits.h"
#include "registry/placeholders.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

namespace orbs::run {

namespace {

constexpr int kFewest = 16;
constexpr int kLargestStep = 16;
// A shorter step is tried where it is likely to do, and only where rendering takes longer than starting and
// judging.
constexpr double kLikelyWithHalfAgain = 1.4;
constexpr int kFewestForHalfAgain = 512;
constexpr int kSeeds = 2048;  // a renderer's seed_stride of a million times that is a seed of 32 bits

int power_of_two_below(int number) { return static_cast<int>(std::bit_floor(static_cast<unsigned>(number))); }

int power_of_two_above(int number) { return static_cast<int>(std::bit_ceil(static_cast<unsigned>(number))); }

// The step is odd, so as many as there are seeds differ.
int seed_of(int run_seed, int render) {
  constexpr int kStep = 1103;
  const auto start = static_cast<int>(content_hash(fmt::format("looks {}", run_seed)) % kSeeds);
  return 1 + (start + render * kStep) % kSeeds;
}

}  // namespace

int first_look_spp(const Plan& plan, const registry::Renderer& renderer) {
  const auto& sampling = renderer.sampling;
  if (plan.settings.fixed_samples || sampling.is_noise_free || sampling.has_fixed_samples) return 0;
  if (plan.place == RenderPlace::Elsewhere || !plan.images.empty()) return 0;
  if (!registry::uses_placeholder(renderer.command.words, "spp") || !takes_seed(renderer.command)) return 0;
  return std::max(kFewest, 2 * power_of_two_above(sampling.least_spp));
}

int most_spp(const Plan& plan, const PlannedJob& job) {
  constexpr int kUsual = 4096;
  constexpr double kPaths = 0x1p28;
  const auto& camera = plan.scenes[job.scene].scene->camera;
  const double of_small = kPaths / (static_cast<double>(camera.width_px) * camera.height_px);
  return power_of_two_below(static_cast<int>(std::max<double>(kUsual, of_small)));
}

int first_guess_spp(const PlannedJob& job) {
  const int below = power_of_two_below(job.spp);
  return job.spp < std::sqrt(2.0) * below ? below : 2 * below;
}

namespace {

// The shortest step from which the looks that are left reach `most` by the largest ones.
int least_step(int most, int spp, int looks) {
  const double largest_of_others = std::pow(kLargestStep, std::max(0, kMostLooks - looks - 1));
  const double step = std::ceil(most / (spp * largest_of_others));
  return power_of_two_above(static_cast<int>(std::clamp<double>(step, 2, kLargestStep)));
}

}  // namespace

int samples_after_next(const Plan& plan, const PlannedJob& job, int looks, int spp, const judge::Need& need) {
  const bool counts_images = !plan.renderers[job.renderer].entry.command.sequence.words.empty();
  if (counts_images) return 2 * spp;
  const int least = least_step(most_spp(plan, job), spp, looks);
  const int next = least * power_of_two_below(spp);
  if (spp > power_of_two_below(spp)) return next;
  if (least == 2 && spp >= kFewestForHalfAgain && need.samples < kLikelyWithHalfAgain) return spp + spp / 2;
  if (!(need.at_best > least)) return next;
  return spp * power_of_two_below(static_cast<int>(std::min<double>(kLargestStep, need.at_best)));
}

PlannedLook next_look(const Plan& plan, const PlannedJob& job, int looks, int before, int after) {
  const int run_seed = plan.settings.seed;
  PlannedLook look{(after - before) / 2, {seed_of(run_seed, 2 * looks), seed_of(run_seed, 2 * looks + 1)}};
  if (plan.renderers[job.renderer].entry.command.sequence.words.empty()) return look;
  constexpr int kImages = 4;
  const int images_before = kImages * (run_seed - 1) + (looks == 0 ? 0 : 2);
  look.seeds = {images_before + 1, images_before + 2};
  return look;
}

PlannedLook first_look(const Plan& plan, const PlannedJob& job) {
  return next_look(plan, job, 0, 0, job.first_spp);
}

namespace {

// Times the samples that decide it, at least twice.
double times_to_decide(const judge::Look& look) {
  return std::max(2.0, std::isfinite(look.need.samples) ? look.need.samples : look.need.at_best);
}

std::string noise_text(const judge::Look& look, const LooksSoFar& so_far) {
  const double times = times_to_decide(look);
  if (!std::isfinite(times)) return "its noise; too few samples to tell how much";
  return fmt::format("its noise: about {} times the samples ({}) would decide it", two_digits(times),
                     duration_text(so_far.seconds + seconds_to_decide(look, so_far)));
}

// A prediction counts where even at best it is far beyond, and not before it rests on some looks.
constexpr int kFewestToPredict = 3;

bool is_beyond_samples(const judge::Look& look, const LooksSoFar& so_far) {
  const double at_best = so_far.spp * std::max(2.0, look.need.at_best);
  return at_best > (so_far.looks >= kFewestToPredict ? 1 : kLargestStep) * 2.0 * so_far.most_spp ||
         so_far.spp >= so_far.most_spp;
}

bool is_beyond_time(const judge::Look& look, const LooksSoFar& so_far) {
  const auto after = [&](double times) {
    return so_far.seconds + seconds_for(so_far.pace, so_far.spp * (times - 1));
  };
  return after(2) > so_far.budget_seconds ||
         (so_far.looks >= kFewestToPredict && after(look.need.at_best) > 2 * so_far.budget_seconds);
}

}  // namespace

double seconds_to_decide(const judge::Look& look, const LooksSoFar& so_far) {
  return seconds_for(so_far.pace, so_far.spp * (times_to_decide(look) - 1));
}

End end_by_budget(const judge::Look& look, const LooksSoFar& so_far) {
  return {"budget", noise_text(look, so_far)};
}

End end_after(const judge::Look& look, const LooksSoFar& so_far) {
  if (!look.is_open) return {"decided", ""};
  if (look.need.is_edge) return {"edge", "it lies on the edge of this gate"};
  if (so_far.looks >= kFewestToPredict && look.need.is_reference)
    return {"reference",
            "the noise of the reference: no number of samples decides it before the reference has more"};
  if (so_far.looks >= kMostLooks) return {"looks", fmt::format("{} looks have not decided it", so_far.looks)};
  if (so_far.budget_seconds > 0) return is_beyond_time(look, so_far) ? end_by_budget(look, so_far) : End{};
  if (is_beyond_samples(look, so_far))
    return {"looks",
            fmt::format("{}; a run gives {} by itself, and as many as it takes within --target-budget",
                        noise_text(look, so_far), so_far.most_spp)};
  return {};
}

results::LookRecord look_record(const judge::Look& look, results::Verdict verdict, int spp) {
  const auto finite = [](std::optional<double> number) {
    return number && std::isfinite(*number) ? number : std::nullopt;
  };
  return {
      spp, verdict, look.gate.gate, finite(look.gate.value), finite(look.gate.low), finite(look.gate.high)};
}

}  // namespace orbs::run
