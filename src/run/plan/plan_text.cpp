#include "run/plan/plan_text.h"

#include "base/text.h"
#include "registry/image_size.h"
#include "run/looks.h"
#include "run/prepare.h"

#include <fmt/format.h>

namespace orbs::run {

std::string plan_text(const Plan& plan) {
  std::string text = fmt::format(
      "{} renders for {} images, {} at a time with {} threads each{}\n", plan.jobs.size(),
      plan.targets.size(), plan.settings.jobs, plan.threads,
      plan.settings.size_divisor == 1 ? "" : ", at " + registry::size_text(plan.settings.size_divisor));
  for (const auto& job : plan.jobs) {
    const auto& scene = plan.scenes[job.scene];
    const auto& renderer = plan.renderers[job.renderer];
    text += fmt::format("{}  {}  {}\n", job.id, renderer.entry.name, scene.name);
    const auto prepared = scene_for(plan, job);
    if (const auto* reason = std::get_if<std::string>(&prepared)) {
      text += fmt::format("    unsupported: {}\n", *reason);
      continue;
    }
    if (!job.native_scene.empty()) text += fmt::format("    hand-written: {}\n", job.native_scene.string());
    auto first = job;
    if (job.first_spp > 0) first.look = next_look(plan, job, 0);
    for (const auto& replica : replicas_of(plan, first, "OUTPUT"))
      text += fmt::format("    {}\n", shell_text(replica.argv));
    if (job.first_spp > 0)
      text += fmt::format("    then as many samples again with other seeds, until its targets are decided\n");
  }
  for (const auto& target : plan.targets)
    if (!target.unsupported.empty())
      text += fmt::format("unsupported: {} {}: {}\n", plan.renderers[target.renderer].entry.name,
                          target.target, target.unsupported);
  for (const auto& left : plan.left_out)
    text += fmt::format("left out: {}: {}\n", left.renderer, left.reason);
  return text;
}

}  // namespace orbs::run
