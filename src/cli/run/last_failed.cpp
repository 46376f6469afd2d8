#include "cli/run/last_failed.h"

#include "base/error.h"
#include "base/text.h"
#include "cli/run/recorded_times.h"
#include "registry/filters.h"
#include "registry/image_size.h"
#include "results/record.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

namespace fs = std::filesystem;

// -r NAME chooses all variants of an entry, too.
bool is_chosen(const std::string& name,
               const results::RunRecord& run,
               const registry::RunSettings& settings) {
  const auto patterns = registry::patterns_of(settings.renderers);
  return std::any_of(run.renderers.begin(), run.renderers.end(), [&](const auto& renderer) {
    return renderer.name == name && (registry::matches_any(patterns, renderer.name) ||
                                     registry::matches_any(patterns, renderer.variant_of));
  });
}

bool is_alike(const results::RunRecord& run, const registry::RunSettings& settings) {
  return run.suite == settings.suite && run.size == registry::size_text(settings.size_divisor) &&
         std::any_of(run.renderers.begin(), run.renderers.end(),
                     [&](const auto& renderer) { return is_chosen(renderer.name, run, settings); });
}

std::optional<results::RunRecord> newest_alike(const fs::path& folder,
                                               const registry::RunSettings& settings) {
  for (const auto& file : results_files({folder})) {
    try {
      auto run = results::read_results_file(file);
      run.folder = file.parent_path().string();
      if (is_alike(run, settings)) return run;
    } catch (const InputError&) {
      continue;  // somebody else's results.json
    }
  }
  return std::nullopt;
}

}  // namespace

LastFailed last_failed(const registry::RunSettings& settings) {
  const auto folder = settings.output.empty()
                          ? fs::current_path()
                          : fs::absolute(settings.output).lexically_normal().parent_path();
  const auto run = newest_alike(folder, settings);
  if (!run)
    throw InputError(fmt::format(
        "--last-failed: there is no run of suite {} at size {} with one of these renderers in {}; run "
        "without it",
        settings.suite, registry::size_text(settings.size_divisor), folder.string()));
  LastFailed found{run->folder, {}};
  for (const auto& target : run->targets)
    if (target.declared && results::counts_as_failure(target.verdict, target.expectation) &&
        is_chosen(target.renderer, *run, settings))
      found.targets.push_back({target.renderer, target.case_name, target.target});
  return found;
}

}  // namespace orbs::cli
