#include "results/effect_costs.h"

#include "json/document.h"
#include "json/field_reader.h"
#include "json/object_reader.h"

namespace orbs::results {

namespace {

EffectCostRecord read_effect_cost(json::ObjectReader& in) {
  auto ratio = in.object("time_ratio");
  EffectCostRecord cost{in.text("name"), ratio.number("median"), in.number("error_ratio"), in.text("change")};
  // Files from before there were intervals hold the smallest and the largest ratio of a round.
  if (in.has("time_interval")) {
    auto interval = in.object("time_interval");
    cost.time_low = interval.number("low");
    cost.time_high = interval.number("high");
  } else if (ratio.has("least")) {
    cost.time_low = ratio.number("least");
    cost.time_high = ratio.number("most");
  }
  if (in.has("mean_change")) {
    auto change = in.object("mean_change");
    cost.mean_change = change.number("value");
    cost.mean_change_error = change.number("standard_error");
  }
  cost.is_enough = in.boolean_or("is_enough", false);
  cost.is_equal = in.boolean_or("is_equal", false);
  cost.is_comparable = in.boolean_or("is_comparable", true);
  return cost;
}

// Of a file from before there was an A/A comparison.
EffectStudyRecord read_older_study(json::ObjectReader& in) {
  constexpr int kMost = 1 << 20;
  EffectStudyRecord study;
  study.started = in.text_or("started", "");
  study.orbs_version = in.text_or("orbs_version", "");
  study.rounds = in.integer_or("rounds", 0, 0, kMost);
  study.spp = in.integer_or("spp", 0, 0, kMost);
  study.size_px = in.integer_or("size_px", 0, 0, kMost);
  study.load = in.number_or("load", 0);
  if (in.has("host")) {
    auto host = in.object("host");
    study.cpu = host.text_or("cpu", "");
    study.cores = host.integer_or("cores", 0, 0, kMost);
  }
  return study;
}

}  // namespace

std::map<std::string, std::vector<EffectCostRecord>> read_effect_costs(const std::filesystem::path& file) {
  std::map<std::string, std::vector<EffectCostRecord>> effect_costs;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return effect_costs;
  const auto document = json::parse_file(file);
  json::ObjectReader in(document);
  in.one_of("format", {"orbs-effect-cost/1"});
  for (auto& scene : in.objects("scenes"))
    for (auto& alternative : scene.objects("alternatives"))
      effect_costs[scene.text("scene")].push_back(read_effect_cost(alternative));
  return effect_costs;
}

std::optional<EffectStudyRecord> read_effect_study(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return std::nullopt;
  const auto document = json::parse_file(file);
  json::ObjectReader in(document);
  in.one_of("format", {"orbs-effect-cost/1"});
  if (!in.has("study")) return read_older_study(in);
  EffectStudyRecord study;
  auto inner = in.object("study");
  json::FieldReader read(inner);
  fields(read, study);
  return study;
}

}  // namespace orbs::results
