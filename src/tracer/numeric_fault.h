#pragma once

#include <array>
#include <string_view>

/// Mistakes of arithmetic that renderers make, for seeing that the hard cases catch them. Only a program of
/// the tests can make them, which is compiled with ORBS_FAULTS; in orbs-tracer all of this is compiled away.
namespace orbs::tracer {

enum class NumericFault {
  None,
  NoRayOffset,
  RayOffsetInMetres,
  RayOffsetByCoordinates,
  HitsNearOriginIgnored,
  HitsAtZeroSeenByCamera,
  CameraRaysStartBehind,
  ShadowRaysMeetLamp,
  ShadowRaysEndEarly,
  ShadowRaysTooShort,
  ShadingNormalDecidesSide,
  BackFacesBlack,
  CrackedEdges,
  ThinTrianglesDropped,
  EmptyTrianglesTurnNormals,
  UnnormalisedNormals,
  OriginNotMoved,
  NotRescaled,
  TexturePeriodsKept,
  VastInSingle,
  NaiveCone,
  SphereCentreInSingle,
  NaiveQuadratic,
  SolidAngleByAngles,
  PdfOfAnotherPoint,
  RouletteWithoutWeight,
  DepthLimited,
  MicrofacetsByCosine,
  GrazingViewsBlack,
  FresnelBySchlick,
  NearIndexIgnored,
  MirrorsMerged,
  SamplesClamped,
  HalfFloats,
  DenormalsFlushed
};

struct NumericFaultInfo {
  NumericFault fault;
  std::string_view name;
  std::string_view what;
};

inline constexpr std::array kNumericFaults{
    NumericFaultInfo{NumericFault::NoRayOffset, "no-ray-offset", "rays start at the rounded point itself"},
    NumericFaultInfo{NumericFault::RayOffsetInMetres, "ray-offset-in-metres",
                     "rays start a millimetre off their surface, whatever the size of the scene"},
    NumericFaultInfo{NumericFault::RayOffsetByCoordinates, "ray-offset-by-coordinates",
                     "rays start off their surface by 1e-5 of the largest coordinate of the triangle"},
    NumericFaultInfo{NumericFault::HitsNearOriginIgnored, "hits-near-origin-ignored",
                     "hits within 0.1 mm of the start of a ray do not count"},
    NumericFaultInfo{NumericFault::HitsAtZeroSeenByCamera, "hits-at-zero-seen-by-camera",
                     "a camera upon a surface sees it at distance zero in every direction"},
    NumericFaultInfo{NumericFault::CameraRaysStartBehind, "camera-rays-start-behind",
                     "camera rays start a micrometre behind the camera, so as to miss nothing before it"},
    NumericFaultInfo{NumericFault::ShadowRaysMeetLamp, "shadow-rays-meet-lamp",
                     "shadow rays end on the lamp itself, which can hide its own light"},
    NumericFaultInfo{NumericFault::ShadowRaysEndEarly, "shadow-rays-end-early",
                     "shadow rays end at 0.999 of the way, and what is beyond hides nothing"},
    NumericFaultInfo{NumericFault::ShadowRaysTooShort, "shadow-rays-too-short",
                     "shadow rays end after a thousandth of the way: their lengths are in another unit"},
    NumericFaultInfo{NumericFault::ShadingNormalDecidesSide, "shading-normal-decides-side",
                     "the shading normal alone decides on which side of a surface a path goes on"},
    NumericFaultInfo{
        NumericFault::BackFacesBlack, "back-faces-black",
        "the winding decides which side is outside, also where a matrix mirrors; the other is black"},
    NumericFaultInfo{NumericFault::CrackedEdges, "cracked-edges",
                     "the test of triangles leaves 1e-5 of their size uncovered along the edges"},
    NumericFaultInfo{NumericFault::ThinTrianglesDropped, "thin-triangles-dropped",
                     "triangles of less than 1e-5 of the area of their longest side squared are left out"},
    NumericFaultInfo{
        NumericFault::EmptyTrianglesTurnNormals, "empty-triangles-turn-normals",
        "an empty triangle gives its corners the normal (0, 0, 1), also where others share them"},
    NumericFaultInfo{NumericFault::UnnormalisedNormals, "unnormalised-normals",
                     "interpolated and mapped normals keep their length"},
    NumericFaultInfo{NumericFault::OriginNotMoved, "origin-not-moved",
                     "coordinates are floats relative to the origin of the scene, however far away it is"},
    NumericFaultInfo{NumericFault::NotRescaled, "not-rescaled",
                     "scenes of micrometres and of gigametres are computed in metres"},
    NumericFaultInfo{NumericFault::TexturePeriodsKept, "texture-periods-kept",
                     "coordinates of textures are rounded to floats before their whole periods are dropped"},
    NumericFaultInfo{NumericFault::VastInSingle, "vast-in-single",
                     "grounds and lamps that dwarf the scene are met in single precision"},
    NumericFaultInfo{NumericFault::NaiveCone, "naive-cone",
                     "the cone of a spherical lamp is 1 - sqrt(1 - sin^2) in single precision"},
    NumericFaultInfo{NumericFault::SphereCentreInSingle, "sphere-centre-in-single",
                     "places on a spherical lamp are floats before its centre is subtracted"},
    NumericFaultInfo{NumericFault::NaiveQuadratic, "naive-quadratic",
                     "rays meet balls by the discriminant b^2 - 4 a c in single precision"},
    NumericFaultInfo{NumericFault::SolidAngleByAngles, "solid-angle-by-angles",
                     "the solid angle of small rectangles is a sum of four angles in single precision"},
    NumericFaultInfo{NumericFault::PdfOfAnotherPoint, "pdf-of-another-point",
                     "BSDF samples that meet a lamp are weighted by the density at the start of their ray"},
    NumericFaultInfo{NumericFault::RouletteWithoutWeight, "roulette-without-weight",
                     "paths that survive Russian roulette carry no more than before"},
    NumericFaultInfo{NumericFault::DepthLimited, "depth-limited", "paths end after 32 reflections"},
    NumericFaultInfo{NumericFault::MicrofacetsByCosine, "microfacets-by-cosine",
                     "the GGX distribution is computed from 1 - cos^2"},
    NumericFaultInfo{NumericFault::GrazingViewsBlack, "grazing-views-black",
                     "surfaces that are seen at a cosine below 0.01 are black"},
    NumericFaultInfo{NumericFault::FresnelBySchlick, "fresnel-by-schlick",
                     "glass reflects by Schlick's polynomial"},
    NumericFaultInfo{NumericFault::NearIndexIgnored, "index-near-one-black",
                     "glass of an index within 0.001 of 1 lets nothing through"},
    NumericFaultInfo{NumericFault::MirrorsMerged, "mirrors-merged",
                     "parallel mirrors less than 1 cm apart are one"},
    NumericFaultInfo{NumericFault::SamplesClamped, "samples-clamped", "samples above 10 are cut to 10"},
    NumericFaultInfo{NumericFault::HalfFloats, "half-floats", "the image is written in half floats"},
    NumericFaultInfo{NumericFault::DenormalsFlushed, "denormals-flushed",
                     "numbers below 1.2e-38 are flushed to zero"}};

#ifdef ORBS_FAULTS
inline NumericFault active_fault = NumericFault::None;
inline bool has_fault(NumericFault fault) { return active_fault == fault; }
#else
constexpr bool has_fault(NumericFault) { return false; }
#endif

}  // namespace orbs::tracer
