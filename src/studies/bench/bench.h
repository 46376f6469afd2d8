#pragma once

#include "registry/configuration.h"
#include "results/record.h"
#include "run/render.h"
#include "studies/bench/overhead.h"
#include "studies/context.h"
#include "studies/seed_statistics.h"

#include <optional>
#include <string>
#include <vector>

/// Questions that need many runs of a renderer: what speed and accuracy cost.
namespace orbs::studies {

struct BenchSettings {
  int rounds = 5;
  int spp = 64;        // of the large render; at least 2
  int size_px = 512;   // width and height
  int threads = 2;     // of each render
  std::string only{};  // names of renderers, comma-separated; "": orbs, and cycles where it is installed
};

/// Two renders of one seed right after each other. They differ in their samples alone, so the difference of
/// their times is what these samples cost: the start of the program, which takes Blender seconds, drops out,
/// as do reading, building and writing.
struct BenchRound {
  run::RenderCost small;
  run::RenderCost large;
};

struct BenchRenderer {
  std::string name;
  std::string version;
  std::vector<BenchRound> rounds;  // the seed of the first is 1, and so on
  std::optional<SeedNoise> noise;  // of a large render; nothing for a single round
};

struct BenchRecord {
  BenchSettings settings;
  std::string orbs_version;
  std::string started;  // local time, ISO 8601
  results::Host host;
  double load = 0;  // when it started
  std::string scene;
  int trace_depth = 0;
  std::vector<BenchRenderer> renderers;
  std::vector<results::LeftOut> left_out;
  std::optional<Overhead> overhead;
  std::optional<Start> start;
  double metrics_cpu_ms = 0;  // one metrics::compare of two of the images, noise test and all maps included
};

/// Renders the Cornell box with each renderer in turn, round by round, so that whatever else happens on the
/// machine falls on all of them. Nothing when stopped. InputError when a renderer that is named is not there,
/// or when one gives no image.
std::optional<BenchRecord> run_bench(const registry::Configuration& configuration,
                                     const BenchSettings& settings,
                                     const StudyContext& context);

}  // namespace orbs::studies
