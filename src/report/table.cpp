#include "report/table.h"

#include "base/text_table.h"
#include "report/probe_hint.h"
#include "report/size_note.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace orbs::report {

namespace {

using results::Cell;
using results::RunRecord;
using results::Verdict;

std::string_view ansi_colour(Verdict verdict) {
  if (verdict == Verdict::Pass) return "\x1b[32m";
  if (verdict == Verdict::Unsupported || verdict == Verdict::Skipped) return "\x1b[2m";
  return verdict == Verdict::Inconclusive ? "\x1b[33m" : "\x1b[31m";
}

std::string painted(std::string text, Verdict verdict, const TableStyle& style) {
  return style.colour ? fmt::format("{}{}\x1b[0m", ansi_colour(verdict), text) : std::move(text);
}

std::string cell_text(const Cell& cell, const TableStyle& style) {
  return fmt::format("{:>6} {}", decibels(cell.lowest_psnr_db),
                     painted(std::string(verdict_name(cell.verdict)), cell.verdict, style));
}

std::string requirement_table(const RunRecord& run, const TableStyle& style) {
  std::vector<TableRow> rows{{"", "requirement"}};
  for (const auto& renderer : run.renderers) rows[0].push_back(fmt::format("    dB {}", renderer.name));
  for (const auto& requirement : run.requirements) {
    auto& row = rows.emplace_back(TableRow{requirement.code, requirement.title});
    for (const auto& renderer : run.renderers) {
      const auto cell = requirement.cells.find(renderer.name);
      row.push_back(cell == requirement.cells.end() ? "" : cell_text(cell->second, style));
    }
  }
  return text_table(rows);
}

std::string counts_text(const results::RendererRecord& renderer) {
  std::vector<std::string> parts;
  for (const auto verdict : results::kVerdicts)
    if (const auto count = renderer.counts.find(std::string(verdict_name(verdict)));
        count != renderer.counts.end())
      parts.push_back(fmt::format("{} {}", count->second, count->first));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string renderer_lines(const RunRecord& run) {
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
  return text_table(rows);
}

// One line for all targets of a renderer and requirement that share verdict and reason; failures come before
// unsupported targets. Skipped targets are left out: the counts of the renderers mention them.
std::string verdict_lines(const RunRecord& run, const TableStyle& style) {
  struct Remark {
    const results::TargetRecord* first;
    std::string targets;
  };
  std::vector<Remark> remarks;
  for (const auto& target : run.targets) {
    if (target.verdict == Verdict::Pass || target.verdict == Verdict::Skipped) continue;
    const auto same = std::find_if(remarks.begin(), remarks.end(), [&](const Remark& remark) {
      const auto& first = *remark.first;
      return first.renderer == target.renderer && first.requirement == target.requirement &&
             first.verdict == target.verdict && first.reason == target.reason;
    });
    if (same == remarks.end()) {
      remarks.push_back({&target, target.target});
    } else {
      same->targets += fmt::format(", {}", target.target);
    }
  }
  std::stable_partition(remarks.begin(), remarks.end(),
                        [](const Remark& remark) { return remark.first->verdict != Verdict::Unsupported; });
  std::vector<TableRow> rows;
  for (const auto& [first, targets] : remarks)
    rows.push_back({painted(std::string(verdict_name(first->verdict)), first->verdict, style),
                    first->renderer, first->requirement, targets, first->reason});
  return text_table(rows);
}

// Remarks beside the verdicts. A target that several cases use is mentioned once.
std::string remark_lines(const RunRecord& run) {
  std::set<std::pair<std::string, std::string>> told;
  std::vector<TableRow> rows;
  for (const auto& target : run.targets) {
    if (target.remarks.empty() || !told.emplace(target.renderer, target.target).second) continue;
    for (const auto& remark : target.remarks)
      rows.push_back({"remark", target.renderer, target.requirement, target.target, remark});
  }
  return text_table(rows);
}

}  // namespace

TableStyle style_for(int descriptor) {
  const char* no_colour = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool wanted = no_colour == nullptr || *no_colour == '\0';
  const bool able = ::isatty(descriptor) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
  return {wanted && able};
}

std::string decibels(const std::optional<double>& value) {
  if (!value) return "-";
  return std::isinf(*value) ? "inf" : fmt::format("{:.2f}", *value);
}

std::string summary_text(const RunRecord& run, const TableStyle& style) {
  std::string text = requirement_table(run, style);
  text += '\n';
  text += renderer_lines(run);
  for (const auto& left : run.left_out)
    text += fmt::format("{} was left out: {}\n", left.renderer, left.reason);
  for (const auto& lines : {verdict_lines(run, style), remark_lines(run), probe_hints(run), size_note(run)})
    if (!lines.empty()) text += fmt::format("\n{}", lines);
  if (run.interrupted) text += "\nThe run was interrupted; what was finished stands above.\n";
  return text;
}

}  // namespace orbs::report
