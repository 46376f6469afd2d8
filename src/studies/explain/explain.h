#pragma once

#include "results/record.h"
#include "run/plan/plan.h"
#include "studies/context.h"

#include <optional>
#include <string>
#include <vector>

/// Why is an image wrong? The built-in tracer makes each mistake of scene/render_fault.h on purpose, and the
/// image is compared with what comes of it: the mistake that makes the same image is named.
namespace orbs::studies {

struct ExplainSettings {
  std::vector<std::string> renderers;  // whose wrong images are explained; empty: all
  double spp_scale = 0.25;             // times the samples of the case, for each mistake
};

/// What became of one wrong image.
struct Explanation {
  std::string renderer;
  std::string case_name;
  std::string target;
  std::optional<std::string> fault{};  // its name, where one explains the image
  double share = 0;                    // of the error, at least 0.9, that it explains
  std::vector<std::string> tried{};    // the mistakes that can change the scene
  std::string problem{};               // why the image could not be compared; "" if it could
};

/// One for each failed target of `run` among the plan's cases, by the scenes of the plan. The plan's first
/// renderer must be the built-in one. Fewer when the user interrupts.
std::vector<Explanation> explain(const run::Plan& plan,
                                 const results::RunRecord& run,
                                 const ExplainSettings& settings,
                                 const StudyContext& context);

/// A line for each, with the words of the fault.
std::string explanations_text(const std::vector<Explanation>& explanations);

}  // namespace orbs::studies
