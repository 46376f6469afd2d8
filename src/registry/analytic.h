#pragma once

#include "base/vec.h"
#include "json/object_reader.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// Images that follow from a formula: what a case states of them. orbs::analytic computes them; no renderer
/// has a part in it. They are seen by the camera as it is at the start of the frame: where it moves, what is
/// said to move is what moves against it.
namespace orbs::registry {

/// Every pixel has this linear Rec.709 radiance.
struct ConstantImage {
  std::array<double, 3> value{};
};

/// Shapes of closed forms, in metres. The front of a polygon is the side from which its corners run
/// counter-clockwise; it must be flat and convex.
struct FlatPolygon {
  std::vector<Vec3d> corners;
  /// At the end of the frame, in the same plane, of one that moves: linear in time between. Else empty.
  std::vector<Vec3d> end_corners{};
};
struct RoundDisk {
  Vec3d centre;
  Vec3d normal;  // unit, of the front
  double radius_m = 1;
};
struct FormulaSphere {
  Vec3d centre;
  double radius_m = 1;
};
using AnalyticShape = std::variant<FlatPolygon, RoundDisk, FormulaSphere>;

/// What camera rays meet. It shows its radiance in front and black behind, unless it has a reflectance: then
/// it is lit by the sources, from both sides, by Lambert's law.
struct AnalyticSurface {
  AnalyticShape shape;
  double radiance = 0;
  std::optional<double> reflectance;
  double opacity = 1;  // of a polygon: the rest of the light passes straight on
  std::optional<Vec3d> shading_normal = std::nullopt;  // unit, in front, of a lit polygon that has another
};

/// What lights the surfaces. Its back is black, and it hides what lies behind it.
struct AnalyticSource {
  AnalyticShape shape;
  double radiance = 0;
  std::vector<Vec3d> window;                       // corners of what it is seen through; none: everywhere
  std::optional<Vec3d> candela_centre;             // where the directions of `candela` begin
  std::vector<std::pair<double, double>> candela;  // degrees from -y, factor on the radiance; linear between
};

/// A light without an area: at a place, with an intensity in W/sr, or from afar in a direction, with an
/// irradiance on a plane across it.
struct AnalyticLight {
  std::optional<Vec3d> position;  // none: from afar
  Vec3d direction{0, -1, 0};      // unit, in which it shines: all of it from afar, of a cone its axis
  double strength = 0;            // W/sr or W/m^2
  /// Half angles in degrees: all of the intensity within the first, none beyond the second, and between them
  /// a smoothstep of the cosine.
  std::optional<std::array<double, 2>> cone_deg{};
  std::vector<std::pair<double, double>> candela{};  // as of AnalyticSource, about its position
};

/// Direct light on diffuse surfaces, L = rho / pi E. The case's promise: seen from a lit point, sources do
/// not overlap. Only parallel light and that of points passes what is not opaque. With shadows, surfaces hide
/// sources and lights, and all of both are polygons; without, nothing does.
struct DirectLight {
  double environment = 0;
  bool has_shadows = false;
  std::optional<std::array<double, 2>>
      shutter{};  // opens and closes, if something moves; a pixel is the mean
  std::vector<AnalyticSurface> surfaces;
  std::vector<AnalyticSource> sources;
  std::vector<AnalyticLight> lights{};
};

/// A plane between two media, or a stack of plates, that fills the image: radiance times what it reflects or
/// transmits at the angle of each camera ray. n and k are those beyond the plane over those before it.
struct FresnelPlane {
  Vec3d normal;  // unit
  std::array<double, 3> n{1, 1, 1};
  std::array<double, 3> k{};
  double radiance = 1;
  int plates = 0;  // 0: what one plane reflects; else what so many plates transmit
};

struct PolarisedPlane {
  Vec3d normal;  // unit
  double n = 1;  // n + i k of what is beyond, over that before
  double k = 0;
};

/// Planes that each fill the view of the one before, the first that of the camera, and behind the last an
/// even radiance that is not polarised. What enters a plane never comes back. The image has S1 to S3.
struct PolarisedPlanes {
  std::vector<PolarisedPlane> planes;
  double radiance = 1;
};

/// The BRDFs of the scene format whose directional albedo is known, by its numbers.
struct OrenNayarBrdf {
  double roughness = 0;
};
struct GgxBrdf {
  double alpha = 1;
};
struct MetalBrdf {
  double alpha = 1;
};
struct MetallicRoughnessBrdf {
  double metallic = 0;
  double roughness = 1;
};
struct PhongBrdf {
  double exponent = 0;
};
struct PlasticBrdf {
  double ior = 1.5;
  bool is_nonlinear = false;
  double alpha = 0;  // 0 is smooth
};
using BallBrdf =
    std::variant<OrenNayarBrdf, GgxBrdf, MetalBrdf, MetallicRoughnessBrdf, PhongBrdf, PlasticBrdf>;

/// A single convex ball in a constant environment of radiance 1: each pixel shows the directional albedo.
struct AlbedoBall {
  Vec3d centre;
  double radius_m = 1;
  double reflectance = 1;
  BallBrdf brdf;
};

/// A single Lambertian ball, lit once by a sky whose radiance in the direction d is constant + gradient . d
/// in each channel: it shows rho (constant + 2/3 gradient . n).
struct SkyBall {
  Vec3d centre;
  double radius_m = 1;
  double reflectance = 1;
  std::array<double, 3> constant{};
  std::array<Vec3d, 3> gradients{};  // of red, green and blue
  bool shows_sky = true;             // beside the ball; else that is black
};

/// Mirrors at x = -half_width and x = half_width, a plane of radiance 1 at y = floor below the camera.
struct MirrorCorridor {
  double half_width_m = 1;
  double floor_m = 0;
  double reflectance = 1;
};

/// What stands beyond the edge of a texture, as scene::Wrap.
enum class PlaneWrap { Repeat, Clamp, Mirror };

/// A plane that fills the image and shows a texture: radiance times the texel or the four texels about a
/// place.
struct TexturedPlane {
  Vec3d origin;  // where u = v = 0
  Vec3d u_edge;  // from there to u = 1
  Vec3d v_edge;
  int columns = 1;
  std::vector<std::array<double, 3>> texels;  // linear Rec.709, row by row from v = 0
  std::array<PlaneWrap, 2> wrap{};            // along u and v
  bool is_nearest = false;
  double radiance = 1;
};

using AnalyticImage = std::variant<ConstantImage,
                                   DirectLight,
                                   FresnelPlane,
                                   PolarisedPlanes,
                                   AlbedoBall,
                                   SkyBall,
                                   MirrorCorridor,
                                   TexturedPlane>;

/// A reference that follows from a formula.
struct AnalyticReference {
  AnalyticImage image;
  std::string law;     // the formula in words or symbols, with its numbers
  std::string source;  // where it is derived
};

/// Reads the object "analytic" of a case's scene. InputError with file, line and key.
AnalyticReference load_analytic(json::ObjectReader in);

}  // namespace orbs::registry
