#include "registry/defaults.h"

namespace orbs::registry {

namespace {

constexpr int kMostJobs = 1024;

}  // namespace

Defaults read_defaults(json::ObjectReader in) {
  Defaults d;
  d.suite = in.text_or("suite", d.suite);
  d.cases = in.text_or("case", d.cases);
  d.scenes = in.text_or("scene", d.scenes);
  d.requirements = in.text_or("requirement", d.requirements);
  d.renderers = in.text_or("renderer", d.renderers);
  d.executable = in.text_or("exec", d.executable);
  d.output = in.text_or("output", d.output);
  d.jobs = in.integer_or("jobs", d.jobs, 1, kMostJobs);
  d.threads = in.integer_or("threads", d.threads, 0, kMostJobs);
  d.seed = in.integer_or("seed", d.seed, 0, kLargestSeed);
  d.spp_scale = in.number_or("spp_scale", d.spp_scale, json::kPositive);
  d.log = in.boolean_or("log", d.log);
  d.dry_run = in.boolean_or("dry_run", d.dry_run);
  in.finish();
  return d;
}

void write_defaults(json::Writer& out, const Defaults& d) {
  out.begin_object().member("suite", d.suite).member("case", d.cases).member("scene", d.scenes);
  out.member("requirement", d.requirements).member("renderer", d.renderers).member("exec", d.executable);
  out.member("output", d.output).member("jobs", d.jobs).member("threads", d.threads);
  out.member("seed", d.seed).member("spp_scale", d.spp_scale).member("log", d.log);
  out.member("dry_run", d.dry_run).end_object();
}

}  // namespace orbs::registry
