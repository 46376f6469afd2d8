#pragma once

#include "json/fields.h"
#include "registry/cluster.h"

#include <compare>
#include <filesystem>
#include <string>
#include <vector>

namespace orbs::run {

/// One of the targets that a run is confined to.
struct OnlyTarget {
  std::string renderer;
  std::string case_name;
  std::string target;

  auto operator<=>(const OnlyTarget&) const = default;
};

template <class Visitor, json::RecordOf<OnlyTarget> Record>
void fields(Visitor& visit, Record& only) {
  visit.required("renderer", only.renderer);
  visit.required("case", only.case_name);
  visit.required("target", only.target);
}

/// What a run adds to its plan, stored in its folder as run.json (format "orbs-run/2").
struct RunFile {
  std::string started;      // local time, ISO 8601
  registry::Shard shard{};  // the part of the plan that this run does
  std::string label{};
  std::vector<OnlyTarget> only{};  // none: all that the settings choose
};

template <class Visitor, json::RecordOf<RunFile> Record>
void fields(Visitor& visit, Record& file) {
  visit.required("started", file.started);
  visit.required("shard", file.shard);
  visit("label", file.label);
  visit("only", file.only);
}

/// Makes the folder of a run, or of a study: `wanted`, which must not exist or be empty, or "" for
/// <kind>-YYMMDD-HHMMSS (local time) in the current folder, with -2, -3, ... behind it where that is taken.
/// Returns the absolute path.
std::filesystem::path make_run_folder(const std::string& wanted, const std::string& kind = "outputs");

/// InputError when the folder is not that of a run, when its run.json is broken, or an earlier version of
/// orbs has written it.
RunFile read_run_file(const std::filesystem::path& folder);

void write_run_file(const RunFile& file, const std::filesystem::path& folder);

}  // namespace orbs::run
