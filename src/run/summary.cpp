#include "run/summary.h"

#include "registry/features.h"
#include "run/plan/choose_renderers.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::run {

namespace {

using results::Cell;
using results::TargetRecord;
using results::Verdict;

void add_to_cell(const TargetRecord& target, bool is_first, Cell& cell) {
  cell.declared = target.declared;
  cell.worst_verdict = results::worse(cell.worst_verdict.value_or(target.verdict), target.verdict);
  if (is_first || results::is_worse(target.verdict, target.expectation, cell.verdict, cell.expectation)) {
    cell.verdict = target.verdict;
    cell.expectation = target.expectation;
    cell.reason = reason_text(target);
  }
  const auto take_lower = [](std::optional<double>& lowest, const std::optional<double>& db) {
    if (db) lowest = std::min(lowest.value_or(*db), *db);
  };
  take_lower(cell.lowest_psnr_db, psnr_db(target));
  take_lower(cell.lowest_psnr_without_noise_db, deciding_psnr_without_noise_db(target));
}

void fill_requirements(results::RunRecord& record) {
  record.requirements.clear();
  for (const auto& one_case : record.cases) {
    const auto known = std::any_of(record.requirements.begin(), record.requirements.end(),
                                   [&](const auto& r) { return r.code == one_case.requirement; });
    if (known) continue;
    const auto group = registry::what_of_group(one_case.requirement.front());
    record.requirements.push_back({one_case.requirement, one_case.title, {}, std::string(group)});
  }
  for (auto& requirement : record.requirements)
    for (const auto& target : record.targets) {
      if (target.requirement != requirement.code) continue;
      const bool is_first = !requirement.cells.contains(target.renderer);
      add_to_cell(target, is_first, requirement.cells[target.renderer]);
    }
}

void fill_renderer(const results::RunRecord& run, results::RendererRecord& record) {
  record.counts.clear();
  record.wall_seconds = 0;
  record.cpu_seconds = 0;
  record.measured = measured_features(run.requirements, record.name);
  for (const auto& requirement : run.requirements)
    if (const auto cell = requirement.cells.find(record.name); cell != requirement.cells.end())
      ++record.counts[std::string(results::state_name(cell->second.verdict, cell->second.expectation))];
  for (const auto& job : run.jobs) {
    if (job.identity.renderer != record.name) continue;
    record.wall_seconds += job.cost.wall_seconds;
    record.cpu_seconds += job.cost.cpu_seconds;
  }
}

}  // namespace

std::string measured_features(const std::vector<results::RequirementRecord>& requirements,
                              const std::string& renderer) {
  registry::FeatureSet measured;
  registry::FeatureSet undecided;
  for (const auto& requirement : requirements) {
    const auto code = registry::parse_requirement(requirement.code);
    const auto cell = requirement.cells.find(renderer);
    const auto verdict = cell == requirement.cells.end()
                             ? Verdict::Skipped
                             : cell->second.worst_verdict.value_or(cell->second.verdict);
    if (!results::is_decided(verdict)) {
      undecided[code.group].insert(code.level);
      continue;
    }
    auto& levels = measured[code.group];
    if (passes(verdict)) levels.insert(code.level);
  }
  return registry::format_features(measured, undecided);
}

void summarise(const Plan& plan, const std::vector<std::string>& versions, results::RunRecord& record) {
  record.renderers.clear();
  for (std::size_t i = 0; i < plan.renderers.size(); ++i) {
    const auto& chosen = plan.renderers[i];
    auto& renderer = record.renderers.emplace_back();
    renderer.name = chosen.entry.name;
    renderer.variant_of = chosen.entry.variant_of;
    renderer.version = versions[i];
    renderer.executable = chosen.executable.string();
    renderer.declared = registry::format_features(chosen.entry.support.declares);
    renderer.could_read_references = !plan.settings.sandbox && !is_built_in(plan, chosen);
  }
  summarise(record);
}

void summarise(results::RunRecord& record) {
  fill_requirements(record);
  for (auto& renderer : record.renderers) fill_renderer(record, renderer);
}

}  // namespace orbs::run
