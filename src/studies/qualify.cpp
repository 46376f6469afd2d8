#include "studies/qualify.h"

#include "adapters/job.h"
#include "base/error.h"
#include "base/local_time.h"
#include "base/parallel.h"
#include "base/scratch_folder.h"
#include "image/image_io.h"
#include "runner/execute.h"
#include "runner/host.h"
#include "runner/judge.h"
#include "runner/provenance.h"
#include "runner/qualified.h"
#include "runner/summary.h"
#include "studies/mutation_test.h"

#include <algorithm>
#include <map>
#include <mutex>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

using image::Image;
using results::GateRecord;

struct Work {
  const runner::Plan& plan;
  const results::RunRecord& run;
  const QualifySettings& settings;
  const StudyContext& context;
  std::map<std::string, Image> references;                // of the whole suite
  std::map<std::string, std::vector<MissingLight>> dark;  // by scene
};

struct Subject {
  const registry::Case* one_case;
  std::string target;
};

std::map<std::string, Image> all_references(const std::filesystem::path& folder) {
  std::map<std::string, Image> references;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed))
    if (entry.path().extension() == ".exr")
      references[entry.path().stem().string()] = image::read_image(entry.path());
  if (failed) throw InputError(fmt::format("{}: cannot be read: {}", folder.string(), failed.message()));
  return references;
}

bool is_wanted(const Work& work, const std::string& scene) {
  return std::any_of(work.plan.cases.begin(), work.plan.cases.end(), [&](const auto& one_case) {
    return std::any_of(one_case.scenes.begin(), one_case.scenes.end(),
                       [&](const auto& one) { return one.name == scene; });
  });
}

void render_without_lights(Work& work) {
  const ScratchFolder scratch("orbs-qualify");
  for (const auto& scene : work.plan.scenes) {
    if (!is_wanted(work, scene.name) || !why_no_light_can_miss(*scene.scene).empty()) continue;
    const int spp = adapters::scaled_spp(scene.spp, 1, work.settings.missing_light_spp_scale);
    auto targets = without_each_light(work.plan, scene, spp, scratch.path(), work.context.stop);
    if (!targets) return;
    work.context.say(fmt::format("{}: rendered without each of its {} lights", scene.name, targets->size()));
    work.dark[scene.name] = std::move(*targets);
  }
}

// Throws InputError where there is none that could be judged.
Image control_target(const Work& work, const Subject& subject) {
  for (const auto& target : work.run.targets) {
    if (target.renderer != work.settings.renderer || target.case_name != subject.one_case->name ||
        target.target != subject.target)
      continue;
    if (target.image.empty())
      throw InputError(
          fmt::format("{} has no image in {}: {}", target.renderer, work.run.folder, target.reason));
    return image::read_image(std::filesystem::path(work.run.folder) / target.image);
  }
  throw InputError(fmt::format("{} holds no image of it by {}", work.run.folder, work.settings.renderer));
}

std::string why_not_dark(const Work& work, const std::string& target) {
  const auto scene = std::find_if(work.plan.scenes.begin(), work.plan.scenes.end(),
                                  [&](const auto& one) { return one.name == target; });
  if (scene == work.plan.scenes.end()) return "a difference of two scenes, which are tried themselves";
  return why_no_light_can_miss(*scene->scene);
}

GateRecord tried_gate(const Work& work, const Subject& subject) {
  static const std::vector<MissingLight> kNone;
  const auto control = control_target(work, subject);
  auto reference = runner::load_reference(*subject.one_case, subject.target, work.plan.suite.references,
                                          work.plan.reference_hashes);
  if (!reference.image) throw InputError(reference.problem);
  const auto seed = runner::provenance_of(control)["seed"];
  if (!seed.empty() && runner::provenance_of(*reference.image)["seed"] == seed)
    throw InputError("its image has the seed of the reference: it shares its noise, and proves nothing");
  const auto dark = work.dark.find(subject.target);
  auto gate = try_gate({*subject.one_case, subject.target, reference, control, work.references,
                        dark == work.dark.end() ? kNone : dark->second, why_not_dark(work, subject.target)});
  for (const char* key : {"program", "version", "spp", "seed"})
    gate.control[key] = runner::provenance_of(control)[key];
  return gate;
}

GateRecord gate_record(const Work& work, const Subject& subject) {
  GateRecord gate;
  try {
    gate = tried_gate(work, subject);
  } catch (const InputError& e) {
    gate.case_name = subject.one_case->name;
    gate.target = subject.target;
    gate.control_reason = fmt::format("not tried: {}", e.what());
  }
  gate.judged_by = runner::gate_hash(*subject.one_case, subject.target, work.plan.suite.references);
  gate.provenance = {{"program", "orbs"},
                     {"version", work.context.orbs_version},
                     {"date", local_time_now()},
                     {"cpu", runner::this_host().cpu}};
  return gate;
}

}  // namespace

std::vector<GateRecord> qualify(const runner::Plan& plan,
                                const results::RunRecord& run,
                                const QualifySettings& settings,
                                const StudyContext& context) {
  Work work{plan, run, settings, context, all_references(plan.suite.references), {}};
  render_without_lights(work);
  std::vector<Subject> subjects;
  for (const auto& one_case : plan.cases)
    for (const auto& target : registry::target_names(one_case)) subjects.push_back({&one_case, target});
  std::vector<GateRecord> gates(subjects.size());
  std::mutex saying;
  for_each_index(static_cast<int>(subjects.size()), plan.threads, [&](int index) {
    if (is_stopped(context)) return;
    auto& gate = gates[static_cast<std::size_t>(index)];
    gate = gate_record(work, subjects[static_cast<std::size_t>(index)]);
    const std::scoped_lock lock(saying);
    context.say(fmt::format("{} {}: {}", gate.case_name, gate.target,
                            results::is_qualified(gate) ? "qualified" : "not qualified"));
  });
  std::erase_if(gates, [](const auto& gate) { return gate.target.empty(); });
  return gates;
}

std::vector<GateRecord> merged(std::vector<GateRecord> known, const std::vector<GateRecord>& found) {
  for (const auto& gate : found) {
    const auto same = std::find_if(known.begin(), known.end(), [&](const auto& one) {
      return one.case_name == gate.case_name && one.target == gate.target;
    });
    if (same == known.end()) {
      known.push_back(gate);
    } else {
      *same = gate;
    }
  }
  std::sort(known.begin(), known.end(), [](const auto& a, const auto& b) {
    return std::pair(a.case_name, a.target) < std::pair(b.case_name, b.target);
  });
  return known;
}

}  // namespace orbs::studies
