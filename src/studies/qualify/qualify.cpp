#include "studies/qualify/qualify.h"

#include "adapters/job.h"
#include "base/error.h"
#include "base/files.h"
#include "base/local_time.h"
#include "base/nth.h"
#include "base/parallel.h"
#include "image/image.h"
#include "image/image_io.h"
#include "judge/provenance.h"
#include "judge/qualified.h"
#include "run/execute.h"
#include "run/host.h"
#include "studies/qualify/images.h"
#include "studies/qualify/mutation_test.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <mutex>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

using image::Image;
using results::GateRecord;

// What all targets of a qualification share.
struct Qualification {
  const run::Plan& plan;
  const results::RunRecord& run;
  const QualifySettings& settings;
  const StudyContext& context;
  std::map<std::string, Image> references;                      // of the whole suite
  std::map<std::string, std::vector<RenderedMutant>> rendered;  // mutants by scene
};

struct Subject {
  const registry::Case* one_case;
  std::string target;
};

std::map<std::string, Image> all_references(const std::filesystem::path& folder,
                                            const registry::ReducedSize& size) {
  std::map<std::string, Image> references;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed))
    if (entry.path().extension() == ".exr") {
      const auto image = image::read_image(entry.path());
      references[entry.path().stem().string()] =
          image::reduced_image(image, registry::divisor_of_image(image.width, image.height, size));
    }
  if (failed) throw InputError(fmt::format("{}: cannot be read: {}", folder.string(), failed.message()));
  return references;
}

bool is_wanted(const Qualification& shared, const std::string& scene) {
  return std::any_of(shared.plan.cases.begin(), shared.plan.cases.end(), [&](const auto& one_case) {
    return std::any_of(one_case.scenes.begin(), one_case.scenes.end(),
                       [&](const auto& one) { return one.name == scene; });
  });
}

void render_mutants(Qualification& shared) {
  const ScratchFolder scratch("orbs-qualify");
  for (const auto& scene : shared.plan.scenes) {
    if (!is_wanted(shared, scene.name)) continue;
    const int spp = adapters::scaled_spp(scene.spp, 1, shared.settings.missing_light_spp_scale);
    std::vector<RenderedMutant> mutants;
    if (why_no_light_can_miss(*scene.scene).empty()) {
      auto without = without_each_light(shared.plan, scene, spp, scratch.path(), shared.context.stop);
      if (!without) return;
      mutants = std::move(*without);
      shared.context.say(
          fmt::format("{}: rendered without each of its {} lights", scene.name, mutants.size()));
    }
    auto faulty = with_each_fault(shared.plan, scene, spp, scratch.path(), shared.context.stop);
    if (!faulty) return;
    if (!faulty->empty())
      shared.context.say(fmt::format("{}: rendered with {} faults of renderers", scene.name, faulty->size()));
    std::move(faulty->begin(), faulty->end(), std::back_inserter(mutants));
    shared.rendered[scene.name] = std::move(mutants);
  }
}

std::string why_no_missing_light(const Qualification& shared, const std::string& target) {
  const auto scene = std::find_if(shared.plan.scenes.begin(), shared.plan.scenes.end(),
                                  [&](const auto& one) { return one.name == target; });
  if (scene == shared.plan.scenes.end()) return "a difference of two scenes, which are tried themselves";
  return why_no_light_can_miss(*scene->scene);
}

GateRecord tested_gate(const Qualification& shared, const Subject& subject) {
  static const std::vector<RenderedMutant> kNone;
  const auto control =
      control_image(shared.run, shared.settings.renderer, subject.one_case->name, subject.target);
  auto reference =
      judge::load_reference(*subject.one_case, subject.target, shared.plan.suite.references,
                            shared.plan.reference_hashes, {}, registry::reduced_size(shared.plan.settings));
  if (!reference.image && registry::no_reference_reason(*subject.one_case, subject.target).empty())
    throw InputError(reference.problem);
  const auto seed = judge::provenance_of(control)["seed"];
  if (reference.image && !seed.empty() && judge::provenance_of(*reference.image)["seed"] == seed)
    throw InputError("its image has the seed of the reference: it shares its noise, and proves nothing");
  const auto rendered = shared.rendered.find(subject.target);
  auto gate = mutation_test({*subject.one_case, subject.target, reference, control, shared.references,
                             rendered == shared.rendered.end() ? kNone : rendered->second,
                             why_no_missing_light(shared, subject.target)});
  for (const char* key : {"program", "version", "spp", "seed"})
    gate.control[key] = judge::provenance_of(control)[key];
  return gate;
}

GateRecord gate_record(const Qualification& shared, const Subject& subject) {
  GateRecord gate;
  try {
    gate = tested_gate(shared, subject);
  } catch (const InputError& e) {
    gate.case_name = subject.one_case->name;
    gate.target = subject.target;
    gate.control_reason = fmt::format("not tried: {}", e.what());
  }
  gate.judged_by = judge::gate_hash(*subject.one_case, subject.target, shared.plan.suite.references);
  gate.provenance = {{"program", "orbs"},
                     {"version", shared.context.orbs_version},
                     {"date", local_time_now()},
                     {"cpu", run::this_host().cpu}};
  return gate;
}

}  // namespace

std::vector<GateRecord> qualify(const run::Plan& plan,
                                const results::RunRecord& run,
                                const QualifySettings& settings,
                                const StudyContext& context) {
  Qualification shared{plan,
                       run,
                       settings,
                       context,
                       all_references(plan.suite.references, registry::reduced_size(plan.settings)),
                       {}};
  render_mutants(shared);
  std::vector<Subject> subjects;
  for (const auto& target : plan.targets) {
    if (target.renderer != 0) continue;
    if (target.unsupported.empty()) {
      subjects.push_back({&plan.cases[target.one_case], target.target});
    } else {
      context.say(
          fmt::format("{} {}: {}", plan.cases[target.one_case].name, target.target, target.unsupported));
    }
  }
  std::vector<GateRecord> gates(subjects.size());
  std::mutex saying;
  for_each_index(static_cast<int>(subjects.size()), plan.threads, [&](int index) {
    if (is_stopped(context)) return;
    auto& gate = nth(gates, index);
    gate = gate_record(shared, nth(subjects, index));
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
