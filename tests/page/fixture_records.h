#pragma once

#include "results/record.h"

#include <filesystem>
#include <string>
#include <vector>

/// The records that the made-up runs are made of.
namespace orbs::page_tests {

/// A render that left an image after that time.
results::JobRecord job_of(const std::string& scene, const std::string& renderer, double seconds);

/// The image of the render, judged by psnr_srgb8. The requirement is the beginning of the case's name.
results::TargetRecord target_of(const std::string& case_name,
                                const results::JobRecord& job,
                                results::Verdict verdict);

results::CaseRecord case_of(const std::string& suite, const std::string& name, const std::string& title);

/// A run of no cases.
results::RunRecord blank_run(const std::vector<std::string>& renderers);

/// Writes results.json, with the requirements of the cases.
void write_run(results::RunRecord run, const std::filesystem::path& folder);

}  // namespace orbs::page_tests
