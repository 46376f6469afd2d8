#pragma once

#include "run/plan/plan.h"
#include "studies/context.h"

#include <string>
#include <vector>

/// Which slight faults pass without a word, and how often a right image is called wrong: the two rates by
/// which a test is known.
namespace orbs::studies {

/// What is known of an image's noise when it is judged. NoiseFree: the renderer has none, and the reference
/// has a tenth of a control image's.
enum class NoiseKnowledge { Variances, TwoSeeds, OneSeed, NoiseFree };

const char* name_of(NoiseKnowledge knowledge);

/// What was said of an image, from the loudest to the most quiet. Hidden: it passes, and noise is said to
/// hide errors of 2 % over 64 px or of 5 % over 16 px.
enum class Answer { Rejected, Inconclusive, Remarked, Hidden, Silent };

const char* name_of(Answer answer);

struct JudgedImage {
  std::string target;
  NoiseKnowledge knowledge = NoiseKnowledge::Variances;
  std::string fault;  // "" for a control image
  int seed = 0;       // of the first of the two renders that it is made from
  int second = 0;     // of the second
  Answer answer = Answer::Silent;
  std::string reason;  // of the verdict, and the remarks
};

struct SensitivitySettings {
  int renders = 2;       // of each scene, with half its samples; each two of them are a control image
  bool faults = true;    // the first control image becomes the mutants
  double spp_scale = 1;  // factor of the samples of the cases
};

/// Renders each scene of the plan by its first renderer, with seeds that no reference has, and judges the
/// control images and their mutants with the gates of the scene's first case. Fewer when the user interrupts;
/// a scene without a reference is left out. InputError when the renderer fails.
std::vector<JudgedImage> measure_sensitivity(const run::Plan& plan,
                                             const SensitivitySettings& settings,
                                             const StudyContext& context);

}  // namespace orbs::studies
