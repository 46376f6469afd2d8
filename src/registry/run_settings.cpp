#include "registry/run_settings.h"

#include "registry/image_size.h"

namespace orbs::registry {

namespace {

constexpr int kMostJobs = 1024;

}  // namespace

RunSettings read_run_settings(json::ObjectReader in) {
  RunSettings s;
  s.suite = in.text_or("suite", s.suite);
  s.cases = in.text_or("case", s.cases);
  s.scenes = in.text_or("scene", s.scenes);
  s.requirements = in.text_or("requirement", s.requirements);
  s.renderers = in.text_or("renderer", s.renderers);
  s.executable = in.text_or("exec", s.executable);
  s.output = in.text_or("output", s.output);
  s.jobs = in.integer_or("jobs", s.jobs, 1, kMostJobs);
  s.threads = in.integer_or("threads", s.threads, 0, kMostJobs);
  s.seed = in.integer_or("seed", s.seed, 0, kLargestSeed);
  s.spp_scale = in.number_or("spp_scale", s.spp_scale, json::kPositive);
  s.size_divisor = size_divisor(in.one_of_or("size", size_text(s.size_divisor), {"1", "1/2", "1/4", "1/8"}));
  s.log = in.boolean_or("log", s.log);
  s.sandbox = in.boolean_or("sandbox", s.sandbox);
  s.dry_run = in.boolean_or("dry_run", s.dry_run);
  s.view = in.boolean_or("view", s.view);
  in.finish();
  return s;
}

void write_run_settings(json::Writer& out, const RunSettings& s) {
  out.begin_object().member("suite", s.suite).member("case", s.cases).member("scene", s.scenes);
  out.member("requirement", s.requirements).member("renderer", s.renderers).member("exec", s.executable);
  out.member("output", s.output).member("jobs", s.jobs).member("threads", s.threads);
  out.member("seed", s.seed).member("spp_scale", s.spp_scale);
  out.member("size", size_text(s.size_divisor)).member("log", s.log).member("sandbox", s.sandbox);
  out.member("dry_run", s.dry_run).member("view", s.view).end_object();
}

}  // namespace orbs::registry
