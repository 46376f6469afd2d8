#include "studies/cost/other_load.h"

#include <fmt/format.h>

namespace orbs::studies {

bool is_disturbed(const CostRender& render) { return render.other_share.value_or(0) > kMostOtherShare; }

std::optional<CostRender> undisturbed_render(const std::function<std::optional<CostRender>()>& make) {
  auto made = make();
  for (int repeats = 1; made && is_disturbed(*made) && repeats <= kMostRepeats; ++repeats) {
    made = make();
    if (made) made->repeats = repeats;
  }
  return made;
}

OtherLoad other_load_of(const CostRecord& record) {
  OtherLoad load;
  for (const auto& render : record.renders) {
    ++load.renders;
    load.repeats += render.repeats;
    load.left_out += is_disturbed(render) ? 1 : 0;
    load.unknown += render.other_share ? 0 : 1;
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
  if (load.left_out * kUsualShare > load.renders)
    text +=
        "the machine was in use: the same command with --resume and the folder makes what was left out once more\n";
  return text;
}

}  // namespace orbs::studies
