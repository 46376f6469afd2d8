#pragma once

#include "base/process_limits.h"
#include "registry/expected.h"
#include "registry/features.h"
#include "registry/run_settings.h"
#include "registry/slurm.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// configuration.json (format "orbs-configuration/1") as plain data: the only file a user edits to add a
/// renderer.
namespace orbs::registry {

struct Suite {
  std::string name;
  std::filesystem::path cases;       // absolute
  std::filesystem::path references;  // absolute
  /// Where the files that its scenes name may lie, beside a scene's own folder: its cases, the common data,
  /// and what its entry names under "data". Absolute.
  std::vector<std::filesystem::path> data{};
};

/// Words of "scene_format". Neutral: scenes as the suite holds them. Native: a format of the renderer's own,
/// of which there are hand-written scenes only. All other words are those of the exporters, who check them.
inline constexpr const char* kNeutralFormat = "orbs-scene";
inline constexpr const char* kNativeFormat = "native";

/// Requirements that a renderer cannot meet, and why; the reason stands in the report.
struct KnownLimit {
  std::vector<std::string> requirements;
  std::string reason;
};

/// Where a renderer says how long it has rendered, start and files not counted: in its output or in a file.
/// Nothing is looked for where both are "".
struct RenderSeconds {
  /// POSIX extended regular expression, of one line. Its groups: seconds, or minutes and seconds, or hours,
  /// minutes and seconds; or a number and its unit (us, ms, s, m, min, h, d).
  std::string pattern{};
  std::string file{};       // JSON that it writes, relative to the folder of the render
  std::string key{};        // of a number there: "seconds", or "timing/render" for one in an object
  double unit_seconds = 1;  // 0.001 for a number of milliseconds
};

/// One quality of a renderer whose accuracy does not follow from its samples alone.
struct QualityRung {
  std::string name;
  int spp = 1;                                   // that the renderer gets
  std::map<std::string, double> scene_settings;  // in place of those of the entry
};

struct Renderer {
  std::string name;        // of a variant: "<entry>-<variant>"
  std::string variant_of;  // name of the entry that lists it as a variant; "" for an entry without variants
  std::string place;       // file:line of the entry, for messages; "" when it comes from no file
  std::string executable;  // a path with placeholders, or a program on PATH
  std::vector<std::string> version_command;
  /// POSIX extended regular expression with one group, which holds the version in the first line of the
  /// output that matches; "" for the whole first line.
  std::string version_pattern;
  std::string scene_format = kNeutralFormat;
  std::map<std::string, double>
      scene_settings;  // numbers for the exporter of the format; which, it says itself
  /// In place of those of scene_settings, by the divisor of a reduced size.
  std::map<int, std::map<std::string, double>> scene_settings_of_sizes;
  /// In place of both, by the name of the scene.
  std::map<std::string, std::map<std::string, double>> scene_settings_of_scenes;
  /// What its {transport} stands for, by the name of what the light paths of a scene must carry ("spectral");
  /// these names themselves where it is empty.
  std::map<std::string, std::string> transports;
  std::string native_scenes;  // ending of scenes written by hand for it, "xml"; "" when it has none
  FeatureSet declares;
  std::vector<KnownLimit> known_limits;
  std::vector<std::string> command;
  std::vector<std::string> arguments;  // of the variant, in the place of {arguments} in the command
  /// Files of plug-ins, with {root} and {build}, relative to the folder of the configuration. A word of the
  /// command with {plugin} stands there once for each.
  std::vector<std::string> plugins{};
  ProcessLimits limits;  // those of the file, with the entry's own in their place
  double spp_scale = 1;  // samples of this renderer for one sample of the case
  std::map<std::string, double> spp_scale_of_scenes;  // in place of spp_scale, by the name of the scene
  /// More than one: each render is so many, with seeds that follow each other and the samples shared among
  /// them. For renderers that write no variance: their noise is then known from the scatter.
  int seeds = 1;
  /// {seed} is the seed of the render times this. For renderers whose random numbers of one seed in one pixel
  /// are those of the next seed in the pixel before: renders of consecutive seeds would not be independent.
  int seed_stride = 1;
  std::string biased;          // why no quality of it is right to the last digit; "" where nothing is known
  bool is_noise_free = false;  // draws no random samples: what differs from a reference is an error
  /// A pixel is the plain mean over its square. Only then is an image of fewer pixels the average of the full
  /// one.
  bool has_box_filter = true;
  /// Arguments that follow its command where it is to render in double precision; none: it cannot.
  std::vector<std::string> double_precision{};
  RenderSeconds render_seconds;
  std::vector<QualityRung>
      cost_ladder;  // from cheap to accurate; none: orbs cost takes more and more samples
  std::vector<std::string> environment;  // names passed on from ours, or NAME=value
};

struct Configuration {
  std::filesystem::path file;
  std::filesystem::path root;  // the folder of the file; what {root} stands for
  RunSettings defaults;
  std::vector<Suite> suites;
  std::vector<Renderer> renderers;
  std::vector<ExpectedFailure> expected{};
  SlurmSettings slurm{};
};

/// Reads and checks the file. InputError with file, line and key: unknown keys, wrong types, names given
/// twice, unknown placeholders, a command without {scene} or {output}.
Configuration load_configuration(const std::filesystem::path& file);

/// As load_configuration, for a text that is not in the file yet.
Configuration parse_configuration(const std::filesystem::path& file, const std::string& text);

/// The suite of that name; InputError naming the nearest one.
const Suite& find_suite(const Configuration& configuration, const std::string& name);

/// The reason that `renderer` gives for not meeting a requirement; nothing when it gives none.
std::optional<std::string> limit_reason(const Renderer& renderer, const std::string& requirement);

/// "configuration.json:14: renderer 'pbrt'", as messages about the entry begin.
std::string entry_name(const Renderer& renderer);

/// The nearest configuration.json: in `from` or the folders above it; nothing when there is none up to the
/// root.
std::optional<std::filesystem::path> nearest_configuration(std::filesystem::path from);

}  // namespace orbs::registry
