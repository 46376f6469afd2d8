#include "results/effect_costs.h"

#include "json/document.h"
#include "json/object_reader.h"

namespace orbs::results {

namespace {

EffectCostRecord read_effect_cost(json::ObjectReader& in) {
  return {in.text("name"), in.object("time_ratio").number("median"), in.number("error_ratio"),
          in.text("change")};
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

}  // namespace orbs::results
