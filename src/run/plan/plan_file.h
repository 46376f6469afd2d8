#pragma once

#include "json/fields.h"
#include "registry/configuration.h"
#include "registry/limits.h"
#include "results/record.h"
#include "run/plan/plan.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// plan.json (format "orbs-plan/1"): a whole plan as a file. Every run keeps it beside its results, and other
/// machines that have the same suite and the same programs execute it without planning again. Paths are
/// relative: that of the root to the folder of the file, all others to the root if they lie in it.
namespace orbs::run {

inline constexpr const char* kPlanFile = "plan.json";

struct FiledCase {
  std::string name;
  std::string file;
  std::string hash;                  // of the file
  std::vector<std::string> targets;  // those that are chosen
};

template <class Visitor, json::RecordOf<FiledCase> Record>
void fields(Visitor& visit, Record& one_case) {
  visit.required("name", one_case.name);
  visit.required("file", one_case.file);
  visit.required("hash", one_case.hash);
  visit.required("targets", one_case.targets);
}

/// The entry of a renderer with the settings of the run's size.
struct FiledRenderer {
  registry::Renderer entry;
  registry::LimitSettings limits;
  std::string program;  // hash of its files, see ProgramWatch; "" where it is elsewhere
};

template <class Visitor, json::RecordOf<FiledRenderer> Record>
void fields(Visitor& visit, Record& renderer) {
  fields(visit, renderer.entry);
  visit("variant_of", renderer.entry.variant_of);
  visit("arguments", renderer.entry.command.arguments);
  visit("limits", renderer.limits);
  visit("program", renderer.program);
}

struct FiledJob {
  std::string id;  // as JobIdentity has it
  std::string renderer;
  std::string scene;
  int spp = 1;
  int first_spp = 0;
  std::string native_scene;
  std::string scene_hash;  // see scene_hash()
  bool may_be_negative = false;
  double cpu_seconds = 1;
};

template <class Visitor, json::RecordOf<FiledJob> Record>
void fields(Visitor& visit, Record& job) {
  visit.required("id", job.id);
  visit.required("renderer", job.renderer);
  visit.required("scene", job.scene);
  visit.required("spp", job.spp, {.range = {1, 1 << 30}});
  visit("first_spp", job.first_spp, {.range = {0, 1 << 30}});
  visit("native_scene", job.native_scene);
  visit.required("scene_hash", job.scene_hash);
  visit("may_be_negative", job.may_be_negative);
  visit("cpu_seconds", job.cpu_seconds, {.range = json::kNotNegative});
}

struct FiledTarget {
  std::string case_name;
  std::string target;
  std::string renderer;
  std::vector<std::string> jobs;  // ids of those that it is judged from; none if it is not rendered
  bool declared = false;
  std::string unsupported;
};

template <class Visitor, json::RecordOf<FiledTarget> Record>
void fields(Visitor& visit, Record& target) {
  visit.required("case", target.case_name);
  visit.required("target", target.target);
  visit.required("renderer", target.renderer);
  visit("jobs", target.jobs);
  visit("declared", target.declared);
  visit("unsupported", target.unsupported);
}

struct FiledPlan {
  std::string id;
  std::string orbs_version;   // that made the plan
  std::string root;           // absolute here, relative to its folder in the file
  std::string configuration;  // the file that it was made from
  bool rendered_here = true;  // not by orbs export
  registry::SuiteEntry suite;
  registry::RunSettings settings;
  int threads = 1;
  std::vector<FiledRenderer> renderers;
  std::vector<results::LeftOut> left_out;
  std::vector<FiledCase> cases;
  std::map<std::string, std::string> reference_hashes;
  std::vector<FiledJob> jobs;
  std::vector<FiledTarget> targets;
  std::vector<registry::ExpectedFailure> expected;
};

template <class Visitor, json::RecordOf<FiledPlan> Record>
void fields(Visitor& visit, Record& plan) {
  visit.required("id", plan.id);
  visit.required("orbs_version", plan.orbs_version);
  visit.required("root", plan.root);
  visit.required("configuration", plan.configuration);
  visit("rendered_here", plan.rendered_here);
  visit.required("suite", plan.suite);
  visit.required("settings", plan.settings);
  visit.required("threads", plan.threads, {.range = {1, registry::kMostThreads}});
  visit.required("renderers", plan.renderers);
  visit("left_out", plan.left_out);
  visit.required("cases", plan.cases);
  visit.required("reference_hashes", plan.reference_hashes);
  visit.required("jobs", plan.jobs);
  visit.required("targets", plan.targets);
  visit("expected", plan.expected);
}

/// The hash of a plan, by which shards know that they belong together.
std::string plan_id(const Plan& plan);

/// The plan as it is filed, with the programs as they are now unless they are elsewhere.
FiledPlan filed_plan(const Plan& plan, const std::string& orbs_version);

/// Writes plan.json into `folder`. WriteError when the disk refuses.
void write_plan(const FiledPlan& plan, const std::filesystem::path& folder);

/// InputError if there is no such file, or it is broken.
FiledPlan read_plan(const std::filesystem::path& file);

/// What the plan was made of and is no more, in words; programs and versions of orbs among them.
enum class PlanPart { Version, Program, Case, Scene };
struct PlanChange {
  PlanPart part;
  std::string what;
};

struct LoadedPlan {
  Plan plan;
  std::vector<PlanChange> changes;
};

/// The plan, to be executed on this machine by the programs in `program_folder`. InputError when a file or a
/// renderer is not there.
LoadedPlan load_plan(const FiledPlan& filed,
                     const std::filesystem::path& program_folder,
                     const std::string& orbs_version);

/// InputError that names every change of one of these parts.
void refuse_changes(const LoadedPlan& loaded, const std::vector<PlanPart>& parts);

}  // namespace orbs::run
