#include "report/table.h"

#include "base/terminal.h"
#include "base/text.h"
#include "base/text_table.h"
#include "history/comparison_text.h"
#include "report/hints.h"
#include "report/short_reason.h"
#include "report/undecided.h"
#include "results/state_colour.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::report {

namespace {

using results::Cell;
using results::Expectation;
using results::RunRecord;
using results::Verdict;

// Rows with the verdict's colour of some cells.
struct PaintedRows {
  std::vector<TableRow> rows;
  TableLook look;

  explicit PaintedRows(const TableStyle& style) : look{style.width, {}}, has_colour(style.colour) {}
  void add(std::string cell, Verdict verdict, Expectation expectation) {
    rows.back().push_back(std::move(cell));
    if (has_colour)
      look.colours[{rows.size() - 1, rows.back().size() - 1}] = state_colour(verdict, expectation);
  }
  std::string text() const { return text_table(rows, {}, look); }

  bool has_colour;
};

std::string cell_text(const Cell& cell) {
  auto text =
      fmt::format("{:>6} {}", decibels(cell.lowest_psnr_db), state_name(cell.verdict, cell.expectation));
  if (cell.lowest_psnr_without_noise_db)
    text += ", " + without_noise_text(*cell.lowest_psnr_without_noise_db);
  return text;
}

// As many renderers side by side as the terminal has room for, the next ones below.
std::string requirement_tables(const RunRecord& run, const TableStyle& style) {
  PaintedRows table(style);
  auto& head = table.rows.emplace_back(TableRow{"", "requirement"});
  for (const auto& renderer : run.renderers) head.push_back(fmt::format("    dB {}", renderer.name));
  for (const auto& requirement : run.requirements) {
    table.rows.push_back({requirement.code, requirement.title});
    for (const auto& renderer : run.renderers) {
      const auto cell = requirement.cells.find(renderer.name);
      if (cell == requirement.cells.end()) {
        table.rows.back().emplace_back();
      } else {
        table.add(cell_text(cell->second), cell->second.verdict, cell->second.expectation);
      }
    }
  }
  return text_tables(table.rows, 2, table.look);
}

// Requirements that are judged by the same image have the same number in the table, which looks like a
// mistake unless it is said.
std::string shared_numbers_note(const RunRecord& run) {
  std::map<std::pair<std::string, std::string>, std::set<std::string>> codes_of;  // by renderer and image
  for (const auto& requirement : run.requirements)
    for (const auto& target : run.targets) {
      const auto cell = requirement.cells.find(target.renderer);
      if (target.requirement != requirement.code || cell == requirement.cells.end()) continue;
      if (const auto psnr = psnr_db(target); psnr && cell->second.lowest_psnr_db == psnr)
        codes_of[{target.renderer, target.target}].insert(requirement.code);
    }
  std::map<std::string, std::set<std::string>> shared;  // codes by image, of all renderers
  for (const auto& [image, codes] : codes_of)
    if (codes.size() > 1) shared[image.second].insert(codes.begin(), codes.end());
  std::vector<std::string> parts;
  for (const auto& [image, codes] : shared) {
    std::vector<std::string> in_order;
    for (const auto& requirement : run.requirements)
      if (codes.contains(requirement.code)) in_order.push_back(requirement.code);
    parts.push_back(fmt::format("{} ({})", fmt::join(in_order, ", "), image));
  }
  return parts.empty() ? "" : fmt::format("Equal numbers are of one image: {}", fmt::join(parts, "; "));
}

// Below the table, since a number below the gate beside "pass" would look like a mistake.
std::string without_noise_note(const RunRecord& run) {
  for (const auto& requirement : run.requirements)
    for (const auto& [renderer, cell] : requirement.cells)
      if (cell.lowest_psnr_without_noise_db) return std::string(kWithoutNoiseRule);
  return {};
}

std::string counts_text(const results::RendererRecord& renderer) {
  std::vector<std::string> parts;
  const auto add = [&](std::string_view state) {
    if (const auto count = renderer.counts.find(std::string(state)); count != renderer.counts.end())
      parts.push_back(fmt::format("{} {}", count->second, count->first));
  };
  for (const auto verdict : results::kVerdicts) add(verdict_name(verdict));
  add(results::kKnown);
  add(results::kUnexpectedPass);
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string renderer_lines(const RunRecord& run, const TableStyle& style) {
  std::vector<TableRow> rows;
  for (const auto& renderer : run.renderers) {
    rows.push_back({renderer.name, fmt::format("declared {} \u00b7 measured{} {}", renderer.declared,
                                               run.size == "1" ? "" : " at " + run.size,
                                               renderer.measured.empty() ? "nothing" : renderer.measured)});
    rows.push_back(
        {"", fmt::format("{} \u00b7 {:.1f} s of rendering, {:.1f} s of CPU{}", counts_text(renderer),
                         renderer.wall_seconds, renderer.cpu_seconds,
                         renderer.version.empty() ? "" : fmt::format(" \u00b7 {}", renderer.version))});
  }
  return text_table(rows, {}, {style.width, {}});
}

// What several targets of a renderer have in common.
struct SharedVerdict {
  const results::TargetRecord* first;
  std::string reason;
  std::vector<std::string> requirements;
  std::vector<std::string> targets;
  std::vector<Undecided> undecided{};  // of each target, where they share why they are not decided
};

void add_new(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

// Takes the target in where all else that is shown is the same: a program that does not start, or one cause
// of many failures, is told once.
bool take_in(SharedVerdict& shared,
             const results::TargetRecord& target,
             const std::string& reason,
             const std::optional<Undecided>& undecided) {
  const auto& first = *shared.first;
  const bool has_one_cause =
      undecided && !shared.undecided.empty() && shared.undecided.front().cause == undecided->cause;
  if (first.renderer != target.renderer || first.verdict != target.verdict ||
      first.expectation != target.expectation || (!has_one_cause && shared.reason != reason))
    return false;
  // A target that several cases judge is undecided once.
  const bool is_new =
      std::find(shared.targets.begin(), shared.targets.end(), target.target) == shared.targets.end();
  if (has_one_cause && is_new) shared.undecided.push_back(*undecided);
  add_new(shared.requirements, target.requirement);
  add_new(shared.targets, target.target);
  return true;
}

// Many names would make a column that pushes the next one out of sight.
std::string names_text(const std::vector<std::string>& names, const TableStyle& style) {
  constexpr std::size_t kMost = 4;
  if (style.whole_reasons || names.size() <= kMost) return fmt::format("{}", fmt::join(names, ", "));
  const auto shown = kMost - 1;
  const std::vector first(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown));
  return fmt::format("{} and {} more", fmt::join(first, ", "), names.size() - shown);
}

// Failures come before unsupported targets. Skipped targets are left out: their number stands below.
std::string verdict_lines(const RunRecord& run, const TableStyle& style) {
  std::vector<SharedVerdict> told;
  for (const auto& target : run.targets) {
    const bool is_fine = passes(target.verdict) && target.expectation == Expectation::None;
    if (is_fine || target.verdict == Verdict::Skipped) continue;
    const auto reason = style.whole_reasons ? reason_text(target)
                                            : line_reason(target.verdict, target.expectation,
                                                          reason_text(target), style.width);
    const auto undecided = style.whole_reasons || target.verdict != Verdict::Inconclusive ||
                                   target.expectation != Expectation::None
                               ? std::nullopt
                               : undecided_of(target.reason);
    if (std::any_of(told.begin(), told.end(),
                    [&](auto& shared) { return take_in(shared, target, reason, undecided); }))
      continue;
    told.push_back({&target, reason, {target.requirement}, {target.target}});
    if (undecided) told.back().undecided = {*undecided};
  }
  for (auto& shared : told)
    if (shared.undecided.size() > 1) shared.reason = undecided_text(shared.undecided);
  std::stable_partition(told.begin(), told.end(), [](const SharedVerdict& shared) {
    return shared.first->verdict != Verdict::Unsupported;
  });
  std::stable_partition(told.begin(), told.end(), [](const SharedVerdict& shared) {
    return counts_as_failure(shared.first->verdict, shared.first->expectation);
  });
  PaintedRows table(style);
  for (const auto& [first, reason, requirements, targets, undecided] : told) {
    table.rows.emplace_back();
    table.add(std::string(state_name(*first)), first->verdict, first->expectation);
    for (auto cell : {first->renderer, names_text(requirements, style), names_text(targets, style), reason})
      table.rows.back().push_back(std::move(cell));
  }
  return table.text();
}

// Remarks beside the verdicts. A target that several cases use is mentioned once. What is said of a target
// that does not pass explains what its own line says, and is left out unless all is asked for.
std::string remark_lines(const RunRecord& run, const TableStyle& style) {
  std::set<std::pair<std::string, std::string>> told;
  std::map<std::string, std::size_t> left_out;  // remarks by renderer
  std::vector<TableRow> rows;
  for (const auto& target : run.targets) {
    if (target.remarks.empty() || !told.emplace(target.renderer, target.target).second) continue;
    if (!style.whole_reasons && !passes(target.verdict)) {
      left_out[target.renderer] += target.remarks.size();
      continue;
    }
    for (const auto& remark : target.remarks)
      rows.push_back({"remark", target.renderer, target.requirement, target.target, remark});
  }
  for (const auto& [renderer, count] : left_out)
    rows.push_back(
        {"remark", renderer, "", "", fmt::format("of targets that do not pass: {}, which -v prints", count)});
  return text_table(rows, {}, {style.width, {}});
}

std::string typical_mistake(const RunRecord& run, const std::string& case_name) {
  const auto one_case = std::find_if(run.cases.begin(), run.cases.end(),
                                     [&](const auto& one) { return one.name == case_name; });
  return one_case == run.cases.end() ? "" : one_case->typical_mistake;
}

// A fault that is told apart leads the reason of its verdict. Of what is none of the usual faults, by
// renderer: its targets, and which mistakes are typical of their cases. A failure that is known has its cause
// in its own line.
std::string diagnosis_lines(const RunRecord& run, const TableStyle& style) {
  std::map<std::string, std::vector<std::string>> unknown;
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> of_case;
  for (const auto& target : run.targets) {
    const bool is_known = target.expectation == Expectation::Known;
    if (target.diagnosis != results::kNoUsualFault || (is_known && !style.whole_reasons)) continue;
    add_new(unknown[target.renderer], target.target);
    add_new(of_case[{target.renderer, target.case_name}], target.target);
  }
  std::vector<TableRow> rows;
  for (const auto& [renderer, targets] : unknown) {
    rows.push_back({"diagnosis", renderer, names_text(targets, style), std::string(results::kNoUsualFault)});
    for (const auto& [where, of_this] : of_case)
      if (const auto mistake = typical_mistake(run, where.second);
          where.first == renderer && !mistake.empty())
        rows.push_back({"typical mistake", renderer, names_text(of_this, style), mistake});
  }
  return text_table(rows, {}, {style.width, {}});
}

// One line for each renderer: at 35 dB most images have such noise, and their records hold the numbers.
std::string hidden_lines(const RunRecord& run, const TableStyle& style) {
  std::map<std::string, std::set<std::string>> targets;
  for (const auto& target : run.targets)
    if (!target.hidden.empty()) targets[target.renderer].insert(target.target);
  std::vector<TableRow> rows;
  for (const auto& [renderer, names] : targets)
    rows.push_back({"noise", renderer,
                    fmt::format("hides errors of 2 % over 64 x 64 px or of 5 % over 16 x 16 px in {}",
                                names_text({names.begin(), names.end()}, style))});
  return text_table(rows, {}, {style.width, {}});
}

}  // namespace

TableStyle style_for(int descriptor) {
  const auto style = terminal_style(descriptor);
  return {style.colour, style.width, true};
}

std::string decibels(const std::optional<double>& value) {
  if (!value) return "-";
  return std::isinf(*value) ? "inf" : fmt::format("{:.2f}", *value);
}

std::string without_noise_text(double db) { return fmt::format("{:.1f} dB without noise", db); }

namespace {

std::string interrupt_line(const RunRecord& run) {
  const auto skipped = std::count_if(run.jobs.begin(), run.jobs.end(), [](const auto& job) {
    return job.end.outcome == results::JobOutcome::Skipped;
  });
  return fmt::format(
      "The run was interrupted: {} of {} renders were skipped; what was finished stands above.", skipped,
      run.jobs.size());
}

}  // namespace

std::string summary_text(const RunRecord& run, const TableStyle& style) {
  std::string text = requirement_tables(run, style);
  const auto add_lines = [&](const std::string& lines) {
    for (const auto& line : split(trim(lines), '\n'))
      text += fmt::format("{}\n", fmt::join(wrapped(line, static_cast<std::size_t>(style.width)), "\n"));
  };
  for (const auto& note : {without_noise_note(run), shared_numbers_note(run)})
    if (!note.empty()) add_lines(note);
  text += '\n';
  text += renderer_lines(run, style);
  for (const auto& left : run.left_out)
    add_lines(fmt::format("{} was left out: {}", left.renderer, left.reason));
  for (const auto& lines : {verdict_lines(run, style), diagnosis_lines(run, style), remark_lines(run, style),
                            hidden_lines(run, style)})
    if (!lines.empty()) text += fmt::format("\n{}", lines);
  for (const auto& lines :
       {history::variants_text(history::compare_variants(run)), probe_hints(run), explain_hint(run),
        size_note(run), results::references_note(run), run.interrupted ? interrupt_line(run) : ""}) {
    if (lines.empty()) continue;
    text += '\n';
    add_lines(lines);
  }
  return text;
}

}  // namespace orbs::report
