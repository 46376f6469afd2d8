#pragma once

#include "results/study_kinds.h"
#include "studies/cost/numbers.h"

#include <filesystem>
#include <string>
#include <vector>

/// The files of a study of cost.
namespace orbs::studies {

std::vector<results::Definition> cost_definitions();

/// cost.json (format "orbs-cost/2"): what was measured, and what follows from it.
struct CostStudy {
  CostRecord record;
  std::vector<results::Definition> definitions = cost_definitions();
  std::vector<CostMetric> metrics{kCostMetrics.begin(), kCostMetrics.end()};
  CostNumbers numbers;
};

template <class Visitor, json::RecordOf<CostStudy> Record>
void fields(Visitor& visit, Record& study) {
  fields(visit, study.record);
  visit("definitions", study.definitions);
  visit("metrics", study.metrics);
  fields(visit, study.numbers);
}

std::string cost_json(const CostRecord& record);

/// Reads what was measured; everything else is computed anew. InputError with file, line and key.
CostRecord read_cost_file(const std::filesystem::path& file);

/// One line per render, with a header; numbers in full precision.
std::string cost_csv(const CostRecord& record);

}  // namespace orbs::studies
