#include "studies/cost/change_text.h"

#include "base/text_table.h"
#include "json/field_writer.h"
#include "json/writer.h"
#include "studies/cost/report.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

const RendererInBoth& renderer_of(const CostChanges& changes, const std::string& name) {
  return *std::find_if(changes.renderers.begin(), changes.renderers.end(),
                       [&](const RendererInBoth& one) { return one.name == name; });
}

std::string version_text(const RendererInBoth& renderer) {
  if (renderer.is_unchanged) return fmt::format("{} in both", renderer.version_after);
  const auto text = [](const std::string& version) { return version.empty() ? "?" : version.c_str(); };
  return fmt::format("{} -> {}", text(renderer.version_before), text(renderer.version_after));
}

// "0.93 times the time (0.9 to 0.96)", and that no difference is shown where the interval of the test does
// not say so.
std::string change_words(const Interval& ratio, bool is_changed) {
  return is_changed ? ratio_text(ratio) : ratio_text(ratio) + ", no change shown";
}

std::vector<TableRow> mean_rows(const CostChanges& changes, const ErrorTarget& error) {
  std::vector<TableRow> rows{
      {"", fmt::format("CPU time to {}, after / before", error_text(error)), "scenes", "version"}};
  for (const auto& mean : changes.means)
    if (mean.error == error)
      rows.push_back({mean.renderer, change_words(mean.time_ratio, mean.is_changed),
                      std::to_string(mean.scenes), version_text(renderer_of(changes, mean.renderer))});
  return rows;
}

std::vector<TableRow> scene_rows(const CostChanges& changes, const ErrorTarget& error) {
  std::vector<TableRow> rows{{"changed", "renderer", "before", "after", "after / before"}};
  for (const auto& scene : changes.scenes)
    if (scene.error == error && scene.is_changed)
      rows.push_back({scene.target, scene.renderer, fmt::format("{:.2g} s", scene.before.value),
                      fmt::format("{:.2g} s", scene.after.value), ratio_text(scene.time_ratio)});
  return rows;
}

std::string_view tone(const Interval& ratio, bool is_changed) {
  if (!is_changed) return colour::kFaint;
  return ratio.value > 1 ? colour::kRed : colour::kGreen;
}

CellColours mean_colours(const CostChanges& changes, const ErrorTarget& error, const TerminalStyle& style) {
  CellColours colours;
  std::size_t row = 1;
  for (const auto& mean : changes.means)
    if (style.colour && mean.error == error) colours[{row++, 1}] = tone(mean.time_ratio, mean.is_changed);
  return colours;
}

CellColours scene_colours(const CostChanges& changes, const ErrorTarget& error, const TerminalStyle& style) {
  CellColours colours;
  std::size_t row = 1;
  for (const auto& scene : changes.scenes)
    if (style.colour && scene.error == error && scene.is_changed)
      colours[{row++, 4}] = tone(scene.time_ratio, true);
  return colours;
}

// What the machine did, and what is left of the factors without it.
std::string unchanged_text(const CostChanges& changes, const ErrorTarget& error) {
  std::string text;
  for (const auto& mean : changes.means) {
    if (!(mean.error == error)) continue;
    if (renderer_of(changes, mean.renderer).is_unchanged)
      text += fmt::format(
          "{} is the same program in both studies and takes {} times the time: {}\n", mean.renderer,
          ratio_text(mean.time_ratio),
          mean.is_changed ? "the machine is another one than it was" : "the machine is as it was");
    if (mean.ratio_to_unchanged)
      text += fmt::format("{} over the programs that did not change: {}\n", mean.renderer,
                          ratio_text(*mean.ratio_to_unchanged));
  }
  return text;
}

std::string what_was_tested(const CostChanges& changes, const ErrorTarget& error) {
  const auto tests = std::count_if(changes.scenes.begin(), changes.scenes.end(),
                                   [&](const SceneChange& one) { return one.error == error; });
  const auto changed =
      std::count_if(changes.scenes.begin(), changes.scenes.end(),
                    [&](const SceneChange& one) { return one.error == error && one.is_changed; });
  return fmt::format(
      "{} of {} times of single scenes changed beyond chance. Of equal programs on an equal machine, 1 comparison in "
      "{:.0f} calls any time changed. Intervals hold 95 %.\n",
      changed, tests, 1 / kFalseChanges);
}

std::string notes_of(const CostChanges& changes, std::string_view mark) {
  std::string text;
  for (const auto& note : changes.notes) text += fmt::format("{}{}\n", mark, note);
  return text;
}

}  // namespace

std::string changes_text(const CostChanges& changes, const TerminalStyle& style) {
  const auto& error = changes.main_error;
  auto text = wrapped_lines(
      fmt::format("The study of {} against that of {}\n\n", changes.after, changes.before), style.width);
  text +=
      text_table(mean_rows(changes, error), {}, {style.width, mean_colours(changes, error, style)}) + '\n';
  if (const auto rows = scene_rows(changes, error); rows.size() > 1)
    text += text_table(rows, {}, {style.width, scene_colours(changes, error, style)}) + '\n';
  return text + wrapped_lines(
                    unchanged_text(changes, error) + what_was_tested(changes, error) + notes_of(changes, ""),
                    style.width);
}

std::string changes_markdown(const CostChanges& changes) {
  std::string text = fmt::format("The study of {} against that of {}\n\n", changes.after, changes.before);
  for (const auto& error : error_targets()) {
    const auto means = mean_rows(changes, error);
    if (means.size() == 1) continue;
    text += markdown_table(means) + '\n';
    if (const auto scenes = scene_rows(changes, error); scenes.size() > 1)
      text += markdown_table(scenes) + '\n';
    text += unchanged_text(changes, error) + what_was_tested(changes, error) + '\n';
  }
  return text + notes_of(changes, "- ");
}

std::string changes_json(const CostChanges& changes) {
  json::Writer out;
  out.begin_object().member("format", "orbs-cost-changes/1").member("false_alarm_rate", kFalseChanges);
  json::write_fields(out, changes);
  return out.end_object().text();
}

}  // namespace orbs::studies
