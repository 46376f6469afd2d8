#pragma once

#include "results/study_kinds.h"
#include "studies/stability/numbers.h"
#include "studies/stability/record.h"

#include <filesystem>
#include <string>
#include <vector>

/// The file of a study of stability.
namespace orbs::studies {

std::vector<results::Definition> stability_definitions();

/// stability.json (format "orbs-stability/1"): what was measured, and what follows from it.
struct StabilityStudy {
  StabilityRecord record;
  std::vector<results::Definition> definitions = stability_definitions();
  std::vector<StabilityCell> matrix;
  std::vector<std::string> summaries;  // of each renderer, see stability_summary
};

template <class Visitor, json::RecordOf<StabilityStudy> Record>
void fields(Visitor& visit, Record& study) {
  fields(visit, study.record);
  visit("definitions", study.definitions);
  visit("matrix", study.matrix);
  visit("summaries", study.summaries);
}

std::string stability_json(const StabilityRecord& record);

/// InputError if the file is missing, broken or of another format, or a step is of something that the file
/// does not list.
StabilityRecord read_stability_file(const std::filesystem::path& file);

}  // namespace orbs::studies
