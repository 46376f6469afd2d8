#pragma once

#include "results/job_record.h"
#include "results/scene_record.h"
#include "results/target_record.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// What is recorded of a run. Paths are relative to the run's folder if they lie in it. Each member is also
/// listed in the struct's fields(): see fields.h.

namespace orbs::results {

/// A cell of the summary table: the worst target of a requirement.
struct Cell {
  bool declared = false;
  Verdict verdict = Verdict::Skipped;
  std::optional<double> lowest_psnr_db;  // of the images; infinite if all equal their references
  std::string reason;                    // of the worst target
  Expectation expectation = Expectation::None;
  // Without regard to what is expected: beside an unexpected pass, that of a failure that is known.
  std::optional<Verdict> worst_verdict{};
  // The lowest of those that meet the gate without their noise only, none of them infinite; none where the
  // images' own PSNR decides.
  std::optional<double> lowest_psnr_without_noise_db{};
};

template <class Visitor, json::RecordOf<Cell> Record>
void fields(Visitor& visit, Record& cell) {
  visit("declared", cell.declared);
  visit.required("verdict", cell.verdict);
  visit.maybe_infinite("lowest_psnr_db", cell.lowest_psnr_db);
  visit("lowest_psnr_without_noise_db", cell.lowest_psnr_without_noise_db);
  visit("reason", cell.reason);
  visit("expectation", cell.expectation);
  visit("worst_verdict", cell.worst_verdict);
}

struct RequirementRecord {
  std::string code;  // "M2"
  std::string title;
  std::map<std::string, Cell> cells;  // by renderer
  std::string group = {};             // what all of its letter are about: "materials"
};

template <class Visitor, json::RecordOf<RequirementRecord> Record>
void fields(Visitor& visit, Record& requirement) {
  visit.required("code", requirement.code);
  visit("title", requirement.title);
  visit("group", requirement.group);
  visit("renderers", requirement.cells);
}

struct RendererRecord {
  std::string name;
  std::string variant_of;  // the entry of the configuration that lists it as a variant; "" for no variant
  std::string version;
  std::string executable;
  std::string declared;               // ORB.S notation
  std::string measured;               // "" if nothing was judged
  std::map<std::string, int> counts;  // state name -> requirements
  double wall_seconds = 0;
  double cpu_seconds = 0;
  bool could_read_references = false;  // no sandbox hid them; not said of orbs's own tracer
};

template <class Visitor, json::RecordOf<RendererRecord> Record>
void fields(Visitor& visit, Record& renderer) {
  visit.required("name", renderer.name);
  visit("variant_of", renderer.variant_of);
  visit("version", renderer.version);
  visit("executable", renderer.executable);
  visit("declared", renderer.declared);
  visit("measured", renderer.measured);
  visit("requirements_by_verdict", renderer.counts, {.range = {.min = 0}});
  visit("wall_seconds", renderer.wall_seconds);
  visit("cpu_seconds", renderer.cpu_seconds);
  visit("could_read_references", renderer.could_read_references);
}

/// A renderer that the run could not use.
struct LeftOut {
  std::string renderer;
  std::string reason;
};

template <class Visitor, json::RecordOf<LeftOut> Record>
void fields(Visitor& visit, Record& left) {
  visit.required("renderer", left.renderer);
  visit("reason", left.reason);
}

struct RunRecord {
  std::string suite;
  std::string size = "1";     // of the images: "1/4" for a quarter of the scenes' width and height
  std::string plan;           // id of its plan.json; "" for a run of an orbs that knew no shards
  bool strict = false;        // a pass with remarks makes it fail
  std::string shard = "1/1";  // the part of the renders that this run does
  std::string folder;         // absolute; not stored, because the folder may be moved
  std::string name;           // of the folder, for people; not stored either
  std::string started;
  std::string label;  // what was tested, such as a commit; "" if nobody said so
  double wall_seconds = 0;
  std::string orbs_version;
  std::vector<std::string> command_line;
  Host host;        // renders of an earlier run that was resumed may have another one
  double load = 0;  // when the run started, as for a render
  bool interrupted = false;
  bool finished = true;  // false while running; stays false if the run was killed
  std::vector<CaseRecord> cases;
  std::vector<SceneRecord> scenes;
  std::optional<EffectStudyRecord> effect_study;  // that measured the effect costs of the scenes
  std::vector<RendererRecord> renderers;
  std::vector<LeftOut> left_out;
  std::vector<RequirementRecord> requirements;
  std::vector<TargetRecord> targets;
  std::vector<JobRecord> jobs;
};

template <class Visitor, json::RecordOf<RunRecord> Record>
void fields(Visitor& visit, Record& run) {
  visit("suite", run.suite);
  visit("size", run.size);
  visit("plan", run.plan);
  visit("strict", run.strict);
  visit("shard", run.shard);
  visit("orbs_version", run.orbs_version);
  visit("command_line", run.command_line);
  visit("started", run.started);
  visit("label", run.label);
  visit("load", run.load);
  visit("wall_seconds", run.wall_seconds);
  visit("interrupted", run.interrupted);
  visit("finished", run.finished);
  visit("host", run.host);
  visit("cases", run.cases);
  visit("scenes", run.scenes);
  visit("effect_study", run.effect_study);
  visit("renderers", run.renderers);
  visit("left_out", run.left_out);
  visit("requirements", run.requirements);
  visit("targets", run.targets);
  visit("jobs", run.jobs);
}

/// The renders of a run by their ids. Points into the record.
using JobsById = std::map<std::string, const JobRecord*>;

JobsById jobs_by_id(const RunRecord& run);

/// Which renderers could have read the references while they rendered, in one sentence; "" where a sandbox
/// hid them from all.
std::string references_note(const RunRecord& run);

/// The shell commands of the renders that the target's image is made from, joined by " ; ".
std::string command_of(const JobsById& jobs, const TargetRecord& target);

/// True if every target is unsupported, which says nothing about any renderer.
bool judged_nothing(const RunRecord& run);

/// 0 if nothing that counts failed, else 1: a failure counts if the renderer declares the requirement and the
/// configuration does not expect it. 2 if nothing was judged.
int exit_status(const RunRecord& run);

/// The contents of a job.json: the render, and the targets whose image it makes alone.
struct JobFile {
  JobRecord job;
  std::vector<TargetRecord> targets;
};

/// Reads a job.json. InputError with file, line and key. Unknown members are ignored, since a newer program
/// may have written them; a missing member keeps its default unless it is required.
JobFile read_job_file(const std::filesystem::path& file);

/// Reads a results.json in the same way. `folder` of the record is the one that the file lies in now, not the
/// one that it was written to.
RunRecord read_results_file(const std::filesystem::path& file);

/// The text of a job's job.json (format "orbs-job/2"): the record of the render, and the records of the
/// targets whose image it makes alone.
std::string job_json(const JobRecord& job, const std::vector<TargetRecord>& targets);

/// The text that `orbs effects --json` prints (format "orbs-effects/1").
std::string scenes_json(const std::vector<SceneRecord>& scenes);

/// The text of results.json (format "orbs-results/2"): the whole record. The host of a render is left out if
/// it is the run's.
std::string run_json(const RunRecord& run);

}  // namespace orbs::results
