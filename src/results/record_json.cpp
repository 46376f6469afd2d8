#include "results/record_json.h"

#include <cmath>

namespace orbs::results {

namespace {

using json::Writer;

void write_optional(Writer& out, std::string_view key, const std::optional<double>& value) {
  out.key(key);
  value ? out.value(*value) : out.null();
}

void write_texts(Writer& out, std::string_view key, const std::map<std::string, std::string>& texts) {
  out.key(key).begin_object();
  for (const auto& [name, text] : texts) out.member(name, text);
  out.end_object();
}

void write_job(Writer& out, const JobRecord& job) {
  out.member("id", job.id).member("suite", job.suite).member("scene", job.scene);
  out.member("renderer", job.renderer).member("renderer_version", job.renderer_version);
  out.member("argv", job.argv).member("command", job.command).member("folder", job.folder);
  out.member("scene_hash", job.scene_hash).member("settings_hash", job.settings_hash);
  out.member("limits_hash", job.limits_hash);
  out.member("judged_hash", job.judged_hash).member("native_scene", job.native_scene);
  out.member("spp", job.spp)
      .member("seed", job.seed)
      .member("seeds", job.seeds)
      .member("threads", job.threads);
  out.member("started", job.started).member("load", job.load);
  out.member("wall_seconds", job.wall_seconds).member("cpu_seconds", job.cpu_seconds);
  write_optional(out, "render_seconds", job.render_seconds);
  out.member("peak_rss_bytes", static_cast<unsigned long long>(job.peak_rss_bytes));
  out.member("exit_code", job.exit_code).member("signal", job.signal);
  out.member("core_dumped", job.core_dumped);
  out.member("rendered", job.rendered);
  // A usable image is no verdict about it: that stands with the images.
  out.member("outcome", job.rendered ? std::string_view("rendered") : verdict_name(job.verdict));
  out.member("reason", job.reason).member("image", job.image).member("log", job.log);
}

void write_check(Writer& out, const Check& check) {
  out.begin_object().member("what", check.what).member("passed", check.passed);
  out.member("reason", check.reason);
  if (check.min) out.member("min", *check.min);
  if (check.max) out.member("max", *check.max);
  out.end_object();
}

void write_map(Writer& out, const MapRecord& map) {
  out.begin_object().member("name", map.name).member("image", map.image);
  out.member("definition", map.definition).member("is_signed", map.is_signed);
  out.member("scale_maximum", map.scale_maximum).end_object();
}

void write_target(Writer& out, const TargetRecord& target) {
  out.begin_object().member("requirement", target.requirement).member("case", target.case_name);
  out.member("target", target.target).member("renderer", target.renderer).member("declared", target.declared);
  out.member("verdict", verdict_name(target.verdict)).member("reason", target.reason);
  out.key("measures").begin_array();
  for (const auto& measure : target.measures) write_measure(out, measure);
  out.end_array().key("checks").begin_array();
  for (const auto& check : target.checks) write_check(out, check);
  out.end_array().member("remarks", target.remarks);
  out.member("jobs", target.jobs).member("image", target.image).key("maps").begin_array();
  for (const auto& map : target.maps) write_map(out, map);
  out.end_array().member("reference", target.reference).member("reference_image", target.reference_image);
  write_texts(out, "reference_provenance", target.reference_provenance);
  out.end_object();
}

void write_requirement(Writer& out, const RequirementRecord& requirement) {
  out.begin_object().member("code", requirement.code).member("title", requirement.title);
  out.key("renderers").begin_object();
  for (const auto& [renderer, cell] : requirement.cells) {
    out.key(renderer)
        .begin_object()
        .member("declared", cell.declared)
        .member("verdict", verdict_name(cell.verdict));
    write_optional(out, "lowest_psnr_db", cell.lowest_psnr_db);
    if (cell.lowest_psnr_db && std::isinf(*cell.lowest_psnr_db)) out.member("infinite", true);
    out.member("reason", cell.reason).end_object();
  }
  out.end_object().end_object();
}

void write_case(Writer& out, const CaseRecord& one_case) {
  out.begin_object().member("suite", one_case.suite).member("name", one_case.name);
  out.member("requirement", one_case.requirement).member("title", one_case.title);
  out.member("tests", one_case.tests).member("typical_mistake", one_case.typical_mistake);
  out.member("smallest_error_seen", one_case.smallest_error_seen).end_object();
}

void write_effects(Writer& out, std::string_view key, const std::vector<EffectRecord>& effects) {
  out.key(key).begin_array();
  for (const auto& effect : effects)
    out.begin_object()
        .member("effect", effect.effect)
        .member("thing", effect.thing)
        .member("reason", effect.reason)
        .end_object();
  out.end_array();
}

}  // namespace

void write_scene(Writer& out, const SceneRecord& scene) {
  out.begin_object().member("name", scene.name).member("transport", scene.transport);
  write_effects(out, "called_for", scene.called_for);
  write_effects(out, "not_called_for", scene.not_called_for);
  out.key("effect_costs").begin_array();
  for (const auto& cost : scene.effect_costs)
    out.begin_object()
        .member("name", cost.name)
        .member("time_ratio", cost.time_ratio)
        .member("error_ratio", cost.error_ratio)
        .member("change", cost.change)
        .end_object();
  out.end_array().end_object();
}

namespace {

void write_renderer(Writer& out, const RendererRecord& renderer) {
  out.begin_object().member("name", renderer.name).member("version", renderer.version);
  out.member("executable", renderer.executable);
  out.member("declared", renderer.declared).member("measured", renderer.measured);
  out.key("requirements_by_verdict").begin_object();
  for (const auto& [verdict, count] : renderer.counts) out.member(verdict, count);
  out.end_object();
  out.member("wall_seconds", renderer.wall_seconds).member("cpu_seconds", renderer.cpu_seconds).end_object();
}

template <typename Items, typename Write>
void write_array(Writer& out, std::string_view key, const Items& items, Write&& write) {
  out.key(key).begin_array();
  for (const auto& item : items) write(out, item);
  out.end_array();
}

}  // namespace

void write_measure(Writer& out, const Measure& measure) {
  out.begin_object().member("name", measure.name).member("value", measure.value);
  if (std::isinf(measure.value)) out.member("infinite", true);
  out.member("unit", measure.unit).member("definition", measure.definition);
  out.member("lower_is_better", measure.lower_is_better);
  if (measure.is_signed) out.member("signed", true);
  if (measure.low) out.member("low", *measure.low);
  if (measure.high) out.member("high", *measure.high);
  if (!measure.where.empty()) out.key("where").numbers(measure.where);
  out.end_object();
}

void write_host(Writer& out, const Host& host) {
  out.begin_object().member("name", host.name).member("cpu", host.cpu).member("cores", host.cores);
  out.member("governor", host.governor);
  out.member("memory_bytes", static_cast<unsigned long long>(host.memory_bytes));
  out.member("system", host.system).member("distribution", host.distribution);
  out.member("compiler", host.compiler);
  write_optional(out, "cpu_limit", host.cpu_limit);
  out.key("memory_limit_bytes");
  host.memory_limit_bytes ? out.value(static_cast<unsigned long long>(*host.memory_limit_bytes)) : out.null();
  out.end_object();
}

std::string scenes_json(const std::vector<SceneRecord>& scenes) {
  Writer out;
  out.begin_object().member("format", "orbs-plan/1");
  write_array(out, "scenes", scenes, write_scene);
  return out.end_object().text();
}

std::string job_json(const JobRecord& job, const std::vector<TargetRecord>& targets) {
  Writer out;
  out.begin_object().member("format", "orbs-job/1");
  write_job(out, job);
  out.key("host");
  write_host(out, job.host);
  write_array(out, "targets", targets, write_target);
  return out.end_object().text();
}

std::string run_json(const RunRecord& run) {
  Writer out;
  out.begin_object().member("format", "orbs-results/1").member("suite", run.suite);
  out.member("orbs_version", run.orbs_version).member("command_line", run.command_line);
  out.member("started", run.started)
      .member("load", run.load)
      .member("wall_seconds", run.wall_seconds)
      .member("interrupted", run.interrupted);
  out.member("exit_status", exit_status(run)).member("finished", run.finished);
  out.key("host");
  write_host(out, run.host);
  write_array(out, "cases", run.cases, write_case);
  write_array(out, "scenes", run.scenes, write_scene);
  write_array(out, "renderers", run.renderers, write_renderer);
  write_array(out, "left_out", run.left_out, [](Writer& w, const LeftOut& left) {
    w.begin_object().member("renderer", left.renderer).member("reason", left.reason).end_object();
  });
  write_array(out, "requirements", run.requirements, write_requirement);
  write_array(out, "targets", run.targets, write_target);
  write_array(out, "jobs", run.jobs, [&](Writer& w, const JobRecord& job) {
    w.begin_object();
    write_job(w, job);
    if (!job.started.empty() && job.host != run.host) {
      w.key("host");
      write_host(w, job.host);
    }
    w.end_object();
  });
  return out.end_object().text();
}

}  // namespace orbs::results
