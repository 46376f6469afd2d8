#include "studies/qualify/sensitivity.h"

#include "adapters/job.h"
#include "base/error.h"
#include "base/files.h"
#include "base/nth.h"
#include "base/parallel.h"
#include "faults/fault.h"
#include "judge/judge.h"
#include "judge/noise.h"
#include "metrics/seeds.h"
#include "run/render.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

using image::Image;

constexpr std::array kAllKnowledge{NoiseKnowledge::Variances, NoiseKnowledge::TwoSeeds,
                                   NoiseKnowledge::OneSeed, NoiseKnowledge::NoiseFree};

struct Subject {
  const registry::Case* one_case = nullptr;
  std::string target;
  judge::Reference reference;
};

// Two renders of one scene with different seeds, each of half the samples: any two of those that there are.
struct Render {
  int seed = 0;
  Image image;
};
struct Renders {
  const Render& first;
  const Render& second;
};

// The mean of two images, and the variance of that mean by the images' own.
Image mean_of_both(const Renders& renders) {
  Image mean = renders.first.image;
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
    const bool is_variance = image::is_variance(mean.channels[i % mean.channel_count()]);
    mean.pixels[i] = (mean.pixels[i] + renders.second.image.pixels[i]) / (is_variance ? 4.0F : 2.0F);
  }
  return mean;
}

// Sum of the variances of R, G and B.
double total_variance(const Image& image) {
  double sum = 0;
  for (const std::string colour : {"R", "G", "B"}) {
    const int variance = image::channel_index(image, "variance." + colour);
    if (variance < 0) throw InputError("the images have no variances");
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        sum += static_cast<double>(image.at(x, y, static_cast<std::size_t>(variance)));
  }
  return sum;
}

// The reference as an image without noise would meet it: its own values are taken to be the truth, and noise
// is put upon them at a tenth of the power of a whole render's, or at ten times the power of its own, which
// must not count beside it, as the image that is judged has it, too. Half the difference of two renders is
// that noise: its expectation is zero in every scene, as each render has the same, and its variance is a
// quarter of the sum of theirs. It is held between plus and minus the truth, so that light stays positive and
// the expectation zero. (The difference to the reference would not do: it holds the reference's own
// noise, which is also in the image that is judged.)
Image noisy_reference(const Image& reference, const Renders& renders) {
  const Image& first = renders.first.image;
  const Image& second = renders.second.image;
  const double of_half = 0.25 * (total_variance(first) + total_variance(second));
  const double power = of_half > 0 ? std::max(0.1, 10 * total_variance(reference) / of_half) : 0;
  const double share = std::sqrt(power);
  Image noisy = reference;
  for (const std::string colour : {"R", "G", "B"}) {
    const auto value = static_cast<std::size_t>(image::channel_index(reference, colour));
    const auto render_value = static_cast<std::size_t>(image::channel_index(first, colour));
    const auto to = static_cast<std::size_t>(image::channel_index(reference, "variance." + colour));
    const auto from = static_cast<std::size_t>(image::channel_index(first, "variance." + colour));
    for (int y = 0; y < reference.height; ++y)
      for (int x = 0; x < reference.width; ++x) {
        const double truth = static_cast<double>(reference.at(x, y, value));
        const double half = 0.5 * (static_cast<double>(first.at(x, y, render_value)) -
                                   static_cast<double>(second.at(x, y, render_value)));
        const double sum =
            static_cast<double>(first.at(x, y, from)) + static_cast<double>(second.at(x, y, from));
        noisy.at(x, y, value) =
            static_cast<float>(truth + std::clamp(share * half, -std::abs(truth), std::abs(truth)));
        noisy.at(x, y, to) = static_cast<float>(power * 0.25 * sum);
      }
  }
  return noisy;
}

struct Pair {
  Image control;
  judge::Reference reference;
  metrics::ResultNoise noise = metrics::ResultNoise::AsTheImageSays;
};

Pair pair_for(const Subject& subject, const Renders& renders, NoiseKnowledge knowledge) {
  switch (knowledge) {
    case NoiseKnowledge::Variances:
      return {mean_of_both(renders), subject.reference};
    case NoiseKnowledge::TwoSeeds:
      return {metrics::mean_and_variance_of({renders.first.image, renders.second.image}), subject.reference};
    case NoiseKnowledge::OneSeed:
      return {judge::without_variances(mean_of_both(renders)), subject.reference};
    case NoiseKnowledge::NoiseFree:
      break;
  }
  auto reference = subject.reference;
  reference.image = noisy_reference(*subject.reference.image, renders);
  return {judge::without_variances(*subject.reference.image), std::move(reference),
          metrics::ResultNoise::NoiseFree};
}

Answer answer_of(const results::TargetRecord& record) {
  if (record.verdict == results::Verdict::Inconclusive) return Answer::Inconclusive;
  if (!results::passes(record.verdict)) return Answer::Rejected;
  if (record.verdict == results::Verdict::PassWithRemarks) return Answer::Remarked;
  return record.hidden.empty() ? Answer::Silent : Answer::Hidden;
}

JudgedImage judged(const Subject& subject, const Pair& pair, const Image& image) {
  results::TargetRecord record;
  record.target = subject.target;
  judge::judge_image(*subject.one_case, image, pair.reference,
                     {.measured = judge::Measured::ForTheVerdict, .result_noise = pair.noise}, record);
  JudgedImage out;
  out.target = subject.target;
  out.answer = answer_of(record);
  out.reason = record.reason;
  for (const auto& remark : record.remarks) out.reason += "; " + remark;
  if (!record.hidden.empty()) out.reason += "; " + record.hidden;
  return out;
}

std::vector<JudgedImage> judge_renders(const Subject& subject,
                                       const Renders& renders,
                                       bool with_mutants,
                                       const run::Plan& plan,
                                       const StudyContext& context) {
  struct Task {
    std::size_t pair;
    const faults::Row* fault;  // nullptr: the control image
  };
  std::vector<Pair> pairs;
  std::vector<NoiseKnowledge> of_pair;
  std::vector<Task> tasks;
  const auto& reference = *subject.reference.image;
  std::vector<faults::Row> rows;
  if (with_mutants) rows = faults::rows_of(faults::Use::Sensitivity, reference);
  // A change that leaves the reference as it is is no fault of this scene.
  std::erase_if(rows, [&](const faults::Row& row) {
    return image::has_same_colours(faults::applied(row, reference), reference);
  });
  const bool has_noise = image::channel_index(reference, "variance.R") >= 0 &&
                         image::channel_index(renders.first.image, "variance.R") >= 0;
  for (const auto knowledge : kAllKnowledge) {
    // A computed reference is exact as it is: no noise is to be drawn for an image without any.
    if (knowledge == NoiseKnowledge::NoiseFree && !has_noise) continue;
    pairs.push_back(pair_for(subject, renders, knowledge));
    of_pair.push_back(knowledge);
    tasks.push_back({pairs.size() - 1, nullptr});
    for (const auto& row : rows) tasks.push_back({pairs.size() - 1, &row});
  }
  std::vector<JudgedImage> images(tasks.size());
  for_each_index(static_cast<int>(tasks.size()), plan.threads, [&](int index) {
    if (is_stopped(context)) return;
    const auto& [at, fault] = nth(tasks, index);
    const Pair& pair = pairs[at];
    auto& image = nth(images, index);
    image = judged(subject, pair, fault != nullptr ? faults::applied(*fault, pair.control) : pair.control);
    image.knowledge = of_pair[at];
    image.fault = fault != nullptr ? fault->name : "";
    image.seed = renders.first.seed;
    image.second = renders.second.seed;
  });
  return images;
}

Subject subject_of(const run::Plan& plan, const run::PlannedScene& scene) {
  for (const auto& one_case : plan.cases) {
    const auto names = registry::target_names(one_case);
    if (std::find(names.begin(), names.end(), scene.name) == names.end()) continue;
    Subject subject{&one_case, scene.name,
                    judge::load_reference(one_case, scene.name, plan.suite.references, plan.reference_hashes,
                                          {}, registry::reduced_size(plan.settings))};
    return subject;
  }
  return {};  // part of a difference alone
}

}  // namespace

const char* name_of(NoiseKnowledge knowledge) {
  constexpr std::array kNames{"variances", "two seeds", "one seed", "noise-free"};
  return kNames.at(static_cast<std::size_t>(knowledge));
}

const char* name_of(Answer answer) {
  constexpr std::array kNames{"rejected", "inconclusive", "remark", "hidden", "silent"};
  return kNames.at(static_cast<std::size_t>(answer));
}

std::vector<JudgedImage> measure_sensitivity(const run::Plan& plan,
                                             const SensitivitySettings& settings,
                                             const StudyContext& context) {
  constexpr int kFirstSeed = 100000;  // far from those of runs and of references
  const ScratchFolder scratch("orbs-sensitivity");
  std::vector<JudgedImage> images;
  for (const auto& scene : plan.scenes) {
    const Subject subject = subject_of(plan, scene);
    if (subject.one_case == nullptr) continue;
    if (std::holds_alternative<scene::IrradianceCache>(scene.scene->integrator)) {
      context.say(fmt::format("{}: left out, a cache interpolates: its error is no noise", scene.name));
      continue;
    }
    if (!subject.reference.image) {
      context.say(fmt::format("{}: left out, {}", scene.name, subject.reference.problem));
      continue;
    }
    const auto prepared =
        run::prepare_render(plan.renderers.front(), plan, *scene.scene, scratch.path() / scene.name);
    const int spp = adapters::scaled_spp(scene.spp, 0.5, settings.spp_scale);
    const bool may_be_negative = !subject.one_case->negative_values.empty();
    std::vector<Render> renders;
    for (int i = 0; i < settings.renders; ++i) {
      auto render = run::render_once(
          prepared,
          {.spp = spp, .seed = kFirstSeed + i, .threads = plan.threads, .may_be_negative = may_be_negative},
          context.stop);
      if (!render) return images;
      renders.push_back({kFirstSeed + i, std::move(render->image)});
    }
    if (image::has_same_colours(renders[0].image, renders[1].image)) {
      context.say(fmt::format("{}: left out, its renders are equal to the bit: it has no noise", scene.name));
      continue;
    }
    for (std::size_t i = 0; i < renders.size(); ++i)
      for (std::size_t k = i + 1; k < renders.size(); ++k) {
        const bool with_mutants = settings.faults && i == 0 && k == 1;
        const auto found = judge_renders(subject, {renders[i], renders[k]}, with_mutants, plan, context);
        if (is_stopped(context)) return images;
        images.insert(images.end(), found.begin(), found.end());
      }
    context.say(fmt::format("{}: judged", scene.name));
  }
  return images;
}

}  // namespace orbs::studies
