#include "studies/mutation_test.h"

#include "runner/judge_targets.h"
#include "runner/outcome.h"
#include "studies/mutants.h"

#include <algorithm>
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

bool is_difference(const GateTrial& trial) {
  return std::any_of(trial.one_case.differences.begin(), trial.one_case.differences.end(),
                     [&](const auto& difference) { return difference.name == trial.image; });
}

TargetRecord judged(const GateTrial& trial, const Image& image) {
  TargetRecord record;
  record.target = trial.image;
  adapters::Job expected;
  expected.width_px = trial.reference.image->width;
  expected.height_px = trial.reference.image->height;
  expected.may_be_negative = is_difference(trial) || !trial.one_case.negative_values.empty();
  const auto usable = runner::check_pixels(expected, image, "the image");
  if (const auto verdict = results::verdict_without_image(usable.kind)) {
    record.verdict = *verdict;
    record.reason = usable.reason;
    return record;
  }
  runner::judge_values(trial.one_case, image, trial.reference, {.measured = runner::Measured::ForTheVerdict},
                       record);
  return record;
}

// "Too noisy to tell" is no rejection.
bool is_rejected(const TargetRecord& record) {
  return results::worse(record.verdict, Verdict::Fail) == record.verdict;
}

MutantRecord tried(const GateTrial& trial, const std::string& fault, const Image& mutant) {
  const auto record = judged(trial, mutant);
  return {fault, "", is_rejected(record),
          fmt::format("{}: {}", results::verdict_name(record.verdict), record.reason)};
}

// Of the images of the same size the one that is most like this, and yet another: who tells these two apart
// tells all apart.
MutantRecord tried_with_another(const GateTrial& trial) {
  const auto own = image::select_rgb(*trial.reference.image, "").pixels;
  const Image* nearest = nullptr;
  std::string name;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [other_name, other] : trial.others) {
    if (other.width != trial.control.width || other.height != trial.control.height) continue;
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
  return tried(trial, fmt::format("the image of {}", name), *nearest);
}

void test_mutants(const GateTrial& trial, const metrics::Rectangle& leak, double mean, GateRecord& gate) {
  gate.mutants.push_back(tried_with_another(trial));
  auto faults = faults_of(*trial.reference.image);
  faults.push_back({"a leak of the mean light into 16 x 16 px",
                    [&](const Image& image) { return with_leak(image, leak, mean); }});
  for (const auto& fault : faults) {
    // What leaves the right image as it is cannot be a fault, by whatever name it goes.
    if (image::has_same_colours(fault.apply(*trial.reference.image), *trial.reference.image)) {
      gate.mutants.push_back({fault.name, "it leaves the reference as it is, to the bit", false, ""});
    } else {
      gate.mutants.push_back(tried(trial, fault.name, fault.apply(trial.control)));
    }
  }
  if (!trial.no_dark.empty()) gate.mutants.push_back({"a missing light", trial.no_dark, false, ""});
  for (const auto& dark : trial.dark) gate.mutants.push_back(tried(trial, dark.name, dark.image));
}

// Within 10 %, between `least` and `most`, by halving the ratio; takes for granted that larger faults are
// easier to see.
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
SmallestFault smallest_fault(const GateTrial& trial, double least, double most, Mutant mutant) {
  const auto verdict = [&](double size) { return judged(trial, mutant(size)); };
  SmallestFault found;
  found.rejected = smallest(least, most, [&](double size) { return is_rejected(verdict(size)); });
  found.seen = smallest(least, found.rejected.value_or(most), [&](double size) {
    const auto record = verdict(size);
    return is_rejected(record) || !record.remarks.empty();
  });
  return found;
}

}  // namespace

GateRecord try_gate(const GateTrial& trial) {
  GateRecord gate;
  gate.case_name = trial.one_case.name;
  gate.target = trial.image;
  const auto control = judged(trial, trial.control);
  gate.accepts_control = control.verdict == Verdict::Pass;
  gate.control_reason = fmt::format("{}: {}{}{}", results::verdict_name(control.verdict), control.reason,
                                    control.remarks.empty() ? "" : "; ", fmt::join(control.remarks, "; "));
  const auto where = place_of_leak(*trial.reference.image, runner::mask_of(trial.one_case, trial.image));
  const double mean = mean_radiance(*trial.reference.image);
  test_mutants(trial, where, mean, gate);
  gate.global =
      smallest_fault(trial, 1e-4, 0.5, [&](double share) { return with_more_light(trial.control, share); });
  gate.local = smallest_fault(trial, 1e-2, 100,
                              [&](double share) { return with_leak(trial.control, where, share * mean); });
  gate.local_where = {where.x0, where.y0, where.x1, where.y1};
  return gate;
}

}  // namespace orbs::studies
