#pragma once

#include "results/host.h"
#include "results/verdict.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// What a run knows, as plain data. Paths are relative to the run's folder where they lie in it.
namespace orbs::results {

/// A number with what it means, for whoever meets it outside this program.
struct Measure {
  std::string name;  // "psnr_srgb8"
  double value = 0;  // infinite for equal images under a ratio in dB
  std::string unit;
  std::string definition;
  bool lower_is_better = false;
  bool is_signed = false;          // nearer to zero is better
  std::optional<double> low = {};  // ends of its interval, where it has one
  std::optional<double> high = {};
  std::vector<double> where = {};  // x0, y0, x1, y1 of the pixels that it is of; empty: of all
};

/// An image of the error that lies beside the result.
struct MapRecord {
  std::string name;   // "l1"
  std::string image;  // EXR of the raw numbers
  std::string definition;
  bool is_signed = false;
  double scale_maximum = 1;  // where its colour scale ends; the same for every renderer
};

/// One condition that an image had to meet.
struct Check {
  std::string what;  // "psnr_srgb8", "pixel [256,220,257,221]", "path ESDL"
  bool passed = false;
  std::string reason;
  std::optional<double> min;  // what the number may be, where the condition is on a number
  std::optional<double> max;
};

/// One render: what was started, what it cost, how it ended.
struct JobRecord {
  std::string id;  // the same for the same suite, scene, renderer, samples and seed
  std::string suite;
  std::string scene;
  std::string renderer;
  std::string renderer_version;
  std::vector<std::string> argv;
  std::string command;        // for a shell: the same render again, in the same place
  std::string scene_hash;     // of the scene that was rendered
  std::string settings_hash;  // of what else makes the image: command, environment, threads
  std::string limits_hash;    // of what may end it without an image: time, memory, files
  std::string judged_hash;    // of what its images were judged by: cases, references, this program
  std::string native_scene;   // the hand-written one that was rendered; "" when it was exported
  std::string folder;
  int spp = 0;
  int seed = 0;   // the first of
  int seeds = 1;  // so many, which share the samples
  int threads = 0;
  Host host;
  std::string started;  // local time, ISO 8601
  double load = 0;      // of the machine then: processes that wanted to run, mean of the minute before
  double wall_seconds = 0;
  double cpu_seconds = 0;                // user and system
  std::optional<double> render_seconds;  // as the renderer says itself
  std::size_t peak_rss_bytes = 0;
  int exit_code = 0;
  std::string signal;  // "SIGSEGV", "" for none
  bool core_dumped = false;
  bool rendered = false;               // there is a usable image
  Verdict verdict = Verdict::Skipped;  // Pass means "there is a usable image", nothing about it being right
  std::string reason;
  std::string image;
  std::string log;
};

/// One image of one renderer, judged for one case.
struct TargetRecord {
  std::string requirement;
  std::string case_name;
  std::string target;  // a scene, or a difference of two
  std::string renderer;
  std::vector<std::string> jobs;  // ids of the renders it is made from
  bool declared = false;          // the renderer claims the requirement
  Verdict verdict = Verdict::Skipped;
  std::string reason;
  std::vector<Measure> measures;
  std::vector<Check> checks;
  std::vector<std::string> remarks;                         // what changes no verdict and yet must be known
  std::string reference;                                    // absolute
  std::map<std::string, std::string> reference_provenance;  // "program", "spp", ...
  std::string image;
  std::string reference_image;  // the copy of the reference in the run's folder; "" when there is none
  std::vector<MapRecord> maps;
};

/// What a case is about, in the words of its case.json.
struct CaseRecord {
  std::string suite;
  std::string name;
  std::string requirement;
  std::string title;
  std::string tests;
  std::string typical_mistake;
  std::string smallest_error_seen = {};  // by its gate, in words; "" when nobody has tried
};

/// An effect of light, the thing in the scene that calls for it or looks as if it did, and why.
struct EffectRecord {
  std::string effect;  // "thin film"
  std::string thing;   // "material 'copper'"
  std::string reason;  // follows the thing: "has a film 550 nm high"
};

/// A scene rendered otherwise than it calls for: what that costs, and what becomes of the image.
struct EffectCostRecord {
  std::string name;        // "polarised", "without dispersion"
  double time_ratio = 0;   // CPU time per sample over that of what the scene calls for
  double error_ratio = 0;  // CPU time to the same noise, likewise; 0 where nobody knows
  std::string change;      // "same to the bit", or how it differs
};

/// What a scene calls for, and what its light paths must carry for that.
struct SceneRecord {
  std::string name;
  std::string transport;  // "rgb", "spectral", "polarised", "bispectral", "polarised-bispectral"
  std::vector<EffectRecord> called_for;
  std::vector<EffectRecord> not_called_for;
  std::vector<EffectCostRecord> effect_costs = {};  // by orbs effect-cost; none when nobody has asked
};

/// A cell of the table: the worst image of a requirement.
struct Cell {
  bool declared = false;
  Verdict verdict = Verdict::Skipped;
  std::optional<double> lowest_psnr_db;  // infinite when all images equal their references
  std::string reason;                    // of the worst image
};

struct RequirementRecord {
  std::string code;  // "M2"
  std::string title;
  std::map<std::string, Cell> cells;  // by renderer
};

struct RendererRecord {
  std::string name;
  std::string version;
  std::string executable;
  std::string declared;               // ORB.S notation
  std::string measured;               // "" when nothing was judged
  std::map<std::string, int> counts;  // verdict name -> requirements
  double wall_seconds = 0;
  double cpu_seconds = 0;
};

struct LeftOut {
  std::string renderer;
  std::string reason;
};

struct RunRecord {
  std::string suite;
  std::string folder;  // absolute
  std::string started;
  double wall_seconds = 0;
  std::string orbs_version;
  std::vector<std::string> command_line;
  Host host;        // of the run; renders that were there before may have another one
  double load = 0;  // when it started, as for a render
  bool interrupted = false;
  bool finished = true;  // false while the run goes on, and for ever after it was killed
  std::vector<CaseRecord> cases;
  std::vector<SceneRecord> scenes;
  std::vector<RendererRecord> renderers;
  std::vector<LeftOut> left_out;
  std::vector<RequirementRecord> requirements;
  std::vector<TargetRecord> targets;
  std::vector<JobRecord> jobs;
};

/// The shell commands of the renders that the image is made from, joined by " ; ".
std::string command_of(const RunRecord& run, const TargetRecord& target);

/// Whether every image is unsupported, which says nothing about any renderer.
bool judged_nothing(const RunRecord& run);

/// 0 when nothing that counts failed, else 1: a failure counts when the renderer declares the requirement. 2
/// when nothing was judged.
int exit_status(const RunRecord& run);

}  // namespace orbs::results
