#pragma once

#include "results/fields.h"

#include <filesystem>
#include <string>
#include <vector>

/// The whole plan of a run, by which its shards are put together. Each member is also listed in the struct's
/// fields(): see fields.h.
namespace orbs::results {

struct ListedJob {
  std::string id;  // as JobIdentity has it
  std::string renderer;
  std::string scene;
};

template <class Visitor, RecordOf<ListedJob> Record>
void fields(Visitor& visit, Record& job) {
  visit.required("id", job.id);
  visit.required("renderer", job.renderer);
  visit.required("scene", job.scene);
}

struct ListedTarget {
  std::string case_name;
  std::string target;
  std::string renderer;
  std::vector<std::string> jobs;  // ids of those that it is judged from; none if it is not rendered
};

template <class Visitor, RecordOf<ListedTarget> Record>
void fields(Visitor& visit, Record& target) {
  visit.required("case", target.case_name);
  visit.required("target", target.target);
  visit.required("renderer", target.renderer);
  visit("jobs", target.jobs);
}

struct JobList {
  std::string plan;  // hash of all that the images and verdicts depend on but for programs and machines
  std::vector<std::string> scenes;
  std::vector<ListedJob> jobs;
  std::vector<ListedTarget> targets;
};

template <class Visitor, RecordOf<JobList> Record>
void fields(Visitor& visit, Record& list) {
  visit.required("plan", list.plan);
  visit("scenes", list.scenes);
  visit("jobs", list.jobs);
  visit("targets", list.targets);
}

/// Name of its file in the folder of a run.
inline constexpr const char* kJobListFile = "jobs.json";

/// Writes the file (format "orbs-jobs/1"). WriteError when the disk refuses.
void write_job_list(const JobList& list, const std::filesystem::path& folder);

/// InputError if there is no such file in `folder`, or it is broken.
JobList read_job_list(const std::filesystem::path& folder);

}  // namespace orbs::results
