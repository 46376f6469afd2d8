#include "report/hints.h"

#include <algorithm>
#include <map>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::report {

namespace {

using results::TargetRecord;

// local_bias is the mean of a tile, less what noise may add to it: a misplaced scene moves it, noise does
// not.
bool may_be_noise(const TargetRecord& target) {
  return std::any_of(target.checks.begin(), target.checks.end(),
                     [](const auto& check) { return check.what == "local_bias" && check.passed; });
}

bool fails_by_far(const TargetRecord& target) {
  constexpr double kFar_db = 6;
  const bool is_explained = names_a_fault(target) || target.expectation == results::Expectation::Known;
  if (target.verdict != results::Verdict::Fail || may_be_noise(target) || is_explained) return false;
  return std::any_of(target.checks.begin(), target.checks.end(), [&](const auto& check) {
    const auto measure = std::find_if(target.measures.begin(), target.measures.end(),
                                      [&](const auto& one) { return one.name == check.what; });
    return measure != target.measures.end() && measure->unit == "dB" && check.min &&
           measure->value <= *check.min - kFar_db;
  });
}

// Compares the programs by their own names: "orbs-tracer" in the provenance, "orbs-tracer 0.1.0" as a
// version.
bool is_foreign(const TargetRecord& target, const results::RendererRecord& renderer) {
  const auto program = target.reference_provenance.find("program");
  return program != target.reference_provenance.end() && !renderer.version.starts_with(program->second);
}

}  // namespace

std::string probe_hints(const results::RunRecord& run) {
  std::string text;
  for (const auto& renderer : run.renderers) {
    std::vector<std::string> targets;
    for (const auto& target : run.targets)
      if (target.renderer == renderer.name && fails_by_far(target) && is_foreign(target, renderer) &&
          std::find(targets.begin(), targets.end(), target.target) == targets.end())
        targets.push_back(target.target);
    if (!targets.empty())
      text += fmt::format(
          "{0} is far off in {1}: 'orbs probe -r {0}' checks whether it places camera and objects as the "
          "scenes say\n",
          renderer.name, fmt::join(targets, ", "));
  }
  return text;
}

std::string explain_hint(const results::RunRecord& run) {
  const bool has_unknown = std::any_of(run.targets.begin(), run.targets.end(), [](const auto& target) {
    return target.diagnosis == results::kNoUsualFault && target.expectation != results::Expectation::Known;
  });
  return has_unknown
             ? "'orbs explain' renders these scenes with one typical mistake after the other, and names the "
               "one that makes the same image\n"
             : "";
}

// "2 at 1/2 and 3 at full size, as they are small".
std::string larger_sizes(const results::RunRecord& run) {
  std::map<std::string, int> counts;  // "1" before "1/2"
  for (const auto& scene : run.scenes)
    if (!scene.size.empty()) ++counts[scene.size];
  std::vector<std::string> parts;
  for (const auto& [size, count] : counts)
    parts.push_back(fmt::format("{} at {}", count, size == "1" ? "full size" : size));
  if (parts.empty()) return "";
  return fmt::format(" ({}: too small for less, or not to be divided)", fmt::join(parts, ", "));
}

std::string size_note(const results::RunRecord& run) {
  if (run.size == "1") return "";
  std::ptrdiff_t unmeasured = 0;
  for (const auto& target : run.targets)
    unmeasured += std::count_if(target.checks.begin(), target.checks.end(),
                                [](const auto& check) { return !check.measured; });
  const auto left_out =
      unmeasured == 0
          ? ""
          : fmt::format("Not measured: {}, smaller than such a pixel. ",
                        unmeasured == 1 ? "1 pixel check" : fmt::format("{} pixel checks", unmeasured));
  return fmt::format(
      "Measured at {} of the width and height{}: means, tiles and noise are judged as at full size. Edges and detail "
      "finer than a pixel of this size are averaged out and not judged. "
      "{}--size 1 judges everything.\n",
      run.size, larger_sizes(run), left_out);
}

}  // namespace orbs::report
