#pragma once

#include "json/fields.h"
#include "results/host_record.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// What a study of cost measured, before anything is computed from it. Each member is also listed in the
/// struct's fields(), see json/fields.h, so that a study is stored and resumed.
namespace orbs::studies {

struct CostSettings {
  double target_db = 35;         // of psnr_srgb8, that the curves are to cross
  double budget_seconds = 1200;  // wall clock of the whole study
  int seeds = 4;                 // renders of each setting
  int points = 5;                // of each curve, each with twice the samples of the one before
  int threads = 0;               // of each render; 0: all cores
  int order_seed = 1;            // of the order of the renders
};

template <class Visitor, json::RecordOf<CostSettings> Record>
void fields(Visitor& visit, Record& settings) {
  visit("target_db", settings.target_db);
  visit("budget_seconds", settings.budget_seconds);
  visit("seeds", settings.seeds, {.range = {.min = 1}});
  visit("points", settings.points, {.range = {.min = 1}});
  visit("threads", settings.threads, {.range = {.min = 0}});
  visit("order_seed", settings.order_seed);
}

/// What a sweep varies.
enum class SweepOf {
  Samples,   // samples per pixel
  Settings,  // the settings that the configuration lists
};

inline constexpr auto names(SweepOf) {
  return std::array{json::Named{SweepOf::Samples, "samples"}, json::Named{SweepOf::Settings, "settings"}};
}

struct CostRenderer {
  std::string name;
  std::string version;
  SweepOf sweep = SweepOf::Samples;
  std::string biased;  // why no time makes it right; "" where nothing is known
  /// Of one whose seeds are the images of a run, see registry::ImageSequence: how many of them one render
  /// takes. 0 for all others.
  int sequence_images = 0;
};

template <class Visitor, json::RecordOf<CostRenderer> Record>
void fields(Visitor& visit, Record& renderer) {
  visit.required("name", renderer.name);
  visit("version", renderer.version);
  visit("sweep", renderer.sweep);
  visit("biased", renderer.biased);
  visit("sequence_images", renderer.sequence_images, {.range = {.min = 0}});
}

/// The expectation of the errors that the noise of the reference makes alone.
struct ReferenceNoise {
  double relmse = 0;
  double mse = 0;
  std::optional<double> psnr_srgb8;
};

template <class Visitor, json::RecordOf<ReferenceNoise> Record>
void fields(Visitor& visit, Record& noise) {
  visit("relmse", noise.relmse);
  visit("mse", noise.mse);
  visit("psnr_srgb8", noise.psnr_srgb8);
}

struct CostTarget {
  std::string name;
  std::string requirement;
  std::string title;
  int width_px = 0;
  int height_px = 0;
  std::string reference;  // file, relative to the study's folder
  ReferenceNoise reference_noise;
};

template <class Visitor, json::RecordOf<CostTarget> Record>
void fields(Visitor& visit, Record& target) {
  visit.required("name", target.name);
  visit("requirement", target.requirement);
  visit("title", target.title);
  visit("width", target.width_px, {.range = {.min = 0}});
  visit("height", target.height_px, {.range = {.min = 0}});
  visit("reference", target.reference);
  visit("reference_noise", target.reference_noise);
}

/// One setting of a sweep: a sample count, or one that the configuration lists.
struct SweepSetting {
  std::string name;  // "64 spp", or that of the configuration
  int spp = 1;
};

template <class Visitor, json::RecordOf<SweepSetting> Record>
void fields(Visitor& visit, Record& setting) {
  visit.required("name", setting.name);
  visit("spp", setting.spp, {.range = {.min = 1}});
}

/// The settings by which one renderer renders one target, from the fastest to the most accurate.
struct Sweep {
  std::size_t target = 0;
  std::size_t renderer = 0;
  std::vector<SweepSetting> settings;
  std::string note;  // "the budget ends at 256 spp; 35 dB would need about 40 s"
  std::string
      finding;  // what the gates of the case say of the last setting's first image, unless it is right
  double seconds_per_sample = 0;  // by the pilot
  /// Every image of a setting is the same, so that few are rendered. Not known of studies of earlier
  /// versions.
  std::optional<bool> is_noise_free = {};
};

template <class Visitor, json::RecordOf<Sweep> Record>
void fields(Visitor& visit, Record& sweep) {
  visit.required("target", sweep.target);
  visit.required("renderer", sweep.renderer);
  visit("settings", sweep.settings);
  visit("note", sweep.note);
  visit("finding", sweep.finding);
  visit("seconds_per_sample", sweep.seconds_per_sample);
  visit("noise_free", sweep.is_noise_free);
}

/// What a render is made for.
enum class Purpose {
  Sweep,      // a point of a curve
  FixedCost,  // 4 x 4 px (Blender renders no fewer) with few samples: the cost of starting, reading, building
  Again,      // the setting once more, for the comparison of the renderer with itself
};

inline constexpr auto names(Purpose) {
  return std::array{json::Named{Purpose::Sweep, "sweep"}, json::Named{Purpose::FixedCost, "fixed"},
                    json::Named{Purpose::Again, "again"}};
}

struct CostRender {
  std::size_t target = 0;
  std::size_t renderer = 0;
  Purpose purpose = Purpose::Sweep;
  std::string setting = {};  // its name; "" for the fixed cost
  int spp = 1;
  int seed = 1;
  int order = 0;  // counts the renders of the study as they were made
  /// That its processes rendered for each one that counts: more than 1 where those before a seed of a
  /// sequence are rendered, too. The times are those of the processes.
  double images = 1;
  double cpu_seconds = 0;
  double wall_seconds = 0;
  std::optional<double> render_seconds = {};  // that the renderer states
  std::optional<double> trial_seconds = {};   // likewise: the part of them that trial renderings took
  double load = 0;                            // of the machine when it started
  /// The share of the time of all processors that others took meanwhile; nothing where it is not known.
  std::optional<double> other_share = {};
  int repeats = 0;  // earlier attempts, which other work disturbed
  std::optional<double> relmse = {}, mse = {}, psnr_srgb8 = {}, flip = {};
};

template <class Visitor, json::RecordOf<CostRender> Record>
void fields(Visitor& visit, Record& render) {
  visit.required("target", render.target);
  visit.required("renderer", render.renderer);
  visit("purpose", render.purpose);
  visit("setting", render.setting);
  visit("spp", render.spp);
  visit("seed", render.seed);
  visit("order", render.order);
  visit("images", render.images, {.range = {.min = 1}});
  visit("cpu_seconds", render.cpu_seconds);
  visit("wall_seconds", render.wall_seconds);
  visit("render_seconds", render.render_seconds);
  visit("trial_seconds", render.trial_seconds);
  visit("load", render.load);
  visit("other_share", render.other_share);
  visit("repeats", render.repeats, {.range = {.min = 0}});
  visit("relmse", render.relmse);
  visit("mse", render.mse);
  visit("psnr_srgb8", render.psnr_srgb8);
  visit("flip", render.flip);
}

struct CostRecord {
  std::string orbs_version;
  std::string started;  // local time, ISO 8601
  bool is_finished = false;
  std::string suite;
  std::string size;  // "1", "1/4"
  CostSettings settings;
  results::Host host;
  double load = 0;      // when it started
  double load_end = 0;  // when it ended
  std::vector<CostRenderer> renderers;
  std::vector<CostTarget> targets;
  std::vector<Sweep> sweeps;
  std::vector<CostRender> renders;
};

template <class Visitor, json::RecordOf<CostRecord> Record>
void fields(Visitor& visit, Record& record) {
  visit("orbs_version", record.orbs_version);
  visit("started", record.started);
  visit("finished", record.is_finished);
  visit("suite", record.suite);
  visit("size", record.size);
  visit("settings", record.settings);
  visit("host", record.host);
  visit("load", record.load);
  visit("load_end", record.load_end);
  visit("renderers", record.renderers);
  visit("targets", record.targets);
  visit("sweeps", record.sweeps);
  visit("renders", record.renders);
}

}  // namespace orbs::studies
