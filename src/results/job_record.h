#pragma once

#include "json/fields.h"
#include "results/host_record.h"
#include "results/job_outcome.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// What is recorded of one render. Each member is also listed in the struct's fields(): see fields.h.
namespace orbs::results {

/// What was rendered.
struct JobIdentity {
  std::string id;  // the same for the same suite, scene, renderer, samples and seed
  std::string suite;
  std::string scene;
  std::string renderer;
  int spp = 1;    // of a sequential render: all so far
  int seed = 0;   // the first seed
  int seeds = 1;  // number of consecutive seeds that share the samples
};

template <class Visitor, json::RecordOf<JobIdentity> Record>
void fields(Visitor& visit, Record& identity) {
  visit.required("id", identity.id);
  visit("suite", identity.suite);
  visit.required("scene", identity.scene);
  visit.required("renderer", identity.renderer);
  visit("spp", identity.spp, {.range = {.min = 1}});
  visit("seed", identity.seed);
  visit("seeds", identity.seeds, {.range = {.min = 1}});
}

/// What was started.
struct JobProgram {
  std::string version;
  std::vector<std::string> argv;  // paths in the folder of the render are relative to it
  std::string shell;              // for a shell in the folder of the run, where it repeats the render
  int threads = 0;
};

template <class Visitor, json::RecordOf<JobProgram> Record>
void fields(Visitor& visit, Record& program) {
  visit("version", program.version);
  visit("argv", program.argv);
  visit("shell", program.shell);
  visit("threads", program.threads, {.range = {.min = 0}});
}

/// What the render and its verdict depend on: --resume renders or judges again where a hash differs.
struct JobHashes {
  std::string scene;
  std::string program;   // the executable and the files that the command names; "" if they changed meanwhile
  std::string files;     // scene file and image in the folder of the render
  std::string settings;  // what else makes the image: command, environment, threads
  std::string limits;    // what may end the render without an image: time, memory, files
  std::string judged;    // what its images were judged by: cases, references, the version of orbs
  std::string image;     // the image's file, by which merge notices damage; "" if there is none
};

template <class Visitor, json::RecordOf<JobHashes> Record>
void fields(Visitor& visit, Record& hashes) {
  visit("scene", hashes.scene);
  visit("program", hashes.program);
  visit("files", hashes.files);
  visit("settings", hashes.settings);
  visit("limits", hashes.limits);
  visit("judged", hashes.judged);
  visit("image", hashes.image);
}

/// When and where the render ran, and what it took. Several seeds add up.
struct JobCost {
  std::string started;  // local time, ISO 8601; "" if it never was
  double load = 0;      // processes that wanted to run on the machine then, mean of the minute before
  double wall_seconds = 0;
  double cpu_seconds = 0;                // user and system
  std::optional<double> render_seconds;  // as the renderer itself reports
  std::size_t peak_rss_bytes = 0;
  Host host;
};

template <class Visitor, json::RecordOf<JobCost> Record>
void fields(Visitor& visit, Record& cost) {
  visit("started", cost.started);
  visit("load", cost.load);
  visit("wall_seconds", cost.wall_seconds);
  visit("cpu_seconds", cost.cpu_seconds);
  visit("render_seconds", cost.render_seconds);
  visit("peak_rss_bytes", cost.peak_rss_bytes);
  visit("host", cost.host);
}

/// How the render ended.
struct JobEnd {
  JobOutcome outcome = JobOutcome::Skipped;
  std::string reason;  // "" for a usable image
  int exit_code = 0;
  std::string signal;  // "SIGSEGV", "" for none
  bool core_dumped = false;
};

template <class Visitor, json::RecordOf<JobEnd> Record>
void fields(Visitor& visit, Record& end) {
  visit.required("outcome", end.outcome);
  visit("reason", end.reason);
  visit("exit_code", end.exit_code);
  visit("signal", end.signal);
  visit("core_dumped", end.core_dumped);
}

/// How the two renders of one look differ, which is noise: the mean of the first less that of the second.
struct LookApart {
  int spp = 0;  // of both together
  double r = 0;
  double g = 0;
  double b = 0;
};

template <class Visitor, json::RecordOf<LookApart> Record>
void fields(Visitor& visit, Record& apart) {
  visit("spp", apart.spp, {.range = {.min = 1}});
  visit("r", apart.r);
  visit("g", apart.g);
  visit("b", apart.b);
}

/// How the samples of a sequential render came about.
struct JobSampling {
  int looks = 0;       // 0: the samples were fixed beforehand
  int most_looks = 0;  // that the error rates allow for
  /// Why there are no more: "decided", "edge", "reference", "budget", "looks"; "" while it goes on.
  std::string end;
  std::vector<LookApart> apart{};  // by look
  bool has_equal_seeds = false;  // the two renders of the first look were equal to the bit: all at once, then
};

template <class Visitor, json::RecordOf<JobSampling> Record>
void fields(Visitor& visit, Record& sampling) {
  visit("looks", sampling.looks, {.range = {.min = 0}});
  visit("most_looks", sampling.most_looks, {.range = {.min = 0}});
  visit("end", sampling.end);
  visit("apart", sampling.apart);
  visit("equal_seeds", sampling.has_equal_seeds);
}

/// What rounding decides in the scene: it was rendered in single and in double precision, with few samples
/// and the same random numbers, before the render that is judged.
struct JobCondition {
  int spp = 0;        // of either render; 0: none was made
  double pixels = 0;  // mean of the absolute differences of single pixels, over the mean of the image
  int x = 0;          // pixel that differs most
  int y = 0;
  std::string problem;     // why there is no number; "" where there is one
  double cpu_seconds = 0;  // of both renders; part of the job's cost
  std::string shell;       // for a shell in the folder of the run, where it repeats both
};

template <class Visitor, json::RecordOf<JobCondition> Record>
void fields(Visitor& visit, Record& condition) {
  visit("spp", condition.spp, {.range = {.min = 0}});
  visit("pixels", condition.pixels);
  visit("x", condition.x);
  visit("y", condition.y);
  visit("problem", condition.problem);
  visit("cpu_seconds", condition.cpu_seconds);
  visit("shell", condition.shell);
}

/// Paths, relative to the run's folder.
struct JobFiles {
  std::string folder;
  std::string native_scene;  // the hand-written scene, relative to the program's data; "" for an exported one
  std::string image;         // "" if nothing can be looked at
  std::string log;           // "" if it was not kept
};

template <class Visitor, json::RecordOf<JobFiles> Record>
void fields(Visitor& visit, Record& files) {
  visit.inside_folder("folder", files.folder);
  visit("native_scene", files.native_scene);
  visit.inside_folder("image", files.image);
  visit.inside_folder("log", files.log);
}

/// One render: what was started, what it cost, how it ended.
struct JobRecord {
  JobIdentity identity;
  JobProgram program;
  JobHashes hashes;
  JobCost cost;
  JobEnd end;
  JobFiles files;
  JobSampling sampling;
  JobCondition condition;
};

template <class Visitor, json::RecordOf<JobRecord> Record>
void fields(Visitor& visit, Record& job) {
  visit.required("identity", job.identity);
  visit("program", job.program);
  visit("hashes", job.hashes);
  visit("cost", job.cost);
  visit.required("end", job.end);
  visit("files", job.files);
  visit("sampling", job.sampling);
  visit("condition", job.condition);
}

inline bool has_image(const JobRecord& job) { return job.end.outcome == JobOutcome::Image; }

}  // namespace orbs::results
