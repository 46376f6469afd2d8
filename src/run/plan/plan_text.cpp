#include "run/plan/plan_text.h"

#include "base/text.h"
#include "registry/image_size.h"
#include "run/looks.h"
#include "run/prepare.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::run {

namespace {

// "undeclared: cycles: B1, B4; 'orbs doctor -r cycles' says why".
std::string undeclared_text(const Plan& plan) {
  std::string text;
  for (std::size_t renderer = 0; renderer < plan.renderers.size(); ++renderer) {
    std::vector<std::string> requirements;
    for (const auto& target : plan.targets) {
      const auto& requirement = plan.cases[target.one_case].requirement;
      if (target.renderer == renderer && !target.declared &&
          std::find(requirements.begin(), requirements.end(), requirement) == requirements.end())
        requirements.push_back(requirement);
    }
    const auto& name = plan.renderers[renderer].entry.name;
    if (!requirements.empty())
      text += fmt::format("undeclared: {}: {}; 'orbs doctor -r {}' says what is known of it\n", name,
                          fmt::join(requirements, ", "), name);
  }
  return text;
}

}  // namespace

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
    if (job.first_spp > 0) first.look = first_look(plan, job);
    for (const auto& replica : replicas_of(plan, first, "OUTPUT"))
      text += fmt::format("    {}\n", shell_text(replica.argv));
    if (job.first_spp > 0)
      text += fmt::format("    then more samples with other seeds, until its targets are decided\n");
  }
  for (const auto& target : plan.targets)
    if (!target.unsupported.empty())
      text += fmt::format("unsupported: {} {}: {}\n", plan.renderers[target.renderer].entry.name,
                          target.target, target.unsupported);
  text += undeclared_text(plan);
  for (const auto& left : plan.left_out)
    text += fmt::format("left out: {}: {}\n", left.renderer, left.reason);
  return text;
}

}  // namespace orbs::run
