#pragma once

#include "image/image.h"
#include "judge/candidate_faults.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// What kind of mistake makes a wrong image: which of the usual faults explains it.
namespace orbs::judge {

struct Diagnosis {
  faults::Fault fault;
  std::string text;    // "shifted by (2, 1) px"
  double psnr_db = 0;  // psnr_srgb8 once the fault is undone, or against the reference with the same fault
  double share = 0;    // of the error, what the fault explains: at least 0.9
  /// The result with the fault undone, to be compared with the reference; where a fault cannot be undone, the
  /// reference with it, to be compared with the result. R, G, B.
  image::Image proof = {};
  bool is_undone = false;
};

/// The one fault that explains the difference, or nothing.
///
/// With D the mean squared error (of fault_fit.h) that a fault takes away and U what of the rest is no noise,
/// it is said where
/// - D / (D + U) >= 0.9: it explains most of what is no noise;
/// - D is at least six standard errors, and twice what the doubt about U may hide: it is no chance;
/// - the best fault of each other kind leaves more: at least D / 50, U and four standard errors more.
///
/// Both images have R, G, B without NaN or infinite values and the same size; the mask leaves pixels.
std::optional<Diagnosis> diagnosed(const FaultSubject& subject);

/// As a verdict says it: "shifted by (2, 1) px: then 60.2 dB", or that it is none of these.
std::string diagnosis_text(const std::optional<Diagnosis>& diagnosis);

}  // namespace orbs::judge
