#pragma once

#include "json/fields.h"
#include "registry/image_size.h"

#include <limits>
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
  bool log = true;       // keep log.txt of renders that passed, too
  bool strict = false;   // a pass with remarks makes the run fail
  bool sandbox = false;  // renders see no network and no references
  bool dry_run = false;
  bool view = false;  // serve the page at the end and open it in the browser
};

/// The options that choose what is rendered, and how; a plan holds them, too.
template <class Visitor, json::RecordOf<RunSettings> Settings>
void fields(Visitor& visit, Settings& run) {
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
  visit("log", run.log,
        {.help = "Keep `log.txt` of every render, not only of those that fail", .option = "-l,--log"});
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
         .option = "-v,--view,--visualize"});
}

}  // namespace orbs::registry
