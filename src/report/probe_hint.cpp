#include "report/probe_hint.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::report {

namespace {

using results::PictureRecord;

bool fails_by_far(const PictureRecord& picture) {
  constexpr double kFar_db = 6;
  if (picture.verdict != results::Verdict::Fail) return false;
  return std::any_of(picture.checks.begin(), picture.checks.end(), [&](const auto& check) {
    const auto measure = std::find_if(picture.measures.begin(), picture.measures.end(),
                                      [&](const auto& one) { return one.name == check.what; });
    return measure != picture.measures.end() && measure->unit == "dB" && check.min &&
           measure->value <= *check.min - kFar_db;
  });
}

// By what the programs call themselves: "orbs-tracer" in the passport, "orbs-tracer 0.1.0" as a version.
bool is_foreign(const PictureRecord& picture, const results::RendererRecord& renderer) {
  const auto program = picture.reference_passport.find("program");
  return program != picture.reference_passport.end() && !renderer.version.starts_with(program->second);
}

}  // namespace

std::string probe_hints(const results::RunRecord& run) {
  std::string text;
  for (const auto& renderer : run.renderers) {
    std::vector<std::string> pictures;
    for (const auto& picture : run.pictures)
      if (picture.renderer == renderer.name && fails_by_far(picture) && is_foreign(picture, renderer) &&
          std::find(pictures.begin(), pictures.end(), picture.picture) == pictures.end())
        pictures.push_back(picture.picture);
    if (!pictures.empty())
      text += fmt::format(
          "{0} is far off in {1}: 'orbs probe -r {0}' tells whether it has camera and objects where the "
          "scenes "
          "say\n",
          renderer.name, fmt::join(pictures, ", "));
  }
  return text;
}

}  // namespace orbs::report
