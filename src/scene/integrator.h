#pragma once

#include <limits>
#include <string>
#include <variant>

namespace orbs::json {
class ObjectReader;
class Writer;
}  // namespace orbs::json

/// How the image of a scene is computed. An integrator is a struct with `kType`, its word in the scene file,
/// load and write; one that is not path tracing has `kLevel`, the level that has it, `kWhat`, as messages say
/// it, and `kNoPaths`, why it has no Stokes vectors and no classes of paths.
namespace orbs::scene {

struct PathTracing {
  static constexpr const char* kType = "path";
  bool operator==(const PathTracing&) const = default;
};

/// Which directions count how much.
enum class OcclusionWeight { Cosine, Uniform };

/// In place of light transport: the image is the share of the hemisphere about the visible point in which no
/// surface lies nearer than the distance.
struct AmbientOcclusion {
  static constexpr const char* kType = "ambient_occlusion";
  static constexpr const char* kLevel = "I1";
  static constexpr const char* kWhat = "the image is ambient occlusion";
  static constexpr const char* kNoPaths =
      "ambient occlusion has no light paths that Stokes vectors or classes could be told of";
  double distance_m = std::numeric_limits<double>::infinity();
  OcclusionWeight weight = OcclusionWeight::Cosine;
  bool operator==(const AmbientOcclusion&) const = default;
};

/// Which records of an irradiance cache may be used at a point, and how they weigh.
enum class CacheMetric { Ward, TabellionLamorlette };

/// Path tracing, biased: diffuse interreflection is computed at a few places and interpolated between them.
struct IrradianceCache {
  static constexpr const char* kType = "irradiance_cache";
  static constexpr const char* kLevel = "I2";
  static constexpr const char* kWhat = "diffuse interreflection comes from an irradiance cache";
  static constexpr const char* kNoPaths =
      "an irradiance cache keeps no light paths that Stokes vectors or classes could be told of";
  CacheMetric metric = CacheMetric::Ward;
  double error = 0.2;             // a of Ward's metric: the relative error that interpolation may have
  double kappa = 1;               // of the metric of Tabellion and Lamorlette: more is more accurate
  int rays = 512;                 // of each record
  double least_spacing_px = 1.5;  // bounds of the distance that a record reaches
  double most_spacing_px = 20;
  bool has_gradients = true;
  bool clamps_to_neighbours = true;
  bool operator==(const IrradianceCache&) const = default;
};

/// The members of the entry "integrator"; InputError at the key that is wrong.
void load(json::ObjectReader& in, PathTracing& loaded);
void load(json::ObjectReader& in, AmbientOcclusion& loaded);
void load(json::ObjectReader& in, IrradianceCache& loaded);

using Integrator = std::variant<PathTracing, AmbientOcclusion, IrradianceCache>;

/// The entry "integrator" but for the trace depth. InputError at the key that is wrong.
Integrator load_integrator(json::ObjectReader& in);
void write_integrator(json::Writer& out, const Integrator& integrator);

/// Why there are no light paths of which an image could hold more than the colour; "" when there are.
std::string no_paths_reason(const Integrator& integrator);

}  // namespace orbs::scene
