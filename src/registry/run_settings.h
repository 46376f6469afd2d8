#pragma once

#include "json/object_reader.h"
#include "json/writer.h"

#include <limits>
#include <string>

namespace orbs::registry {

constexpr int kMostSeeds = 16;  // of one render
/// So that the seeds that follow it are int, too.
constexpr int kLargestSeed = std::numeric_limits<int>::max() - kMostSeeds;

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
  int size_divisor = 1;  // of the width and height of every image; one of kSizeDivisors
  bool log = true;       // keep log.txt of renders that passed, too
  bool sandbox = false;  // renders see no network and no references
  bool dry_run = false;
  bool view = false;  // serve the page at the end and open it in the browser
};

/// Reads an object of settings; an absent one keeps its value here. InputError for one that is unknown or out
/// of range.
RunSettings read_run_settings(json::ObjectReader in);

/// Writes all settings as an object that read_run_settings reads.
void write_run_settings(json::Writer& out, const RunSettings& settings);

}  // namespace orbs::registry
