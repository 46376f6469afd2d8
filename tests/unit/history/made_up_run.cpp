#include "unit/history/made_up_run.h"

#include "base/random.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace orbs::made_up {

namespace {

using namespace results;

// Standard deviations that an interval of the record reaches, see mean_ratio.h and noise_numbers.h.
constexpr double kReachOfLight = 4.068;
constexpr double kReachOfBias = 3.802;

class Noise {
 public:
  explicit Noise(std::uint64_t seed) : seed_(seed) {}
  double uniform() { return unit_random(mix(seed_, count_++)); }
  // Box and Muller.
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }

 private:
  std::uint64_t seed_;
  std::uint64_t count_ = 0;
};

Measure measure(const std::string& name, double value, double reach) {
  Measure made{name, value, "1", "", true};
  made.low = value - reach;
  made.high = value + reach;
  return made;
}

void add_measures(int target, double light, double variance, Noise& noise, TargetRecord& record) {
  Noise fixed(static_cast<std::uint64_t>(target) + 1000);  // what is the same in every run
  const double error = 0.0005 + 0.0035 * fixed.uniform();
  for (const char channel : {'r', 'g', 'b'}) {
    const double bias = 0.003 * fixed.normal();
    record.measures.push_back(measure(fmt::format("mean_ratio_{}", channel),
                                      (1 + bias) * light - 1 + error * noise.normal(),
                                      kReachOfLight * error));
  }
  const double squared = 1e-4 * (0.5 + fixed.uniform()) * variance + (light - 1) * (light - 1) / 4;
  const double of_squared = 0.03 * squared;
  const double mse = squared + of_squared * noise.normal();
  record.measures.push_back({"mse", mse, "radiance^2", "", true});
  record.measures.push_back(measure("bias_squared", mse - squared, kReachOfBias * of_squared));
  record.measures.push_back({"psnr_srgb8", -10 * std::log10(mse), "dB", ""});
}

double seconds(int target, double factor, double machine, Noise& noise) {
  Noise fixed(static_cast<std::uint64_t>(target) + 2000);
  const double usual = 0.5 + 20 * fixed.uniform();
  const bool is_disturbed = noise.uniform() < 0.01;
  return usual * factor * machine * std::exp(0.02 * noise.normal()) * (is_disturbed ? 1.1 : 1);
}

}  // namespace

RunRecord run(std::uint64_t seed, const Settings& settings) {
  Noise noise(seed);
  RunRecord run;
  run.suite = "made-up";
  run.name = fmt::format("run-{}", seed);
  run.folder = "/runs/" + run.name;
  run.started = fmt::format("2026-01-{:02}T00:00:00", 1 + seed % 28);
  run.host.cpu = "cpu";
  run.host.cores = 2;
  const double machine = 1 + 0.04 * (noise.uniform() - 0.5);
  for (int r = 0; r < settings.renderers; ++r) {
    RendererRecord renderer;
    renderer.name = fmt::format("r{}", r);
    renderer.version = "1.0";
    run.renderers.push_back(renderer);
    for (int t = 0; t < settings.targets; ++t) {
      JobRecord job;
      job.identity = {fmt::format("{}-{}", r, t), run.suite, fmt::format("s{}", t), renderer.name, 64,
                      static_cast<int>(seed)};
      job.cost.started = run.started;
      job.cost.host = run.host;
      job.cost.cpu_seconds = seconds(t + 1000 * r, r == 0 ? settings.time : 1, machine, noise);
      job.cost.wall_seconds = job.cost.cpu_seconds / 2;
      job.end.outcome = JobOutcome::Image;
      TargetRecord target;
      target.requirement = fmt::format("M{}", 1 + t % 8);
      target.case_name = fmt::format("case-{}", t % 8);
      target.target = job.identity.scene;
      target.renderer = renderer.name;
      target.jobs = {job.identity.id};
      target.declared = true;
      target.verdict = Verdict::Pass;
      add_measures(t + 1000 * r, r == 0 ? settings.light : 1, r == 0 ? settings.noise : 1, noise, target);
      run.jobs.push_back(std::move(job));
      run.targets.push_back(std::move(target));
    }
  }
  return run;
}

}  // namespace orbs::made_up
