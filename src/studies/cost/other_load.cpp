#include "studies/cost/other_load.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/format.h>

namespace orbs::studies {

bool is_disturbed(const CostRender& render) { return render.other_share.value_or(0) > kMostOtherShare; }

std::optional<CostRender> undisturbed_render(const std::function<std::optional<CostRender>()>& make,
                                             int most_repeats) {
  auto made = make();
  for (int repeats = 1; made && is_disturbed(*made) && repeats <= most_repeats; ++repeats) {
    made = make();
    if (made) made->repeats = repeats;
  }
  return made;
}

std::vector<const CostRender*> that_count(std::vector<const CostRender*> renders) {
  const auto disturbed = [](const CostRender* render) { return is_disturbed(*render); };
  if (!std::all_of(renders.begin(), renders.end(), disturbed)) std::erase_if(renders, disturbed);
  return renders;
}

OtherLoad other_load_of(const CostRecord& record) {
  OtherLoad load;
  std::map<std::tuple<std::size_t, std::size_t, Purpose, std::string>, std::vector<const CostRender*>>
      settings;
  for (const auto& render : record.renders) {
    ++load.renders;
    load.repeats += render.repeats;
    load.unknown += render.other_share ? 0 : 1;
    settings[{render.target, render.renderer, render.purpose, render.setting}].push_back(&render);
  }
  for (const auto& [setting, renders] : settings) {
    const auto kept = that_count(renders);
    load.left_out += static_cast<int>(renders.size() - kept.size());
    if (is_disturbed(*kept.front())) load.marked += static_cast<int>(kept.size());
  }
  return load;
}

std::string other_load_text(const OtherLoad& load) {
  if (load.unknown == load.renders)
    return "other work on the machine: not measured, so no render was left out\n";
  // One render in ten is what a scheduled job of the system may disturb; more is a machine that is in use.
  constexpr int kUsualShare = 10;
  auto text = fmt::format(
      "other work on the machine: of {} renders {} were left out because others took more than {:g} % of its "
      "processors; {} repeats\n",
      load.renders, load.left_out, 100 * kMostOtherShare, load.repeats);
  if (load.unknown > 0)
    text += fmt::format("of {} renders it is not known what others took: nothing was left out there\n",
                        load.unknown);
  if (load.marked > 0)
    text += fmt::format(
        "{} renders count although others took as much, since their settings have no others: their times are those "
        "of a machine in use, and are named below\n",
        load.marked);
  if ((load.left_out + load.marked) * kUsualShare > load.renders)
    text +=
        "the machine was in use: the same command with --resume and the folder makes what was disturbed once more\n";
  return text;
}

}  // namespace orbs::studies
