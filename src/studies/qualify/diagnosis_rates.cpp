#include "studies/qualify/diagnosis_rates.h"

#include "base/error.h"
#include "base/nth.h"
#include "base/parallel.h"
#include "base/text_table.h"
#include "faults/fault.h"
#include "judge/diagnosis.h"
#include "judge/judge.h"
#include "run/other_references.h"
#include "studies/qualify/images.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

using image::Image;

bool is_refused(const DiagnosisSubject& subject, const Image& image) {
  results::TargetRecord record;
  record.target = subject.target;
  judge::judge_image(subject.one_case, image, {"", subject.reference, ""},
                     {.measured = judge::Measured::ForTheVerdict}, record);
  return record.verdict == results::Verdict::Fail;
}

FaultDiagnosis diagnosis_of(const DiagnosisSubject& subject, const Image& image, const faults::Row* fault) {
  const auto mask = judge::mask_of(subject.one_case, subject.target);
  const auto found = judge::diagnosed({image, subject.reference, subject.other_targets, mask});
  FaultDiagnosis out{subject.target};
  if (fault != nullptr) {
    out.fault = fault->name;
    out.expected = fault->diagnosis;
  }
  if (!found) return out;
  out.diagnosis = judge::diagnosis_text(found);
  const bool is_right = !out.expected.empty() && faults::is_same_kind(found->fault, fault->fault) &&
                        found->text.starts_with(out.expected);
  out.said = is_right ? Said::Right : Said::Wrong;
  return out;
}

// The typical faults, and the images of the case's other targets.
std::vector<faults::Row> faults_of(const DiagnosisSubject& subject) {
  auto rows = faults::rows_of(faults::Use::Diagnosis, subject.reference);
  for (const auto& [name, other] : subject.other_targets)
    if (other.width == subject.reference.width && other.height == subject.reference.height) {
      const faults::OtherImage fault{name, &other};
      rows.push_back({"the image of another target", fault, {faults::Use::Diagnosis}, fault.text()});
    }
  return rows;
}

TableRow row_of(const std::string& fault, const std::string& expected, const std::array<int, 3>& counts) {
  const int all = counts[0] + counts[1] + counts[2];
  return {fault,
          expected.empty() ? "none" : expected,
          std::to_string(all),
          std::to_string(counts[0]),
          std::to_string(counts[1]),
          std::to_string(counts[2])};
}

}  // namespace

std::vector<FaultDiagnosis> diagnose_faults(const DiagnosisSubject& subject, int first, int step) {
  std::vector<FaultDiagnosis> diagnoses{diagnosis_of(subject, subject.control, nullptr)};
  const auto rows = faults_of(subject);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (static_cast<int>(i) % step != first % step) continue;
    const auto& row = rows[i];
    // A change that leaves the reference as it is is no fault of this target.
    if (image::has_same_colours(faults::applied(row, subject.reference), subject.reference)) continue;
    const auto image = faults::applied(row, subject.control);
    if (is_refused(subject, image)) diagnoses.push_back(diagnosis_of(subject, image, &row));
  }
  return diagnoses;
}

std::vector<FaultDiagnosis> measure_diagnoses(const run::Plan& plan,
                                              const results::RunRecord& run,
                                              const std::string& renderer,
                                              const StudyContext& context) {
  struct Subject {
    const registry::Case* one_case;
    std::string target;
  };
  std::vector<Subject> subjects;
  for (const auto& target : plan.targets) {
    const auto is_known = [&](const auto& one) { return one.target == target.target; };
    if (target.renderer == 0 && target.unsupported.empty() &&
        std::none_of(subjects.begin(), subjects.end(), is_known))
      subjects.push_back({&plan.cases[target.one_case], target.target});
  }
  std::vector<std::vector<FaultDiagnosis>> found(subjects.size());
  for_each_index(static_cast<int>(subjects.size()), plan.threads, [&](int index) {
    if (is_stopped(context)) return;
    const auto& [one_case, target] = nth(subjects, index);
    const auto reference =
        judge::load_reference(*one_case, target, plan.suite.references, plan.reference_hashes, {},
                              registry::reduced_size(plan.settings));
    if (!reference.image) throw InputError(reference.problem);
    const auto control = control_image(run, renderer, one_case->name, target);
    nth(found, index) = diagnose_faults(
        {*one_case, target, *reference.image, control, run::other_references(plan, *one_case, target, {})});
  });
  std::vector<FaultDiagnosis> all;
  for (const auto& one : found) all.insert(all.end(), one.begin(), one.end());
  return all;
}

DiagnosisRates rates_of(const std::vector<FaultDiagnosis>& diagnoses) {
  DiagnosisRates rates;
  for (const auto& one : diagnoses) {
    ++(one.expected.empty() ? rates.others : rates.usual);
    if (one.said == Said::Right) ++rates.right;
    if (one.said == Said::Wrong) ++rates.wrong;
    if (!one.fault.empty()) continue;
    ++rates.controls;
    if (one.said != Said::Nothing) ++rates.controls_said;
  }
  return rates;
}

std::string diagnoses_text(const std::vector<FaultDiagnosis>& diagnoses) {
  std::vector<std::pair<std::string, std::string>> order;  // fault, expected
  std::map<std::string, std::array<int, 3>> counts;
  std::string wrong;
  for (const auto& one : diagnoses) {
    if (!counts.contains(one.fault))
      order.emplace_back(one.fault, one.expected.starts_with("the image of") ? "the image of" : one.expected);
    ++counts[one.fault].at(static_cast<std::size_t>(one.said));
    if (one.said == Said::Wrong)
      wrong += fmt::format("{}: '{}' was called: {}\n", one.target,
                           one.fault.empty() ? "(control image)" : one.fault, one.diagnosis);
  }
  std::vector<TableRow> rows{{"fault", "right is", "images", "right", "nothing", "wrong"}};
  for (const auto& [fault, expected] : order)
    rows.push_back(row_of(fault.empty() ? "(control image)" : fault, expected, counts.at(fault)));
  const auto rates = rates_of(diagnoses);
  constexpr auto kRight = Align::Right;
  return text_table(rows, {Align::Left, Align::Left, kRight, kRight, kRight, kRight}) +
         fmt::format(
             "\n{}{} of {} usual faults are named, {} of {} diagnoses are wrong, {} of {} control images "
             "got one\n",
             wrong, rates.right, rates.usual, rates.wrong, diagnoses.size(), rates.controls_said,
             rates.controls);
}

}  // namespace orbs::studies
