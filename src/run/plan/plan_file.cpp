#include "run/plan/plan_file.h"

#include "adapters/process/programs.h"
#include "base/error.h"
#include "base/files.h"
#include "json/document.h"
#include "json/field_reader.h"
#include "json/field_writer.h"
#include "registry/cases.h"
#include "registry/image_size.h"
#include "run/condition.h"
#include "run/plan/choose_renderers.h"
#include "run/plan/render_seconds.h"
#include "run/plan/scenes.h"
#include "run/program_hash.h"
#include "run/resume.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::run {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFormat = "orbs-plan/1";

// Relative to the root for what lies in it: that is copied along with it.
std::string below(const fs::path& root, const fs::path& path) {
  const auto relative = path.lexically_normal().lexically_relative(root.lexically_normal());
  const bool is_inside = !relative.empty() && *relative.begin() != "..";
  return is_inside ? relative.string() : path.string();
}

constexpr double kMegabyte_bytes = 1 << 20;

std::optional<double> megabytes(const std::optional<std::size_t>& bytes) {
  if (!bytes) return std::nullopt;
  return static_cast<double>(*bytes) / kMegabyte_bytes;
}

registry::LimitSettings limit_settings(const ProcessLimits& limits) {
  return {limits.wall_seconds,
          limits.cpu_seconds,
          megabytes(limits.memory_bytes),
          megabytes(limits.output_bytes),
          megabytes(limits.log_bytes),
          limits.grace_seconds};
}

// Text that changes with what is judged and rendered, but not with the machine.
std::string hash_of_file(const fs::path& file) { return hash_text(content_hash(read_file(file))); }

}  // namespace

std::string plan_id(const Plan& plan) {
  auto hash =
      content_hash(fmt::format("{} {}", plan.suite.name, registry::size_text(plan.settings.size_divisor)));
  for (const auto& one_case : plan.cases) hash = content_hash(read_file(one_case.file), hash);
  for (const auto& scene : plan.scenes) hash = content_hash(plan.reference_hashes.at(scene.name), hash);
  for (const auto& job : plan.jobs) hash = content_hash(job.id, hash);
  // Shards are made by these times.
  if (const auto times = shipped_times_file(plan); no_file_problem(times).empty())
    hash = content_hash(read_file(times), hash);
  for (const auto& target : plan.targets)
    hash = content_hash(fmt::format("{} {} {}", plan.cases[target.one_case].name, target.target,
                                    plan.renderers[target.renderer].entry.name),
                        hash);
  return hash_text(hash);
}

FiledPlan filed_plan(const Plan& plan, const std::string& orbs_version) {
  const auto text = [&](const fs::path& path) { return below(plan.root, path); };
  FiledPlan filed;
  filed.id = plan.id;
  filed.orbs_version = orbs_version;
  filed.root = plan.root.string();
  filed.configuration = text(plan.configuration);
  filed.rendered_here = plan.place == RenderPlace::Here;
  filed.suite = {plan.suite.name, text(plan.suite.cases), text(plan.suite.references), {}};
  for (const auto& folder : plan.suite.data) filed.suite.data.push_back(text(folder));
  filed.settings = registry::lasting(plan.settings);
  filed.settings.output.clear();
  if (plan.settings.executable.find('/') != std::string::npos) {
    const auto file = text(fs::absolute(plan.settings.executable));
    // A name without a slash would be one on PATH.
    filed.settings.executable = file.find('/') == std::string::npos ? "./" + file : file;
  }
  filed.threads = plan.threads;
  FileHashes hashes;
  for (const auto& renderer : plan.renderers)
    filed.renderers.push_back({renderer.entry, limit_settings(renderer.entry.limits),
                               filed.rendered_here ? program_hash(renderer, plan, hashes) : ""});
  filed.left_out = plan.left_out;
  for (const auto& one_case : plan.cases)
    filed.cases.push_back(
        {one_case.name, text(one_case.file), hash_of_file(one_case.file), registry::target_names(one_case)});
  filed.reference_hashes = plan.reference_hashes;
  for (const auto& job : plan.jobs)
    filed.jobs.push_back({job.id, plan.renderers[job.renderer].entry.name, plan.scenes[job.scene].name,
                          job.spp, job.first_spp, job.native_scene.empty() ? "" : text(job.native_scene),
                          scene_hash(plan, job), job.may_be_negative, job.cpu_seconds});
  for (const auto& target : plan.targets) {
    auto& added = filed.targets.emplace_back();
    added = {plan.cases[target.one_case].name,
             target.target,
             plan.renderers[target.renderer].entry.name,
             {},
             target.declared,
             target.unsupported};
    for (const auto job : target.jobs) added.jobs.push_back(plan.jobs[job].id);
  }
  filed.expected = plan.expected;
  return filed;
}

void write_plan(const FiledPlan& plan, const fs::path& folder) {
  auto moved = plan;
  moved.root = fs::path(plan.root).lexically_relative(fs::absolute(folder).lexically_normal()).string();
  json::Writer out;
  out.begin_object().member("format", kFormat);
  json::write_fields(out, moved);
  write_file(folder / kPlanFile, out.end_object().text());
}

FiledPlan read_plan(const fs::path& file) {
  if (const auto problem = no_file_problem(file); !problem.empty())
    throw InputError(
        fmt::format("{}; orbs run writes a {} into the folder of every run", problem, kPlanFile));
  const auto document = json::parse_file(file);
  json::ObjectReader in(document);
  json::check_format(in, kFormat);
  FiledPlan plan;
  json::FieldReader read(in);
  fields(read, plan);
  plan.root = resolve_path(fs::absolute(file).parent_path(), plan.root).lexically_normal().string();
  // A path that ended in ".." has a slash at its end.
  if (plan.root.size() > 1 && plan.root.back() == '/') plan.root.pop_back();
  return plan;
}

namespace {

template <class Items, class NameOf>
std::size_t index_of(const Items& items, const std::string& name, NameOf&& name_of) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const auto& item) { return name_of(item) == name; });
  if (found == items.end())
    throw InputError(
        fmt::format("{}: names '{}', which it does not hold; make the plan again", kPlanFile, name));
  return static_cast<std::size_t>(found - items.begin());
}

void load_renderers(const FiledPlan& filed, LoadedPlan& loaded) {
  auto& plan = loaded.plan;
  for (const auto& renderer : filed.renderers) {
    ChosenRenderer chosen{renderer.entry, {}};
    registry::apply(renderer.limits, chosen.entry.limits);
    const auto name = program_name(chosen.entry, plan.root, plan.build);
    chosen.executable = name;
    if (filed.rendered_here) {
      const auto& given = plan.settings.executable.empty() ? name : plan.settings.executable;
      const auto found = adapters::find_program(given);
      if (!found)
        throw InputError(fmt::format("renderer '{}': {}; the plan needs it on this machine",
                                     chosen.entry.name, adapters::program_problem(given)));
      chosen.executable = *found;
    }
    plan.renderers.push_back(std::move(chosen));
  }
  refuse_missing_programs(plan);
  FileHashes hashes;
  for (std::size_t i = 0; i < plan.renderers.size() && filed.rendered_here; ++i)
    if (program_hash(plan.renderers[i], plan, hashes) != filed.renderers[i].program)
      loaded.changes.push_back(
          {PlanPart::Program,
           fmt::format("the program of renderer '{}', or a file that its command names ({})",
                       plan.renderers[i].entry.name, plan.renderers[i].executable.string())});
}

void load_cases(const FiledPlan& filed, LoadedPlan& loaded) {
  auto& plan = loaded.plan;
  for (const auto& one_case : filed.cases) {
    const auto file = resolve_path(plan.root, one_case.file);
    const auto whole = registry::load_case(file);
    plan.cases.push_back(registry::with_targets(whole, {one_case.targets.begin(), one_case.targets.end()}));
    if (hash_of_file(file) != one_case.hash)
      loaded.changes.push_back({PlanPart::Case, fmt::format("case '{}' ({})", one_case.name, file.string())});
  }
  load_scenes(plan);
}

void load_jobs(const FiledPlan& filed, LoadedPlan& loaded) {
  auto& plan = loaded.plan;
  const auto of_renderer = [](const ChosenRenderer& renderer) { return renderer.entry.name; };
  const auto of_scene = [](const PlannedScene& scene) { return scene.name; };
  for (const auto& job : filed.jobs) {
    PlannedJob planned;
    planned.id = job.id;
    planned.scene = index_of(plan.scenes, job.scene, of_scene);
    planned.renderer = index_of(plan.renderers, job.renderer, of_renderer);
    planned.spp = job.spp;
    planned.first_spp = job.first_spp;
    planned.folder = fs::path(job.renderer) / job.scene;
    if (!job.native_scene.empty()) planned.native_scene = resolve_path(plan.root, job.native_scene);
    planned.may_be_negative = job.may_be_negative;
    planned.cpu_seconds = job.cpu_seconds;
    if (scene_hash(plan, planned) != job.scene_hash)
      loaded.changes.push_back(
          {PlanPart::Scene, fmt::format("scene '{}', or a file that it names ({})", job.scene,
                                        plan.scenes[planned.scene].file.string())});
    plan.jobs.push_back(std::move(planned));
  }
  for (const auto& target : filed.targets) {
    auto& planned = plan.targets.emplace_back();
    planned.one_case =
        index_of(plan.cases, target.case_name, [](const registry::Case& one) { return one.name; });
    planned.renderer = index_of(plan.renderers, target.renderer, of_renderer);
    planned.target = target.target;
    planned.declared = target.declared;
    planned.unsupported = target.unsupported;
    for (const auto& id : target.jobs)
      planned.jobs.push_back(index_of(plan.jobs, id, [](const PlannedJob& job) { return job.id; }));
  }
}

}  // namespace

LoadedPlan load_plan(const FiledPlan& filed,
                     const fs::path& program_folder,
                     const std::string& orbs_version) {
  LoadedPlan loaded;
  auto& plan = loaded.plan;
  plan.id = filed.id;
  plan.place = filed.rendered_here ? RenderPlace::Here : RenderPlace::Elsewhere;
  plan.root = filed.root;
  plan.build = program_folder;
  plan.configuration = resolve_path(plan.root, filed.configuration);
  plan.suite = {filed.suite.name,
                resolve_path(plan.root, filed.suite.cases),
                resolve_path(plan.root, filed.suite.references),
                {}};
  for (const auto& folder : filed.suite.data) plan.suite.data.push_back(resolve_path(plan.root, folder));
  if (!fs::is_directory(plan.suite.cases))
    throw InputError(fmt::format(
        "the plan's suite '{}' is not at {}; name the configuration that has it with --configuration",
        plan.suite.name, plan.suite.cases.string()));
  plan.settings = filed.settings;
  if (plan.settings.executable.find('/') != std::string::npos)
    plan.settings.executable = resolve_path(plan.root, plan.settings.executable).string();
  plan.threads = filed.threads;
  plan.left_out = filed.left_out;
  plan.reference_hashes = filed.reference_hashes;
  plan.expected = filed.expected;
  if (orbs_version != filed.orbs_version)
    loaded.changes.push_back(
        {PlanPart::Version, fmt::format("orbs, which was {} and is {}", filed.orbs_version, orbs_version)});
  load_renderers(filed, loaded);
  load_cases(filed, loaded);
  reduce_size(plan);
  load_jobs(filed, loaded);
  plan_conditions(plan);
  return loaded;
}

void refuse_changes(const LoadedPlan& loaded, const std::vector<PlanPart>& parts) {
  std::vector<std::string> refused;
  for (const auto& change : loaded.changes)
    if (std::find(parts.begin(), parts.end(), change.part) != parts.end() &&
        std::find(refused.begin(), refused.end(), change.what) == refused.end())
      refused.push_back(change.what);
  if (!refused.empty())
    throw InputError(fmt::format("what the plan was made of has changed since: {}; make the plan again",
                                 fmt::join(refused, "; ")));
}

}  // namespace orbs::run
