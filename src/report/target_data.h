#pragma once

#include "results/run_folder.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::report {

/// An image of a target, in the folder of the run.
struct ImageFile {
  std::string name;
  std::string_view kind;  // "result", "reference", "proof" of the diagnosis, or "map"
  std::string file;
  std::optional<std::string> definition = {};  // of proofs and maps; the rest is of maps
  std::optional<bool> is_signed = {};
  std::optional<double> scale_maximum = {};
};

template <class Visitor, json::RecordOf<ImageFile> Record>
void fields(Visitor& visit, Record& image) {
  visit("name", image.name);
  visit("kind", image.kind);
  visit("file", image.file);
  visit("definition", image.definition);
  visit("signed", image.is_signed);
  visit("scale_maximum", image.scale_maximum);
}

/// The whole record of a render, and the end of its log.
struct Job {
  results::JobRecord record;
  std::string log;
};

template <class Visitor, json::RecordOf<Job> Record>
void fields(Visitor& visit, Record& job) {
  fields(visit, job.record);
  visit("log", job.log);
}

/// The data of one target beyond the overview.
struct TargetDetail {
  std::string case_name;
  std::string target;
  std::string renderer;
  std::string requirement;
  std::string reason;
  std::string reference;
  std::vector<std::string> remarks;
  std::string diagnosis;
  std::string hidden;
  std::vector<results::Measure> measures;
  std::vector<results::Check> checks;
  std::vector<results::LookRecord> looks;
  std::vector<results::WrongRegion> wrong_regions;
  std::vector<ImageFile> images;
  std::map<std::string, std::string> reference_provenance;
  std::vector<Job> jobs;
  std::vector<results::SceneRecord> scenes;  // of its renders
  std::string command;                       // renders and judges this target again, and no other
  std::string accept_command;  // likewise, and makes its failure a known one; "" for what is no failure, and
                               // for a known one; the reason follows it
  std::string reference_command;  // renders its missing reference; the reason follows it where there is one
};

template <class Visitor, json::RecordOf<TargetDetail> Record>
void fields(Visitor& visit, Record& detail) {
  visit("case", detail.case_name);
  visit("target", detail.target);
  visit("renderer", detail.renderer);
  visit("requirement", detail.requirement);
  visit("reason", detail.reason);
  visit("reference", detail.reference);
  visit("remarks", detail.remarks);
  visit("diagnosis", detail.diagnosis);
  visit("hidden", detail.hidden);
  visit("measures", detail.measures);
  visit("checks", detail.checks);
  visit("looks", detail.looks);
  visit("wrong_regions", detail.wrong_regions);
  visit("images", detail.images);
  visit("reference_provenance", detail.reference_provenance);
  visit("jobs", detail.jobs);
  visit("scenes", detail.scenes);
  visit("command", detail.command);
  visit("accept_command", detail.accept_command);
  visit("reference_command", detail.reference_command);
}

/// `index` is that of run.targets.
TargetDetail target_detail(const results::RunView& view, std::size_t index);

std::string target_json(const results::RunView& view, std::size_t index);

}  // namespace orbs::report
