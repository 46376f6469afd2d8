#pragma once

#include "results/read_record.h"
#include "run/execute.h"
#include "run/plan/plan.h"

#include <cstddef>
#include <optional>
#include <string>

/// What is done with a job of which an earlier run may have left a render.
namespace orbs::run {

enum class Step { Keep, Judge, Render };

struct Resumption {
  Step step = Step::Render;
  std::string reason{};                     // why a render that is there is made again; "" where none is
  std::optional<results::JobFile> found{};  // what is kept or judged
};

/// Decides by what lies in the run's folder. `now` is the record of the job with the hashes of today and the
/// version of its renderer.
Resumption resumption_of(const Plan& plan,
                         std::size_t job,
                         const results::JobRecord& now,
                         const WorkFolders& folders);

/// The render that was found, in an unfinished folder of its own, to be judged by what has changed. Nothing
/// when its image is gone or cannot be read any more.
std::optional<Execution> take_over(const results::JobRecord& found,
                                   const std::filesystem::path& folder,
                                   const WorkFolders& folders);

}  // namespace orbs::run
