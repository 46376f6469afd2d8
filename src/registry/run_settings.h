#pragma once

#include "json/fields.h"
#include "registry/image_size.h"

#include <limits>
#include <set>
#include <string>

namespace orbs::registry {

constexpr int kMostSeeds = 16;  // of one render
/// So that the seeds that follow it are int, too.
constexpr int kLargestSeed = std::numeric_limits<int>::max() - kMostSeeds;
constexpr int kMostThreads = 1024;

/// The settings of a run: those of the command line over the defaults of configuration.json over these. Lists
/// are comma-separated patterns, "*" for all.
struct RunSettings {
  std::string suite = "orbs";
  std::string cases = "*";
  std::string scenes = "*";
  std::string requirements = "*";
  std::string renderers = "*";
  std::string executable;  // of the one renderer that is chosen; "" for its own
  std::string output;      // folder of the run; "" for outputs-YYMMDD-HHMMSS in the current folder
  int jobs = 1;            // renders at a time
  int threads = 0;         // of one render; 0: the machine's cores divided by jobs
  int seed = 1;
  double spp_scale = 1;
  SizeDivisor size_divisor = FullSize;
  int least_side_px = 16;      // that a reduced size leaves of an image, see divisor_of_image
  bool fixed_samples = false;  // those of the cases, in place of as many as decide
  bool log = true;             // keep log.txt of renders that passed, too
  bool strict = false;         // a pass with remarks makes the run fail
  bool sandbox = false;        // renders see no network and no references
  bool dry_run = false;
  bool view = false;  // serve the page at the end and open it in the browser
  // Of one call: a run that is resumed has these anew.
  double budget_seconds = 0;         // of rendering in the whole run; 0: no limit
  double target_budget_seconds = 0;  // of one target; 0: as many samples as usual, see run/looks.h
  int max_fail = 0;                  // 0: no limit
  bool last_failed = false;
  int durations = 0;
  int repeat = 1;
  bool quiet = false;
  bool verbose = false;
  std::string label;  // of the run, which keeps it
};

inline ReducedSize reduced_size(const RunSettings& settings) {
  return {settings.size_divisor, settings.least_side_px};
}

/// The settings without those of one call.
inline RunSettings lasting(RunSettings settings) {
  const RunSettings initial;
  settings.budget_seconds = initial.budget_seconds;
  settings.target_budget_seconds = initial.target_budget_seconds;
  settings.max_fail = initial.max_fail;
  settings.last_failed = initial.last_failed;
  settings.durations = initial.durations;
  settings.repeat = initial.repeat;
  settings.quiet = initial.quiet;
  settings.verbose = initial.verbose;
  return settings;
}

/// The keys of settings that say how a run goes on and what it prints, not what is rendered.
inline const std::set<std::string> kCallSettings{"budget", "target_budget", "output",      "dry_run",
                                                 "view",   "max_fail",      "last_failed", "durations",
                                                 "repeat", "quiet",         "verbose",     "label"};

/// What is rendered, and how.
template <class Visitor, json::RecordOf<RunSettings> Settings>
void fields_of_renders(Visitor& visit, Settings& run) {
  visit("suite", run.suite,
        {.help = "The suite", .option = "--suite NAME", .unset = "that of the configuration"});
  visit("case", run.cases,
        {.help = "Only these cases: names or patterns like `'m*'`, separated by commas",
         .option = "-c,--case NAMES",
         .is_list = true});
  visit("scene", run.scenes, {.help = "Only these scenes", .option = "-s,--scene NAMES", .is_list = true});
  visit("requirement", run.requirements,
        {.help = "Only these requirements, for example `'M*,L3'`",
         .option = "--requirement NAMES",
         .is_list = true});
  visit("renderer", run.renderers,
        {.help = "Only these renderers",
         .option = "-r,--renderer NAMES",
         .is_list = true,
         .unset = "all that are installed"});
  visit("exec", run.executable,
        {.help = "Program to start instead of the chosen renderer's own", .option = "-e,--exec PROGRAM"});
  visit("output", run.output,
        {.help = "New folder for the results",
         .option = "-o,--output FOLDER",
         .unset = "outputs-YYMMDD-HHMMSS"});
  visit("jobs", run.jobs,
        {.help = "Number of renders at the same time",
         .option = "-j,--jobs NUMBER",
         .range = {1, kMostThreads}});
  visit("threads", run.threads,
        {.help = "Threads of one render; 0: the cores divided by the renders at the same time",
         .option = "--threads NUMBER",
         .range = {0, kMostThreads}});
  visit("seed", run.seed,
        {.help = "Seed of all renders", .option = "--seed NUMBER", .range = {0, kLargestSeed}});
  visit("spp_scale", run.spp_scale,
        {.help = "Multiply every scene's samples per pixel",
         .option = "--spp-scale NUMBER",
         .range = json::kPositive});
  visit("size", run.size_divisor,
        {.help = "Width and height of all images, as a share of the scenes': `1`, `1/2`, `1/4` or `1/8`",
         .option = "--size SHARE"});
  visit(
      "least_side", run.least_side_px,
      {.help =
           "Pixels that a reduced size leaves of the shorter side of an image at least: a smaller image has a "
           "larger share, up to its full size",
       .option = "--least-side PIXELS",
       .range = {1, 1024}});
  visit("fixed_samples", run.fixed_samples,
        {.help = "Render the samples of the cases, in one go, in place of as many as decide the verdict",
         .option = "--fixed-samples"});
}

/// What a run keeps, when it ends, and what it says.
template <class Visitor, json::RecordOf<RunSettings> Settings>
void fields_of_conduct(Visitor& visit, Settings& run) {
  visit("log", run.log,
        {.help = "Keep `log.txt` of every render, not only of those that fail", .option = "-l,--log"});
  visit(
      "budget", run.budget_seconds,
      {.help =
           "Rendering time after which nothing gets more samples; what decides soonest comes first: 30s, 20m, "
           "2h. In the file seconds, 0: no limit",
       .option = "--budget TIME",
       .range = json::kNotNegative});
  visit(
      "target_budget", run.target_budget_seconds,
      {.help =
           "Rendering time that one target gets at most, in place of the usual number of samples: 30s, 20m, 2h. In "
           "the file seconds, 0: the usual number of samples",
       .option = "--target-budget TIME",
       .range = json::kNotNegative});
  visit("strict", run.strict, {.help = "Let a pass with remarks make the run fail", .option = "--strict"});
  visit(
      "sandbox", run.sandbox,
      {.help =
           "Run renderers under bubblewrap: alone with their programs, the scene and what the command names; "
           "no network, no references, only their own folder writable",
       .option = "--sandbox"});
  visit("dry_run", run.dry_run,
        {.help = "Print the renders and their commands, and start nothing", .option = "--dry-run"});
  visit("view", run.view,
        {.help = "At the end, serve the results as a page and open it in the browser",
         .option = "--view,--visualize"});
  visit("max_fail", run.max_fail,
        {.help = "End the run after so many failed targets, as if it was interrupted; 0: render all",
         .option = "--maxfail NUMBER",
         .range = {0, 1'000'000}});
  visit(
      "last_failed", run.last_failed,
      {.help = "Only the targets that failed in the newest run of this suite and size beside the new folder",
       .option = "--last-failed"});
  visit("durations", run.durations,
        {.help = "At the end, print the slowest renders, so many of them",
         .option = "--durations NUMBER",
         .range = {0, 1'000'000}});
  visit(
      "repeat", run.repeat,
      {.help = "So many runs with other seeds, each in a folder of its own within the output, and a summary "
               "that names the flaky targets",
       .option = "--repeat NUMBER",
       .range = {1, 1000}});
  visit("quiet", run.quiet,
        {.help = "Print what fails, the counts and the folder only", .option = "-q,--quiet"});
  visit("verbose", run.verbose,
        {.help = "Print whole reasons with all their numbers", .option = "-v,--verbose"});
  visit("label", run.label,
        {.help = "Name of what is tested, such as the commit of the renderer: `orbs history` shows it",
         .option = "--label TEXT"});
}

/// All of them are options, and a plan holds them, too.
template <class Visitor, json::RecordOf<RunSettings> Settings>
void fields(Visitor& visit, Settings& run) {
  fields_of_renders(visit, run);
  fields_of_conduct(visit, run);
}

}  // namespace orbs::registry
