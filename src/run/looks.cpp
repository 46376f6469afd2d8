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
constexpr int kOfTheCase = 4;
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

int first_look_spp(const Plan& plan, const registry::Renderer& renderer, int spp) {
  const auto& sampling = renderer.sampling;
  if (plan.settings.fixed_samples || sampling.is_noise_free || sampling.has_fixed_samples) return 0;
  if (plan.place == RenderPlace::Elsewhere || !plan.images.empty()) return 0;
  if (!registry::uses_placeholder(renderer.command.words, "spp") || !takes_seed(renderer.command)) return 0;
  return std::max({kFewest, power_of_two_below(std::max(1, spp / kOfTheCase)),
                   2 * power_of_two_above(sampling.least_spp)});
}

int first_guess_spp(const PlannedJob& job) {
  const int below = power_of_two_below(job.spp);
  return job.spp < std::sqrt(2.0) * below ? below : 2 * below;
}

int samples_after(const PlannedJob& job, int looks) {
  return looks == 0 ? 0 : static_cast<int>(std::ldexp(job.first_spp, looks - 1));
}

PlannedLook next_look(const PlannedJob& job, int looks, int run_seed) {
  const int more = samples_after(job, looks + 1) - samples_after(job, looks);
  return {more / 2, {seed_of(run_seed, 2 * looks), seed_of(run_seed, 2 * looks + 1)}};
}

PlannedLook next_look(const Plan& plan, const PlannedJob& job, int looks) {
  const int run_seed = plan.settings.seed;
  auto look = next_look(job, looks, run_seed);
  if (plan.renderers[job.renderer].entry.command.sequence.words.empty()) return look;
  constexpr int kImages = 4;
  const int before = kImages * (run_seed - 1) + (looks == 0 ? 0 : 2);
  look.seeds = {before + 1, before + 2};
  return look;
}

double target_budget_seconds(const registry::RunSettings& settings) {
  constexpr double kUsual = 120;
  if (settings.target_budget_seconds > 0) return settings.target_budget_seconds;
  const double times =
      static_cast<double>(registry::QuarterSize) / static_cast<double>(settings.size_divisor);
  return kUsual * std::max(1.0, times * times);
}

double seconds_to_decide(const judge::Look& look, double seconds) {
  const double times = std::isfinite(look.need.samples) ? look.need.samples : look.need.at_best;
  return seconds * (std::max(2.0, times) - 1);
}

End end_by_budget(const judge::Look& look, double seconds) {
  const double times = std::isfinite(look.need.samples) ? look.need.samples : look.need.at_best;
  if (!std::isfinite(times))
    return {"budget", "its noise; the budget ended before it could be told how much"};
  return {"budget",
          fmt::format("its noise: about {} times the samples ({}) would decide it",
                      two_digits(std::max(2.0, times)), duration_text(seconds * std::max(2.0, times)))};
}

End end_after(const judge::Look& look, int looks, double seconds, double budget_seconds) {
  constexpr int kFewestToPredict = 3;
  if (!look.is_open) return {"decided", ""};
  if (look.need.is_edge) return {"edge", "it lies on the edge of this gate"};
  if (looks >= kFewestToPredict && look.need.is_reference)
    return {"reference",
            "the noise of the reference: no number of samples decides it before the reference has more"};
  if (looks >= kMostLooks) return {"looks", fmt::format("{} looks have not decided it", looks)};
  // The next look takes as long as all before. A prediction counts where even at best it is far beyond.
  const bool is_hopeless =
      looks >= kFewestToPredict && seconds * (look.need.at_best - 1) > 2 * (budget_seconds - seconds);
  if (2 * seconds > budget_seconds || is_hopeless) return end_by_budget(look, seconds);
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
