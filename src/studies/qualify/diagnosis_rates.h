#pragma once

#include "image/image.h"
#include "registry/case.h"
#include "results/record.h"
#include "run/plan/plan.h"
#include "studies/context.h"

#include <map>
#include <string>
#include <vector>

/// How often the diagnosis of a wrong image is right: typical faults are put upon control images, and what is
/// said of those that the gates refuse is counted.
namespace orbs::studies {

enum class Said { Right, Nothing, Wrong };

struct FaultDiagnosis {
  std::string target;
  std::string fault = {};     // "" for the control image itself
  std::string expected = {};  // how the right diagnosis begins; "" when nothing should be said
  std::string diagnosis = {};
  Said said = Said::Nothing;
};

struct DiagnosisSubject {
  const registry::Case& one_case;
  std::string target;
  const image::Image& reference;
  const image::Image& control;
  const std::map<std::string, image::Image>& other_targets;
};

/// The control image, and each typical fault of it that the gates refuse (one that they accept is not
/// diagnosed), but only each `step`th, from the one numbered `first`.
std::vector<FaultDiagnosis> diagnose_faults(const DiagnosisSubject& subject, int first = 0, int step = 1);

/// That of all targets of the plan, with the images of a renderer in `run` as control images. InputError
/// where an image or a reference is missing.
std::vector<FaultDiagnosis> measure_diagnoses(const run::Plan& plan,
                                              const results::RunRecord& run,
                                              const std::string& renderer,
                                              const StudyContext& context);

struct DiagnosisRates {
  int usual = 0;          // images with one of the faults that the diagnosis knows
  int right = 0;          // of these
  int others = 0;         // control images and faults that it does not know
  int wrong = 0;          // of all
  int controls = 0;       // control images
  int controls_said = 0;  // of these, those that got a diagnosis
};

DiagnosisRates rates_of(const std::vector<FaultDiagnosis>& diagnoses);

/// A table of the faults, and every wrong diagnosis.
std::string diagnoses_text(const std::vector<FaultDiagnosis>& diagnoses);

}  // namespace orbs::studies
