#include "studies/stability/report.h"

#include "base/text_table.h"
#include "results/study_kinds.h"
#include "studies/stability/numbers.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::studies {

namespace {

// Powers of two and of ten in the form that they were chosen in.
std::string magnitude_text(double magnitude, const std::string& unit) {
  const double power = std::log2(magnitude);
  const bool is_power_of_two = power == std::round(power) && std::fabs(power) >= 10;
  const auto text = is_power_of_two ? fmt::format("2^{:g}", power) : fmt::format("{:g}", magnitude);
  return unit.empty() ? text : text + " " + unit;
}

std::string cell_text(const StabilityRecord& record, const StabilityCell& cell) {
  if (cell.scenes == 0) return cell.not_applicable > 0 ? "not applicable" : "not measured";
  const auto& relation = record.relations[cell.relation];
  const auto text_of = [&](double magnitude) { return magnitude_text(magnitude, relation.unit); };
  std::string text;
  if (cell.first_break) {
    const auto& step = *cell.first_break;
    const std::string what = step.outcome == StepOutcome::NoImage ? "no image" : "breaks";
    if (!relation.is_sweep)
      text = what;
    else if (cell.held_to)
      text = fmt::format("to {}; {} at {}", text_of(*cell.held_to), what, text_of(step.magnitude));
    else
      text = fmt::format("{} at {}", what, text_of(step.magnitude));
  } else if (relation.is_sweep) {
    text = cell.held_to ? fmt::format("all, to {}", text_of(*cell.held_to)) : "";
  } else if (cell.inconclusive < cell.scenes) {
    text = "holds";
  }
  if (!text.empty() && cell.is_bit_equal) text += ", to the bit";
  if (cell.inconclusive > 0)
    text += fmt::format("{}{} inconclusive", text.empty() ? "" : "; ", cell.inconclusive);
  if (cell.not_applicable > 0)
    text += fmt::format(" ({} of {})", cell.scenes, cell.scenes + cell.not_applicable);
  return text;
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::vector<TableRow> matrix_rows(const StabilityRecord& record) {
  TableRow head{"change", "relation"};
  for (const auto& renderer : record.renderers) head.push_back(renderer.name);
  std::vector<TableRow> rows{head};
  for (const auto& relation : record.relations) rows.push_back({relation.change, relation.name});
  for (const auto& cell : stability_cells(record)) rows[cell.relation + 1].push_back(cell_text(record, cell));
  return rows;
}

std::string_view cell_colour(const StabilityCell& cell) {
  if (cell.scenes == 0) return colour::kFaint;
  if (cell.first_break) return colour::kRed;
  return cell.inconclusive < cell.scenes ? colour::kGreen : colour::kYellow;
}

// The matrix, on narrow terminals without the names of the relations, for which the changes stand.
std::string matrix_table(const StabilityRecord& record, const TerminalStyle& style) {
  auto rows = matrix_rows(record);
  std::size_t before = 2;  // columns before the renderers
  auto one = rows;
  for (auto& row : one) row.resize(std::min(row.size(), before + 1));
  if (!fits(one, style.width)) {
    for (auto& row : rows) row.erase(row.begin() + 1);
    before = 1;
  }
  CellColours colours;
  if (style.colour)
    for (const auto& cell : stability_cells(record))
      colours[{cell.relation + 1, before + cell.renderer}] = cell_colour(cell);
  return text_tables(rows, before, {style.width, colours});
}

CellColours break_colours(const std::vector<TableRow>& rows, const TerminalStyle& style) {
  constexpr std::size_t kChange = 1;
  CellColours colours;
  for (std::size_t i = 1; style.colour && i < rows.size(); ++i) colours[{i, kChange}] = colour::kRed;
  return colours;
}

std::string summaries(const StabilityRecord& record) {
  std::string text;
  for (std::size_t renderer = 0; renderer < record.renderers.size(); ++renderer)
    text += stability_summary(record, renderer) + "\n";
  return text;
}

std::string picture(const std::string& folder, const char* name, const char* what) {
  return folder.empty() ? "" : fmt::format("![{}]({}/{})", what, folder, name);
}

std::vector<TableRow> break_rows(const StabilityRecord& record, bool with_pictures) {
  std::vector<TableRow> rows{{"renderer", "change", "at", "scene", "what happens"}};
  if (with_pictures) rows.front().insert(rows.front().end(), {"original", "changed", "difference"});
  for (const auto& cell : stability_cells(record)) {
    if (!cell.first_break) continue;
    const auto& first = *cell.first_break;
    const auto& relation = record.relations[cell.relation];
    rows.push_back({cell.renderer_name, relation.change,
                    relation.is_sweep ? magnitude_text(first.magnitude, relation.unit) : "", first.scene,
                    first.reason});
    if (with_pictures)
      rows.back().insert(rows.back().end(), {picture(first.images, results::kOriginalImage, "original"),
                                             picture(first.images, results::kChangedImage, "changed"),
                                             picture(first.images, results::kDifferenceImage, "difference")});
  }
  return rows;
}

bool shows_single_pixels(const StabilityRecord& record, const StabilityStep& step) {
  return record.relations[step.relation].name == kPrecisionRelation &&
         step.outcome != StepOutcome::NotApplicable;
}

// Scenes by double precision, the most sensitive first.
std::vector<TableRow> precision_rows(const StabilityRecord& record) {
  std::vector<const StabilityStep*> steps;
  for (const auto& step : record.steps)
    if (shows_single_pixels(record, step)) steps.push_back(&step);
  std::stable_sort(steps.begin(), steps.end(),
                   [](const auto* a, const auto* b) { return a->pixels > b->pixels; });
  std::vector<TableRow> rows{{"renderer", "scene", "single pixels", "mean", "outcome"}};
  for (const auto* step : steps)
    rows.push_back({record.renderers[step->renderer].name, record.scenes[step->scene].name,
                    fmt::format("{:.2g} %", 100 * step->pixels), fmt::format("{:+.2g} %", 100 * step->mean),
                    std::string(json::to_text(step->outcome))});
  return rows;
}

constexpr std::string_view kPrecisionTitle = "Single against double precision: how far pixels differ";

std::string conditions(const StabilityRecord& record) {
  std::vector<std::string> scenes;
  std::vector<std::string> versions;
  for (const auto& scene : record.scenes) scenes.push_back(scene.name);
  for (const auto& renderer : record.renderers)
    versions.push_back(fmt::format("{}: {}", renderer.name, renderer.version));
  const auto& settings = record.settings;
  return fmt::format(
      "scenes {}; at most {} px, {} samples per pixel, {} seeds{}\n{}\n"
      "A relation breaks where the mean is off by more than {:g} %, or a block of 8 x 8 px by more than {:g} %, "
      "with a confidence of 99.99 %.\n",
      fmt::join(scenes, ", "), settings.size_px, settings.spp, settings.seeds,
      record.is_finished ? "" : "; interrupted", fmt::join(versions, "\n"), 100 * settings.mean_bound,
      100 * settings.block_bound);
}

}  // namespace

std::string break_text(const StabilityStep& step) {
  return fmt::format("the mean is off by {:+.2g} % +- {:.1g}, the block at ({}, {}) by {:+.2g} % +- {:.1g}",
                     100 * step.mean, 100 * step.mean_error, step.block_x, step.block_y, 100 * step.block,
                     100 * step.block_error);
}

std::string stability_summary(const StabilityRecord& record, std::size_t renderer) {
  int measured = 0;
  int right = 0;
  std::string ends;
  for (const auto& cell : stability_cells(record)) {
    if (cell.renderer != renderer || cell.scenes == 0) continue;
    ++measured;
    if (!cell.first_break) {
      right += cell.inconclusive < cell.scenes ? 1 : 0;
      continue;
    }
    const auto& relation = record.relations[cell.relation];
    auto shown = cell;
    shown.inconclusive = shown.not_applicable = 0;
    const auto end = cell_text(record, shown);
    ends += fmt::format(" {}: {}{} ({}).", capitalised(relation.change), cell.held_to ? "right " : "", end,
                        cell.first_break->scene);
  }
  if (measured == 0) return fmt::format("{}: nothing was measured.", record.renderers[renderer].name);
  return fmt::format("{}: {} of {} changes leave the image right.{}", record.renderers[renderer].name, right,
                     measured, ends);
}

std::string stability_table(const StabilityRecord& record, const TerminalStyle& style) {
  const auto breaks = break_rows(record, false);
  const auto precision = precision_rows(record);
  auto text = matrix_table(record, style) + '\n' + wrapped_lines(summaries(record), style.width) + '\n';
  if (breaks.size() > 1)
    text += fmt::format("First breaks\n{}\n",
                        text_table(breaks, {}, {style.width, break_colours(breaks, style)}));
  if (precision.size() > 1)
    text += fmt::format("{}\n{}\n", kPrecisionTitle, text_table(precision, {}, {style.width, {}}));
  return text + wrapped_lines(conditions(record), style.width);
}

std::string stability_markdown(const StabilityRecord& record) {
  const auto breaks = break_rows(record, true);
  const auto precision = precision_rows(record);
  return fmt::format(
      "{}\n{}{}{}\n{}", markdown_table(matrix_rows(record)), summaries(record),
      breaks.size() > 1 ? "\nFirst breaks:\n\n" + markdown_table(breaks) : "",
      precision.size() > 1 ? fmt::format("\n{}:\n\n{}", kPrecisionTitle, markdown_table(precision)) : "",
      conditions(record));
}

}  // namespace orbs::studies
