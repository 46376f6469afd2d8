#include "studies/effects/report.h"

#include "base/text_table.h"
#include "json/field_writer.h"
#include "json/writer.h"
#include "studies/cost/other_load.h"
#include "studies/effects/self_check.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::studies {

namespace {

// As many decimals as two digits of the error need.
std::string percent(const MeanOfRounds& m) {
  const double error = 100 * m.standard_error;
  const int decimals = error > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 6) : 3;
  return fmt::format("{:+.{}f} ± {:.{}f} %", 100 * m.value, decimals, error, decimals);
}

// Says that the image is the same, or what is lost.
std::string image_text(const Alternative& alternative) {
  const auto& change = alternative.change;
  if (change.is_equal) return "same to the bit";
  if (!change.is_comparable) return "not compared: one of both traces light paths";
  if (change.bias.empty()) return "same but for noise";
  return fmt::format("{}mean {}, most {} at ({}, {})", alternative.is_enough ? "DIFFERS: " : "",
                     percent(change.mean), percent(change.largest), change.x, change.y);
}

std::string ratio_text(double ratio) { return ratio > 0 ? fmt::format("{:.2f}", ratio) : "-"; }

std::string spread_text(const Spread& ratio) {
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", ratio.median, ratio.least, ratio.most);
}

// The line that the table and the Markdown end with.
std::string check_text(const EffectCosts& list) {
  const auto study = study_record(list);
  std::string text = fmt::format(
      "other work on the machine: load {:.2f} at the start and {:.2f} at the end; others took more than {:g} % "
      "of it in {} of {} renders, after {} repeats\n",
      list.load, list.load_end, 100 * kMostOtherShare, list.other_load.disturbed, list.other_load.renders,
      list.other_load.repeats);
  if (study.self_ratio)
    text += fmt::format(
        "the same scene twice (A/A): time ratio {:.3f} (95 %: {:.3f} to {:.3f}) over {} scenes, of which {} "
        "alone show a difference; chance is 1 in 20\n",
        *study.self_ratio, study.self_low.value_or(0), study.self_high.value_or(0), *study.self_scenes,
        *study.self_differing);
  return text;
}

void put(json::Writer& out, const char* name, const MeanOfRounds& m) {
  out.key(name)
      .begin_object()
      .member("value", m.value)
      .member("standard_error", m.standard_error)
      .end_object();
}

void put(json::Writer& out, const Alternative& alternative) {
  const auto& change = alternative.change;
  out.begin_object().member("name", alternative.name).member("is_enough", alternative.is_enough);
  write_spread(out, "time_ratio", alternative.time_ratio);
  if (alternative.time_interval)
    out.key("time_interval")
        .begin_object()
        .member("low", alternative.time_interval->low)
        .member("high", alternative.time_interval->high)
        .end_object();
  out.member("error_ratio", alternative.error_ratio)
      .member("is_equal", change.is_equal)
      .member("change", image_text(alternative));
  put(out, "mean_change", change.mean);
  put(out, "largest_change", change.largest);
  out.member("largest_x", change.x)
      .member("largest_y", change.y)
      .member("bias", change.bias)
      .member("is_comparable", change.is_comparable)
      .end_object();
}

void put_definitions(json::Writer& out) {
  out.key("definitions")
      .begin_object()
      .member("time_ratio",
              "CPU time of the samples over that of the same samples with the usual transport; "
              "median, least and most of the rounds")
      .member("time_interval", "95 % around the geometric mean of the rounds' time ratios, by their scatter")
      .member("again", "the scene rendered once more in each round in the same way: A/A")
      .member("error_ratio",
              "median time ratio times the ratio of the mean variances in linear Rec.709: the cost "
              "of equal noise; 0 if unknown: no noise, or one of both traces light paths")
      .member("mean_change",
              "difference of the mean Rec.709 luminances over the mean of the image that the scene calls "
              "for; same random numbers, standard error over the rounds")
      .member("largest_change", "the same of the block of 8 x 8 px where it is largest")
      .member("bias", "what differs by more than noise: means, blocks and squares as orbs compare tests them")
      .end_object();
}

}  // namespace

std::string effect_cost_table(const EffectCosts& list, int width) {
  std::string text;
  for (const auto& scene : list.scenes) {
    text += fmt::format("{}{}: {}, {:.2f} million paths per CPU second{}\n", text.empty() ? "" : "\n",
                        scene.scene, scene.transport, scene.paths_per_cpu_second / 1e6,
                        scene.effects.empty() ? "" : fmt::format("; {}", fmt::join(scene.effects, ", ")));
    std::vector<TableRow> rows{{"  alternative", "time ratio (rounds)", "to equal noise", "image"}};
    for (const auto& alternative : scene.alternatives)
      rows.push_back({fmt::format("  {}", alternative.name), spread_text(alternative.time_ratio),
                      ratio_text(alternative.error_ratio), image_text(alternative)});
    text += text_table(rows, {Align::Left, Align::Right, Align::Right}, {width, {}});
  }
  return text.empty() ? text : text + "\n" + check_text(list);
}

std::string effect_cost_markdown(const EffectCosts& list) {
  std::string text =
      "| scene | calls for | alternative | time | to equal noise | image |\n|---|---|---|---|---|---|\n";
  for (const auto& scene : list.scenes)
    for (const auto& alternative : scene.alternatives)
      text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", scene.scene, scene.transport, alternative.name,
                          spread_text(alternative.time_ratio), ratio_text(alternative.error_ratio),
                          image_text(alternative));
  return text;
}

std::string effect_cost_json(const EffectCosts& list) {
  json::Writer out;
  out.begin_object()
      .member("format", "orbs-effect-cost/1")
      .member("orbs_version", list.orbs_version)
      .member("suite", list.suite)
      .member("started", list.started)
      .member("load", list.load)
      .member("rounds", list.settings.rounds)
      .member("spp", list.settings.spp)
      .member("size_px", list.settings.size_px);
  auto host = list.host;
  host.name.clear();  // published with the suite, whose readers need the kind of machine alone
  out.key("host");
  json::write_record(out, host);
  out.key("study");
  json::write_record(out, study_record(list));
  out.key("scenes").begin_array();
  for (const auto& scene : list.scenes) {
    out.begin_object()
        .member("scene", scene.scene)
        .member("transport", scene.transport)
        .member("effects", scene.effects)
        .member("paths_per_cpu_second", scene.paths_per_cpu_second);
    out.key("alternatives").begin_array();
    for (const auto& alternative : scene.alternatives) put(out, alternative);
    out.end_array();
    if (scene.again) {
      out.key("again");
      put(out, *scene.again);
    }
    out.end_object();
  }
  out.end_array();
  put_definitions(out);
  return out.end_object().text();
}

}  // namespace orbs::studies
