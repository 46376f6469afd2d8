#pragma once

#include "report/report_card.h"
#include "report/scene_effects.h"
#include "results/run_folder.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The data of a run for the page (format "orbs-page/2"), as records: what their fields() list is written,
/// and the page's TypeScript types are made from the same lists. The page knows no metric, map, suite or
/// verdict by name: it shows what these data list.
namespace orbs::report {

struct RunInfo {
  std::string name;
  std::string suite;
  std::string size;
  std::string started;
  double wall_seconds = 0;
  std::string orbs_version;
  std::string command;
  bool is_interrupted = false;
  bool is_finished = false;
  bool is_live = false;
  double load = 0;
  std::string references_note;  // which renderers could have read the references; "" if none could
  results::Host host;
};

template <class Visitor, json::RecordOf<RunInfo> Record>
void fields(Visitor& visit, Record& run) {
  visit("name", run.name);
  visit("suite", run.suite);
  visit("size", run.size);
  visit("started", run.started);
  visit("wall_seconds", run.wall_seconds);
  visit("orbs_version", run.orbs_version);
  visit("command", run.command);
  visit("interrupted", run.is_interrupted);
  visit("finished", run.is_finished);
  visit("live", run.is_live);
  visit("load", run.load);
  visit("references_note", run.references_note);
  visit.required("host", run.host);
}

/// What a cell of the grid may be: a verdict, or that of a render that is not done.
struct State {
  std::string_view name;
  bool is_failure = false;
};

template <class Visitor, json::RecordOf<State> Record>
void fields(Visitor& visit, Record& state) {
  visit("name", state.name);
  visit("failure", state.is_failure);
}

struct Renderer {
  std::string name;
  double wall_seconds = 0;  // sums over all its renders
  double cpu_seconds = 0;
  std::size_t peak_rss_bytes = 0;  // of the largest render
  std::optional<std::string> version, declared, measured;
};

template <class Visitor, json::RecordOf<Renderer> Record>
void fields(Visitor& visit, Record& renderer) {
  visit("name", renderer.name);
  visit("wall_seconds", renderer.wall_seconds);
  visit("cpu_seconds", renderer.cpu_seconds);
  visit("peak_rss_bytes", renderer.peak_rss_bytes);
  visit("version", renderer.version);
  visit("declared", renderer.declared);
  visit("measured", renderer.measured);
}

struct Requirement {
  std::string code;
  std::string title;
  std::string group;  // what all of its letter are about; "" in runs of before that was recorded
};

template <class Visitor, json::RecordOf<Requirement> Record>
void fields(Visitor& visit, Record& requirement) {
  visit("code", requirement.code);
  visit("title", requirement.title);
  visit("group", requirement.group);
}

struct Metric {
  std::string name;
  std::string unit;
  std::string definition;
  bool is_lower_better = false;
  bool is_signed = false;
};

template <class Visitor, json::RecordOf<Metric> Record>
void fields(Visitor& visit, Record& metric) {
  visit("name", metric.name);
  visit("unit", metric.unit);
  visit("definition", metric.definition);
  visit("lower_is_better", metric.is_lower_better);
  visit("signed", metric.is_signed);
}

/// A number of every target of the run; NaN, null in JSON, where it has none.
using Column = std::vector<double>;

/// One value per target of the run. Names are indices into the lists of the overview.
struct Cells {
  std::vector<std::size_t> cases, targets, renderers, states, declared, reasons, thumbnails;
  std::vector<std::size_t> preliminary;  // 1 where the state is the verdict of a look, and more may follow
  std::vector<std::size_t> beside_psnr;  // in `texts_beside_psnr`
  Column machine;                        // null if the times are not of a single machine
  Column wall_seconds, cpu_seconds, render_seconds, peak_rss_bytes, spp;
};

template <class Visitor, json::RecordOf<Cells> Record>
void fields(Visitor& visit, Record& cells) {
  visit("case", cells.cases);
  visit("target", cells.targets);
  visit("renderer", cells.renderers);
  visit("state", cells.states);
  visit("preliminary", cells.preliminary);
  visit("declared", cells.declared);
  visit("reason", cells.reasons);
  visit("thumbnail", cells.thumbnails);
  visit("beside_psnr", cells.beside_psnr);
  visit("machine", cells.machine);
  visit("wall_seconds", cells.wall_seconds);
  visit("cpu_seconds", cells.cpu_seconds);
  visit("render_seconds", cells.render_seconds);
  visit("peak_rss_bytes", cells.peak_rss_bytes);
  visit("spp", cells.spp);
}

/// The data of the overview and the charts, as columns instead of objects, so that the browser reads 10 000
/// cells in a few milliseconds. A number that is infinite is null in `measures`, and listed in `infinite`.
struct Overview {
  RunInfo run;
  std::vector<State> states;  // verdicts from best to worst, then those of renders that are not done
  std::vector<Renderer> renderers;
  std::vector<ReportCard> cards;
  std::vector<results::LeftOut> left_out;
  std::vector<results::CaseRecord> cases;
  std::vector<Requirement> requirements;
  std::vector<Metric> metrics;
  std::string main_metric;  // of most gates; "" if no target was measured
  std::vector<std::string> targets;
  std::vector<std::string> reasons;
  std::vector<std::string> machines;           // times of two different ones are not compared
  std::vector<std::string> texts_beside_psnr;  // "37.2 dB without noise"; the first is ""
  std::string rule_beside_psnr;                // which rule those cells passed by; "" if there are none
  Cells cells;
  std::map<std::string, Column> measures;
  std::map<std::string, std::vector<std::size_t>> infinite;
  std::vector<SceneEffects> scenes;
  std::optional<results::EffectStudyRecord> effect_study;  // that measured their costs
};

template <class Visitor, json::RecordOf<Overview> Record>
void fields(Visitor& visit, Record& overview) {
  visit("run", overview.run);
  visit("states", overview.states);
  visit("renderers", overview.renderers);
  visit("cards", overview.cards);
  visit("left_out", overview.left_out);
  visit("cases", overview.cases);
  visit("requirements", overview.requirements);
  visit("metrics", overview.metrics);
  visit("main_metric", overview.main_metric);
  visit("targets", overview.targets);
  visit("reasons", overview.reasons);
  visit("machines", overview.machines);
  visit("texts_beside_psnr", overview.texts_beside_psnr);
  visit("rule_beside_psnr", overview.rule_beside_psnr);
  visit("cells", overview.cells);
  visit("measures", overview.measures);
  visit("infinite", overview.infinite);
  visit("scenes", overview.scenes);
  visit("effect_study", overview.effect_study);
}

Overview overview_of(const results::RunView& view);

std::string overview_json(const results::RunView& view);

}  // namespace orbs::report
