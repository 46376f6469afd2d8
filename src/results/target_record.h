#pragma once

#include "json/fields.h"
#include "results/verdict.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What is recorded of one judged target. Each member is also listed in the struct's fields(): see fields.h.

namespace orbs::results {

/// A number with what it means, for readers outside this program.
struct Measure {
  std::string name;  // "psnr_srgb8"
  double value = 0;  // infinite for equal images under a ratio in dB
  std::string unit;
  std::string definition;
  bool lower_is_better = false;
  bool is_signed = false;          // values nearer to zero are better
  std::optional<double> low = {};  // ends of its interval, if it has one
  std::optional<double> high = {};
  std::vector<double> where = {};  // x0, y0, x1, y1 of the pixels that it measures; empty: all
};

template <class Visitor, json::RecordOf<Measure> Record>
void fields(Visitor& visit, Record& measure) {
  visit.required("name", measure.name);
  visit.maybe_infinite("value", measure.value);
  visit("unit", measure.unit);
  visit("definition", measure.definition);
  visit("lower_is_better", measure.lower_is_better);
  visit("signed", measure.is_signed);
  visit("low", measure.low);
  visit("high", measure.high);
  visit.rectangle("where", measure.where);
}

/// An image of the error that lies beside the result.
struct MapRecord {
  std::string name;   // "l1"
  std::string image;  // EXR of the raw numbers
  std::string definition;
  bool is_signed = false;
  double scale_maximum = 1;  // upper end of its colour scale; the same for every renderer
};

template <class Visitor, json::RecordOf<MapRecord> Record>
void fields(Visitor& visit, Record& map) {
  visit.required("name", map.name);
  visit.inside_folder("image", map.image);
  visit("definition", map.definition);
  visit("signed", map.is_signed);
  visit("scale_maximum", map.scale_maximum);
}

/// A part of the image whose mean is wrong for certain.
struct WrongRegion {
  std::vector<double> where;  // x0, y0, x1, y1
  std::string seen = {};      // name of what the scene shows there; "" where it shows several things
  std::string text = {};      // "the far wall, 4 % too dark"
};

template <class Visitor, json::RecordOf<WrongRegion> Record>
void fields(Visitor& visit, Record& region) {
  visit.rectangle("where", region.where);
  visit("seen", region.seen);
  visit.required("text", region.text);
}

/// One condition that an image had to meet.
struct Check {
  std::string what;  // "psnr_srgb8", "pixel [256,220,257,221]", "path ESDL"
  bool passed = false;
  std::string reason;
  std::optional<double> min;  // limits of a condition on a number
  std::optional<double> max;
  bool measured = true;  // false: the size of the run does not allow it, and the verdict does not rest on it
  bool decided = true;   // false: noise does not let it be told whether it is met
};

template <class Visitor, json::RecordOf<Check> Record>
void fields(Visitor& visit, Record& check) {
  visit.required("what", check.what);
  visit("passed", check.passed);
  visit("measured", check.measured);
  visit("decided", check.decided);
  visit("reason", check.reason);
  visit("min", check.min);
  visit("max", check.max);
}

/// What one look of a sequential verdict saw: the gate that decided it, or that was farthest from being
/// decided.
struct LookRecord {
  int spp = 1;  // samples per pixel that were there
  Verdict verdict = Verdict::Skipped;
  std::string gate;  // "mean_ratio_g"; "" where no gate has a number
  std::optional<double> value = {};
  std::optional<double> low = {};  // ends of the interval that the decision rests on
  std::optional<double> high = {};
};

template <class Visitor, json::RecordOf<LookRecord> Record>
void fields(Visitor& visit, Record& look) {
  visit.required("spp", look.spp, {.range = {.min = 1}});
  visit.required("verdict", look.verdict);
  visit("gate", look.gate);
  visit("value", look.value);
  visit("low", look.low);
  visit("high", look.high);
}

/// What shows a diagnosis to the eye.
struct ProofRecord {
  std::string image;       // EXR in the run's folder; "" where no fault is named
  bool is_undone = false;  // the result with the fault undone; else the reference with the same fault
};

template <class Visitor, json::RecordOf<ProofRecord> Record>
void fields(Visitor& visit, Record& proof) {
  visit.inside_folder("image", proof.image);
  visit("undone", proof.is_undone);
}

/// The diagnosis of an image that no usual fault explains.
inline constexpr std::string_view kNoUsualFault = "none of the usual faults explains the error";

/// One target by one renderer, judged for one case.
struct TargetRecord {
  std::string requirement;
  std::string case_name;
  std::string target;  // a scene, or a difference of two
  std::string renderer;
  std::vector<std::string> jobs;  // ids of the renders that its image is made from
  bool declared = false;          // the renderer claims the requirement
  Verdict verdict = Verdict::Skipped;
  std::string reason;
  Expectation expectation = Expectation::None;
  std::string expected;  // why the failure is known, or what is news about it; "" if none is expected
  std::vector<Measure> measures;
  std::vector<Check> checks;
  std::vector<LookRecord> looks;           // none: its samples were fixed
  std::vector<WrongRegion> wrong_regions;  // the largest first
  std::vector<std::string> remarks;        // facts that change no verdict
  std::string diagnosis;  // which usual fault explains a failure, or that none does; "" if none was tried
  ProofRecord proof;      // of the diagnosis
  std::string hidden;     // what errors its noise hides; "" for none worth it
  std::string reference;  // absolute path
  std::map<std::string, std::string> reference_provenance;  // "program", "spp", ...
  std::string image;
  std::string reference_image;  // the copy of the reference in the run's folder; "" if there is none
  std::vector<MapRecord> maps;
};

template <class Visitor, json::RecordOf<TargetRecord> Record>
void fields(Visitor& visit, Record& target) {
  visit.required("requirement", target.requirement);
  visit.required("case", target.case_name);
  visit.required("target", target.target);
  visit.required("renderer", target.renderer);
  visit("jobs", target.jobs);
  visit("declared", target.declared);
  visit.required("verdict", target.verdict);
  visit("reason", target.reason);
  visit("expectation", target.expectation);
  visit("expected", target.expected);
  visit("measures", target.measures);
  visit("checks", target.checks);
  visit("looks", target.looks);
  visit("wrong_regions", target.wrong_regions);
  visit("remarks", target.remarks);
  visit("diagnosis", target.diagnosis);
  visit("proof", target.proof);
  visit("hidden", target.hidden);
  visit("reference", target.reference);
  visit("reference_provenance", target.reference_provenance);
  visit.inside_folder("image", target.image);
  visit.inside_folder("reference_image", target.reference_image);
  visit("maps", target.maps);
}

/// The measure of a target that is judged in looks: the PSNR that is certain of the image without its noise.
inline constexpr std::string_view kPsnrWithoutNoise = "psnr_without_noise";

inline std::optional<double> measured(const TargetRecord& target, std::string_view name) {
  for (const auto& measure : target.measures)
    if (measure.name == name) return measure.value;
  return std::nullopt;
}

/// The image's PSNR in dB, with all its noise. All that is called PSNR or stands before "dB" alone is this.
inline std::optional<double> psnr_db(const TargetRecord& target) { return measured(target, "psnr_srgb8"); }

/// The PSNR in dB that is certain without the noise, where the gate is met by it though the image's own PSNR
/// is too low. It is said beside that, never in its place. An error that cannot be told from none counts as
/// one of 99 dB, a 350th of a step of the display.
inline std::optional<double> deciding_psnr_without_noise_db(const TargetRecord& target) {
  constexpr double kMost_db = 99;
  const auto psnr = psnr_db(target);
  for (const auto& check : target.checks)
    if (check.what == "psnr_srgb8" && check.passed && check.min && psnr && *psnr < *check.min)
      return std::min(measured(target, kPsnrWithoutNoise).value_or(kMost_db), kMost_db);
  return std::nullopt;
}

/// "known", "unexpected pass", or the name of the verdict.
inline std::string_view state_name(const TargetRecord& target) {
  return state_name(target.verdict, target.expectation);
}

/// Whether the diagnosis says which fault it is.
inline bool names_a_fault(const TargetRecord& target) {
  return !target.diagnosis.empty() && target.diagnosis != kNoUsualFault;
}

/// The reason of the verdict. Where the fault is known, it comes first: "B is 41.5 % darker" is of little use
/// before "encoded for the screen (gamma 2.2), not linear".
inline std::string led_reason(const TargetRecord& target) {
  if (!names_a_fault(target)) return target.reason;
  return target.reason.empty() ? target.diagnosis : target.diagnosis + "; " + target.reason;
}

/// What is said of the target: why its failure is known or what is news about it, then the reason of its
/// verdict.
inline std::string reason_text(const TargetRecord& target) {
  const auto reason = led_reason(target);
  if (target.expected.empty() || reason.empty()) return target.expected + reason;
  return target.expected + "; " + reason;
}

}  // namespace orbs::results
