#include "registry/gates.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

Gate load_gate(json::ObjectReader in, std::set<std::string>& metrics) {
  Gate gate;
  gate.metric = in.text("metric");
  gate.place = in.place("metric");
  if (!metrics.insert(gate.metric).second)
    in.fail("metric",
            fmt::format("'{}' has an earlier gate in this case; give min and max in one", gate.metric));
  if (in.has("min")) gate.min = in.number("min");
  if (in.has("max")) gate.max = in.number("max");
  if (!gate.min && !gate.max) in.fail("", "a gate needs 'min' or 'max', or it lets everything pass");
  if (gate.min && gate.max && *gate.min > *gate.max)
    in.fail("max", fmt::format("must not be below 'min', which is {}", *gate.min));
  gate.reason = in.text("reason");
  if (gate.reason.empty()) in.fail("reason", "must say why this case has this gate");
  in.finish();
  return gate;
}

}  // namespace

std::vector<Gate> default_gates() {
  constexpr double kPsnr_db = 35;
  constexpr double kMeanRatio = 0.007;
  constexpr double kTileRatio = 0.1;
  constexpr double kEdgeBlur = 0.2;
  // 0.6 of the errors that are promised to be refused, 5 % and 2 %: noise may hide 0.4 of them.
  constexpr double kSmallWindow = 0.03;
  constexpr double kLargeWindow = 0.012;
  constexpr double kLine = 0.1;
  return {{"psnr_srgb8", kPsnr_db, {}},
          {"mean_ratio_r", -kMeanRatio, kMeanRatio},
          {"mean_ratio_g", -kMeanRatio, kMeanRatio},
          {"mean_ratio_b", -kMeanRatio, kMeanRatio},
          {"local_bias", {}, kTileRatio},
          {"edge_blur", -kEdgeBlur, kEdgeBlur},
          {"window_error_8px", {}, kSmallWindow},
          {"window_error_16px", {}, kSmallWindow},
          {"window_error_64px", {}, kLargeWindow},
          {"line_error", {}, kLine},
          {"pattern_error", {}, 1}};
}

std::vector<Gate> load_gates(json::ObjectReader& in) {
  auto gates = default_gates();
  std::set<std::string> metrics;
  for (auto& entry : in.objects_or_none("gates")) {
    auto own = load_gate(std::move(entry), metrics);
    const auto same =
        std::find_if(gates.begin(), gates.end(), [&](const Gate& gate) { return gate.metric == own.metric; });
    if (same == gates.end())
      gates.push_back(std::move(own));
    else
      *same = std::move(own);
  }
  return gates;
}

const Gate* find_gate(const std::vector<Gate>& gates, const std::string& metric) {
  const auto found =
      std::find_if(gates.begin(), gates.end(), [&](const Gate& gate) { return gate.metric == metric; });
  return found == gates.end() ? nullptr : &*found;
}

}  // namespace orbs::registry
