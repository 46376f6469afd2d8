#include "studies/qualify/mutation_test.h"

#include "faults/fault.h"
#include "judge/judge.h"
#include "metrics/mask.h"
#include "metrics/merged_renders.h"
#include "metrics/seeds.h"
#include "run/outcome.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::studies {

namespace {

using image::Image;
using results::GateRecord;
using results::MutantRecord;
using results::SmallestFault;
using results::TargetRecord;
using results::Verdict;

// What mutants are made from. Where pixel checks alone judge, the control image stands for the right one.
const Image& right_image(const MutationSubject& subject) {
  return subject.reference.image ? *subject.reference.image : subject.control;
}

// Whether both have the same colours where they are judged: everywhere, or where there are checks.
bool is_judged_alike(const MutationSubject& subject, const Image& a, const Image& b) {
  if (subject.reference.image) return image::has_same_colours(a, b);
  const auto first = image::select_rgb(a, "");
  const auto second = image::select_rgb(b, "");
  const auto is_alike = [&](const registry::PixelCheck& check) {
    for (int y = check.region.y0; y < check.region.y1; ++y)
      for (int x = check.region.x0; x < check.region.x1; ++x)
        for (std::size_t c = 0; c < 3; ++c)
          if (first.at(x, y, c) != second.at(x, y, c)) return false;
    return true;
  };
  const auto& checks = subject.one_case.pixel_checks;
  return std::all_of(checks.begin(), checks.end(), [&](const auto& check) {
    return check.target != subject.target || !check.not_measured.empty() || is_alike(check);
  });
}

TargetRecord judged(const MutationSubject& subject,
                    const Image& image,
                    const judge::Reference& reference,
                    const std::array<Image, 2>* halves = nullptr) {
  // The paths of the suite's own reference alone are known.
  auto one_case = subject.one_case;
  if (&reference != &subject.reference) one_case.path_shares.clear();
  TargetRecord record;
  record.target = subject.target;
  adapters::Job expected;
  expected.width_px = subject.control.width;
  expected.height_px = subject.control.height;
  expected.may_be_negative =
      judge::is_difference(subject.one_case, subject.target) || !subject.one_case.negative_values.empty();
  const auto usable = run::check_pixels(expected, image, "the image");
  if (const auto verdict = results::verdict_without_image(usable.kind)) {
    record.verdict = *verdict;
    record.reason = usable.reason;
    return record;
  }
  judge::JudgeSettings settings{.measured = judge::Measured::ForTheVerdict};
  settings.looks.halves = halves;
  judge::judge_image(one_case, image, reference, settings, record);
  return record;
}

TargetRecord judged(const MutationSubject& subject, const Image& image) {
  return judged(subject, image, subject.reference);
}

// Inconclusive, "too noisy to tell", is no rejection.
bool is_rejected(const TargetRecord& record) {
  return results::worse(record.verdict, Verdict::Fail) == record.verdict;
}

MutantRecord tried(const MutationSubject& subject, const std::string& fault, const Image& mutant) {
  const auto record = judged(subject, mutant);
  return {fault, "", is_rejected(record),
          fmt::format("{}: {}", results::verdict_name(record.verdict), record.reason)};
}

// The mean of the right renders, and what the fault changes in each of two added to it: they share no noise
// but that of the change.
TargetRecord judged_by_samples(const MutationSubject& subject, const FaultBySamples& by_samples) {
  const auto& right = *by_samples.right;
  const Image mean = metrics::mean_of({right[0], right[1]});
  std::array<Image, 2> changed{mean, mean};
  for (std::size_t half = 0; half < 2; ++half) {
    const auto faulty = image::select_rgb(by_samples.faulty.at(half), "");
    const auto same = image::select_rgb(right.at(half), "");
    auto& pixels = changed.at(half).pixels;
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] += faulty.pixels[i] - same.pixels[i];
  }
  if (image::has_same_colours(changed[0], changed[1])) return judged(subject, changed[0], {"", mean, ""});
  metrics::MergedRenders merged;
  metrics::add_renders(merged, changed, 1);
  return judged(subject, merged.mean, {"", mean, ""}, &merged.halves);
}

// What the gates accept when all noise but that of the change is away is too little to be a fault of this
// scene.
MutantRecord tried_render(const MutationSubject& subject, const RenderedMutant& mutant) {
  if (const auto& by_samples = mutant.by_samples) {
    const auto& [faulty, right] = *by_samples;
    if (image::has_same_colours(faulty[0], (*right)[0]) && image::has_same_colours(faulty[1], (*right)[1]))
      return {mutant.name, "it leaves the image as it is, to the bit", false, ""};
    const auto alone = judged_by_samples(subject, *by_samples);
    if (results::passes(alone.verdict))
      return {mutant.name,
              fmt::format("with the same samples it is accepted as the right image: {}", alone.reason), false,
              ""};
    auto record = tried(subject, mutant.name, mutant.image);
    if (!record.rejected) record.reason += fmt::format("; with the same samples: {}", alone.reason);
    return record;
  }
  return tried(subject, mutant.name, mutant.image);
}

// The most similar other reference of the same size: a gate that rejects it rejects all others.
MutantRecord tried_with_another(const MutationSubject& subject) {
  const auto own = image::select_rgb(right_image(subject), "").pixels;
  const Image* nearest = nullptr;
  std::string name;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [other_name, other] : subject.others) {
    if (other.width != subject.control.width || other.height != subject.control.height) continue;
    const auto pixels = image::select_rgb(other, "").pixels;
    double sum = 0;
    for (std::size_t i = 0; i < own.size(); ++i)
      sum += std::fabs(static_cast<double>(own[i]) - static_cast<double>(pixels[i]));
    if (sum == 0 || sum >= least) continue;  // 0: the same image, so no fault
    least = sum;
    name = other_name;
    nearest = &other;
  }
  if (nearest == nullptr) return {"another image", "no other reference has its size", false, ""};
  return tried(subject, fmt::format("the image of {}", name), *nearest);
}

void test_mutants(const MutationSubject& subject, const std::vector<faults::Row>& rows, GateRecord& gate) {
  gate.mutants.push_back(tried_with_another(subject));
  const Image& right = right_image(subject);
  for (const auto& row : rows) {
    // An equivalent mutant: a change that leaves the reference unchanged is no fault of this target.
    if (is_judged_alike(subject, faults::applied(row, right), right)) {
      gate.mutants.push_back({row.name,
                              subject.reference.image ? "it leaves the reference as it is, to the bit"
                                                      : "it leaves what is checked as it is, to the bit",
                              false, ""});
    } else {
      gate.mutants.push_back(tried(subject, row.name, faults::applied(row, subject.control)));
    }
  }
  if (!subject.why_no_light_can_miss.empty())
    gate.mutants.push_back({"a missing light", subject.why_no_light_can_miss, false, ""});
  for (const auto& mutant : subject.rendered_mutants) gate.mutants.push_back(tried_render(subject, mutant));
}

// The smallest size between `least` and `most` for which `holds`, within 10 %, by bisection of the ratio;
// assumes that larger faults are easier to detect.
template <typename Predicate>
std::optional<double> smallest(double least, double most, Predicate holds) {
  constexpr double kPrecision = 1.1;
  if (!holds(most)) return std::nullopt;
  if (holds(least)) return least;
  while (most / least > kPrecision) {
    const double middle = std::sqrt(least * most);
    (holds(middle) ? most : least) = middle;
  }
  return most;
}

template <typename Mutant>
SmallestFault smallest_fault(const MutationSubject& subject, double least, double most, Mutant mutant) {
  const auto verdict = [&](double size) { return judged(subject, mutant(size)); };
  SmallestFault found;
  found.rejected = smallest(least, most, [&](double size) { return is_rejected(verdict(size)); });
  found.seen = smallest(least, found.rejected.value_or(most), [&](double size) {
    const auto record = verdict(size);
    return is_rejected(record) || !record.remarks.empty();
  });
  return found;
}

}  // namespace

GateRecord mutation_test(const MutationSubject& subject) {
  GateRecord gate;
  gate.case_name = subject.one_case.name;
  gate.target = subject.target;
  const auto control = judged(subject, subject.control);
  gate.accepts_control = results::passes(control.verdict);
  gate.control_reason = fmt::format("{}: {}{}{}", results::verdict_name(control.verdict), control.reason,
                                    control.remarks.empty() ? "" : "; ", fmt::join(control.remarks, "; "));
  const Image& reference = right_image(subject);
  const auto mask = judge::mask_of(subject.one_case, subject.target);
  const auto included = metrics::included_pixels(mask, reference.width, reference.height);
  test_mutants(subject, faults::rows_of(faults::Use::Mutation, reference, included), gate);
  gate.global = smallest_fault(
      subject, 1e-4, 0.5, [&](double share) { return faults::Factor{1 + share}.apply(subject.control); });
  const auto leak = faults::leak_of_mean_light(reference, included);
  gate.local = smallest_fault(subject, 1e-2, 100, [&](double share) {
    return faults::Leak{leak.where, share * leak.radiance}.apply(subject.control);
  });
  const auto& where = leak.where;
  gate.local_where = {where.x0, where.y0, where.x1, where.y1};
  return gate;
}

}  // namespace orbs::studies
