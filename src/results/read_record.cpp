#include "results/read_record.h"

#include "json/object_reader.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace orbs::results {

namespace {

using json::ObjectReader;

std::optional<double> optional_number(ObjectReader& in, const std::string& key) {
  if (!in.has(key) || !in.holds_number(key)) return std::nullopt;
  return in.number(key);
}

// Written as null with "infinite" beside it when it is infinite; null alone is NaN.
double number_or_infinite(ObjectReader& in, const std::string& key) {
  if (const auto value = optional_number(in, key)) return *value;
  return in.boolean_or("infinite", false) ? std::numeric_limits<double>::infinity()
                                          : std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::string> texts_or_none(ObjectReader& in, const std::string& key) {
  return in.has(key) ? in.texts(key) : std::vector<std::string>{};
}

std::map<std::string, std::string> read_texts(ObjectReader& in, const std::string& key) {
  std::map<std::string, std::string> texts;
  if (!in.has(key)) return texts;
  auto object = in.object(key);
  for (const auto& name : object.keys()) texts[name] = object.text(name);
  return texts;
}

Verdict read_verdict(ObjectReader& in, const std::string& key) {
  const auto name = in.text(key);
  const auto verdict = verdict_named(name);
  if (!verdict) in.fail(key, fmt::format("'{}' is no verdict that this version of orbs knows", name));
  return *verdict;
}

constexpr int kAnyInteger = std::numeric_limits<int>::max();

Host read_host(ObjectReader in) {
  Host host;
  host.name = in.text_or("name", "");
  host.cpu = in.text_or("cpu", "");
  host.cores = in.integer_or("cores", 0, 0, kAnyInteger);
  host.governor = in.text_or("governor", "");
  host.memory_bytes = static_cast<std::size_t>(in.number_or("memory_bytes", 0, json::kNotNegative));
  host.system = in.text_or("system", "");
  host.distribution = in.text_or("distribution", "");
  host.compiler = in.text_or("compiler", "");
  host.cpu_limit = optional_number(in, "cpu_limit");
  if (in.has("memory_limit_bytes") && in.holds_number("memory_limit_bytes"))
    host.memory_limit_bytes = static_cast<std::size_t>(in.number("memory_limit_bytes", json::kNotNegative));
  return host;
}

// `usual`: its host where it says none.
JobRecord read_job(ObjectReader& in, const Host& usual) {
  JobRecord job;
  job.id = in.text("id");
  job.suite = in.text_or("suite", "");
  job.scene = in.text("scene");
  job.renderer = in.text("renderer");
  job.renderer_version = in.text_or("renderer_version", "");
  job.argv = texts_or_none(in, "argv");
  job.command = in.text_or("command", "");
  job.folder = in.text_or("folder", "");
  job.scene_hash = in.text_or("scene_hash", "");
  job.settings_hash = in.text_or("settings_hash", "");
  job.limits_hash = in.text_or("limits_hash", "");
  job.judged_hash = in.text_or("judged_hash", "");
  job.native_scene = in.text_or("native_scene", "");
  job.spp = in.integer_or("spp", 0, 0, kAnyInteger);
  job.seed = in.integer_or("seed", 0, -kAnyInteger, kAnyInteger);
  job.seeds = in.integer_or("seeds", 1, 1, kAnyInteger);
  job.threads = in.integer_or("threads", 0, 0, kAnyInteger);
  job.host = in.has("host") ? read_host(in.object("host")) : usual;
  job.started = in.text_or("started", "");
  job.load = in.number_or("load", 0);
  job.wall_seconds = in.number_or("wall_seconds", 0);
  job.cpu_seconds = in.number_or("cpu_seconds", 0);
  job.render_seconds = optional_number(in, "render_seconds");
  job.peak_rss_bytes = static_cast<std::size_t>(in.number_or("peak_rss_bytes", 0, json::kNotNegative));
  job.exit_code = in.integer_or("exit_code", 0, -kAnyInteger, kAnyInteger);
  job.signal = in.text_or("signal", "");
  job.core_dumped = in.boolean_or("core_dumped", false);
  job.rendered = in.boolean_or("rendered", false);
  job.verdict = job.rendered ? Verdict::Pass : read_verdict(in, "outcome");
  job.reason = in.text_or("reason", "");
  job.image = in.text_or("image", "");
  job.log = in.text_or("log", "");
  return job;
}

Measure read_measure(ObjectReader& in) {
  Measure measure{in.text("name"),
                  number_or_infinite(in, "value"),
                  in.text_or("unit", ""),
                  in.text_or("definition", ""),
                  in.boolean_or("lower_is_better", false),
                  in.boolean_or("signed", false),
                  optional_number(in, "low"),
                  optional_number(in, "high"),
                  {}};
  if (in.has("where")) measure.where = in.numbers("where", 4);
  return measure;
}

Check read_check(ObjectReader& in) {
  return {in.text("what"), in.boolean_or("passed", false), in.text_or("reason", ""),
          optional_number(in, "min"), optional_number(in, "max")};
}

MapRecord read_map(ObjectReader& in) {
  return {in.text("name"), in.text("image"), in.text_or("definition", ""), in.boolean_or("is_signed", false),
          in.number_or("scale_maximum", 1, json::kNotNegative)};
}

TargetRecord read_target(ObjectReader& in) {
  TargetRecord target;
  target.requirement = in.text("requirement");
  target.case_name = in.text("case");
  target.target = in.text("target");
  target.renderer = in.text("renderer");
  target.jobs = texts_or_none(in, "jobs");
  target.declared = in.boolean_or("declared", false);
  target.verdict = read_verdict(in, "verdict");
  target.reason = in.text_or("reason", "");
  for (auto& measure : in.objects_or_none("measures")) target.measures.push_back(read_measure(measure));
  for (auto& check : in.objects_or_none("checks")) target.checks.push_back(read_check(check));
  target.remarks = texts_or_none(in, "remarks");
  for (auto& map : in.objects_or_none("maps")) target.maps.push_back(read_map(map));
  target.reference = in.text_or("reference", "");
  target.reference_provenance = read_texts(in, "reference_provenance");
  target.image = in.text_or("image", "");
  target.reference_image = in.text_or("reference_image", "");
  return target;
}

CaseRecord read_case(ObjectReader& in) {
  return {in.text_or("suite", ""),
          in.text("name"),
          in.text_or("requirement", ""),
          in.text_or("title", ""),
          in.text_or("tests", ""),
          in.text_or("typical_mistake", ""),
          in.text_or("smallest_error_seen", "")};
}

std::vector<EffectRecord> read_effects(ObjectReader& in, const std::string& key) {
  std::vector<EffectRecord> effects;
  for (auto& effect : in.objects_or_none(key))
    effects.push_back({effect.text("effect"), effect.text_or("thing", ""), effect.text_or("reason", "")});
  return effects;
}

SceneRecord read_scene(ObjectReader& in) {
  SceneRecord scene{in.text("name"), in.text_or("transport", ""), read_effects(in, "called_for"),
                    read_effects(in, "not_called_for")};
  for (auto& cost : in.objects_or_none("effect_costs"))
    scene.effect_costs.push_back({cost.text("name"), cost.number("time_ratio"), cost.number("error_ratio"),
                                  cost.text_or("change", "")});
  return scene;
}

RequirementRecord read_requirement(ObjectReader& in) {
  RequirementRecord requirement{in.text("code"), in.text_or("title", ""), {}};
  if (!in.has("renderers")) return requirement;
  auto cells = in.object("renderers");
  for (const auto& renderer : cells.keys()) {
    auto cell = cells.object(renderer);
    auto lowest = optional_number(cell, "lowest_psnr_db");
    if (cell.boolean_or("infinite", false)) lowest = std::numeric_limits<double>::infinity();
    requirement.cells[renderer] = {cell.boolean_or("declared", false), read_verdict(cell, "verdict"), lowest,
                                   cell.text_or("reason", "")};
  }
  return requirement;
}

RendererRecord read_renderer(ObjectReader& in) {
  RendererRecord renderer;
  renderer.name = in.text("name");
  renderer.version = in.text_or("version", "");
  renderer.executable = in.text_or("executable", "");
  renderer.declared = in.text_or("declared", "");
  renderer.measured = in.text_or("measured", "");
  if (in.has("requirements_by_verdict")) {
    auto counts = in.object("requirements_by_verdict");
    for (const auto& verdict : counts.keys())
      renderer.counts[verdict] = counts.integer(verdict, 0, kAnyInteger);
  }
  renderer.wall_seconds = in.number_or("wall_seconds", 0);
  renderer.cpu_seconds = in.number_or("cpu_seconds", 0);
  return renderer;
}

void check_format(ObjectReader& in, const std::string& expected) {
  if (const auto format = in.text("format"); format != expected)
    in.fail("format",
            fmt::format("'{}' is not '{}'; was it written by another version of orbs?", format, expected));
}

}  // namespace

JobFile read_job_file(const std::filesystem::path& file) {
  const auto document = json::parse_file(file);
  ObjectReader in(document);
  check_format(in, "orbs-job/1");
  JobFile content{read_job(in, {}), {}};
  for (auto& target : in.objects_or_none("targets")) content.targets.push_back(read_target(target));
  return content;
}

RunRecord read_results_file(const std::filesystem::path& file) {
  const auto document = json::parse_file(file);
  ObjectReader in(document);
  check_format(in, "orbs-results/1");
  RunRecord run;
  run.suite = in.text_or("suite", "");
  run.folder = std::filesystem::absolute(file).parent_path().string();
  run.orbs_version = in.text_or("orbs_version", "");
  run.command_line = texts_or_none(in, "command_line");
  run.started = in.text_or("started", "");
  run.load = in.number_or("load", 0);
  run.wall_seconds = in.number_or("wall_seconds", 0);
  run.interrupted = in.boolean_or("interrupted", false);
  run.finished = in.boolean_or("finished", true);
  if (in.has("host")) run.host = read_host(in.object("host"));
  for (auto& one_case : in.objects_or_none("cases")) run.cases.push_back(read_case(one_case));
  for (auto& scene : in.objects_or_none("scenes")) run.scenes.push_back(read_scene(scene));
  for (auto& renderer : in.objects_or_none("renderers")) run.renderers.push_back(read_renderer(renderer));
  for (auto& left : in.objects_or_none("left_out"))
    run.left_out.push_back({left.text("renderer"), left.text_or("reason", "")});
  for (auto& requirement : in.objects_or_none("requirements"))
    run.requirements.push_back(read_requirement(requirement));
  for (auto& target : in.objects_or_none("targets")) run.targets.push_back(read_target(target));
  for (auto& job : in.objects_or_none("jobs")) run.jobs.push_back(read_job(job, run.host));
  return run;
}

}  // namespace orbs::results
