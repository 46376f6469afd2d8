#include "registry/analytic.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

using json::ObjectReader;

std::vector<Vec3d> load_corners(ObjectReader& in, const std::string& key) {
  std::vector<Vec3d> corners;
  for (const auto& row : in.number_rows(key, 3)) corners.push_back({row[0], row[1], row[2]});
  if (corners.size() < 3) in.fail(key, fmt::format("must hold at least 3 points, holds {}", corners.size()));
  return corners;
}

Vec3d load_unit(ObjectReader& in, const std::string& key) {
  const auto direction = in.vec3(key);
  if (!(length(direction) > 0)) in.fail(key, "must be a direction, is zero");
  return normalised(direction);
}

AnalyticShape load_shape(ObjectReader& in) {
  if (in.has("corners")) return FlatPolygon{load_corners(in, "corners")};
  if (in.has("normal"))
    return RoundDisk{in.vec3("centre"), load_unit(in, "normal"), in.number("radius", json::kPositive)};
  return FormulaSphere{in.vec3("centre"), in.number("radius", json::kPositive)};
}

Vec3d normal_of(const std::vector<Vec3d>& corners) {
  return cross(corners[1] - corners[0], corners[2] - corners[0]);
}

// Only then does a ray meet the polygon's plane in one point at all times.
void check_stays_in_plane(const ObjectReader& in, const FlatPolygon& polygon) {
  constexpr double kRounding = 1e-9;
  const auto& [start, end] = polygon;
  if (end.size() != start.size())
    in.fail("end_corners", fmt::format("must be as many as 'corners', {}", start.size()));
  const Vec3d normal = normalised(normal_of(start));
  for (const Vec3d corner : end)
    if (std::fabs(dot(normal, corner - start.front())) > kRounding * (1 + largest_magnitude(corner)))
      in.fail("end_corners", "must lie in the plane of 'corners': other motion has no closed form here");
  if (!(dot(normal, normal_of(end)) > 0)) in.fail("end_corners", "must run the same way round as 'corners'");
}

void load_end(ObjectReader& in, AnalyticShape& shape) {
  if (!in.has("end_corners")) return;
  auto* polygon = std::get_if<FlatPolygon>(&shape);
  if (polygon == nullptr) in.fail("end_corners", "only polygons move");
  polygon->end_corners = load_corners(in, "end_corners");
  check_stays_in_plane(in, *polygon);
}

void load_detail(ObjectReader& in, AnalyticSurface& surface) {
  const auto* polygon = std::get_if<FlatPolygon>(&surface.shape);
  if (polygon == nullptr || !polygon->end_corners.empty())
    in.fail("", "only polygons that rest have 'opacity' and 'shading_normal'");
  surface.opacity = in.number_or("opacity", 1, {0, 1});
  if (!in.has("shading_normal")) return;
  if (!surface.reflectance)
    in.fail("shading_normal", "is that of a surface that is lit: give it a reflectance");
  surface.shading_normal = load_unit(in, "shading_normal");
}

AnalyticSurface load_surface(ObjectReader in) {
  AnalyticSurface surface{load_shape(in), in.number_or("radiance", 0, json::kNotNegative), {}};
  load_end(in, surface.shape);
  if (in.has("reflectance")) {
    if (std::holds_alternative<RoundDisk>(surface.shape))
      in.fail("reflectance", "only polygons and spheres are lit; give the disk a radiance");
    surface.reflectance = in.number("reflectance", {0, 1});
  }
  if (in.has("opacity") || in.has("shading_normal")) load_detail(in, surface);
  in.finish();
  return surface;
}

std::vector<std::pair<double, double>> load_candela(ObjectReader& in) {
  std::vector<std::pair<double, double>> candela;
  for (const auto& row : in.number_rows("candela", 2)) candela.emplace_back(row[0], row[1]);
  if (candela.size() < 2 || !std::is_sorted(candela.begin(), candela.end()))
    in.fail("candela", "must hold at least two pairs of degrees and factor, by ascending degrees");
  return candela;
}

AnalyticLight load_light(ObjectReader in) {
  AnalyticLight light;
  if (in.has("position")) {
    light.position = in.vec3("position");
    light.strength = in.number("intensity", json::kNotNegative);
    if (in.has("cone")) {
      light.direction = load_unit(in, "direction");
      const auto cone = in.numbers("cone", 2, {0, 180});
      if (cone[0] > cone[1]) in.fail("cone", "must hold the inner half angle before the outer one");
      light.cone_deg = std::array{cone[0], cone[1]};
    }
    if (in.has("candela")) light.candela = load_candela(in);
  } else {
    light.direction = load_unit(in, "direction");
    light.strength = in.number("irradiance", json::kNotNegative);
  }
  in.finish();
  return light;
}

AnalyticSource load_source(ObjectReader in) {
  AnalyticSource source{load_shape(in), in.number_or("radiance", 0, json::kNotNegative), {}, {}, {}};
  load_end(in, source.shape);
  if (in.has("window")) source.window = load_corners(in, "window");
  if (in.has("candela")) {
    source.candela_centre = in.vec3("candela_centre");
    source.candela = load_candela(in);
  }
  in.finish();
  return source;
}

void load_shutter(ObjectReader& in, DirectLight& image) {
  const auto is_moving = [](const auto& one) {
    const auto* polygon = std::get_if<FlatPolygon>(&one.shape);
    return polygon != nullptr && !polygon->end_corners.empty();
  };
  const bool moves = std::any_of(image.surfaces.begin(), image.surfaces.end(), is_moving) ||
                     std::any_of(image.sources.begin(), image.sources.end(), is_moving);
  if (moves != in.has("shutter"))
    in.fail("shutter", moves ? "is needed where something has 'end_corners'"
                             : "has no effect: nothing has 'end_corners'");
  if (!moves) return;
  const auto times = in.numbers("shutter", 2, {0, 1});
  if (!(times[0] < times[1])) in.fail("shutter", "must open before it closes");
  image.shutter = std::array{times[0], times[1]};
}

DirectLight load_direct_light(ObjectReader& in) {
  DirectLight image;
  image.environment = in.number_or("environment", 0, json::kNotNegative);
  for (auto& entry : in.objects("surfaces")) image.surfaces.push_back(load_surface(std::move(entry)));
  for (auto& entry : in.objects_or_none("sources")) image.sources.push_back(load_source(std::move(entry)));
  for (auto& entry : in.objects_or_none("lights")) image.lights.push_back(load_light(std::move(entry)));
  if (image.surfaces.empty()) in.fail("surfaces", "must hold at least one surface");
  image.has_shadows = in.boolean_or("shadows", false);
  const bool has_detail = std::any_of(image.surfaces.begin(), image.surfaces.end(), [](const auto& surface) {
    return surface.opacity < 1 || surface.shading_normal;
  });
  if (has_detail && !(image.sources.empty() && image.environment == 0))
    in.fail("surfaces",
            "with 'opacity' or 'shading_normal' have a closed form here in the light of 'lights' alone");
  load_shutter(in, image);
  if (image.shutter && !image.lights.empty())
    in.fail("lights", "have no closed form here where something moves: their shadows have hard edges");
  const auto is_polygon = [](const auto& one) { return std::holds_alternative<FlatPolygon>(one.shape); };
  if (image.has_shadows && !(std::all_of(image.surfaces.begin(), image.surfaces.end(), is_polygon) &&
                             std::all_of(image.sources.begin(), image.sources.end(), is_polygon)))
    in.fail("shadows", "have a closed form where all surfaces and sources are polygons");
  return image;
}

std::array<double, 3> three_numbers(ObjectReader& in, const std::string& key, json::Range range) {
  const auto numbers = in.numbers(key, 3, range);
  return {numbers[0], numbers[1], numbers[2]};
}

FresnelPlane load_fresnel_plane(ObjectReader& in) {
  FresnelPlane image;
  image.normal = load_unit(in, "normal");
  image.n = three_numbers(in, "n", json::kPositive);
  if (in.has("k")) image.k = three_numbers(in, "k", json::kNotNegative);
  image.radiance = in.number("radiance", json::kPositive);
  constexpr int kMostPlates = 1000;
  image.plates = in.integer_or("plates", 0, 0, kMostPlates);
  return image;
}

PolarisedPlanes load_polarised_planes(ObjectReader& in) {
  PolarisedPlanes image;
  for (auto& entry : in.objects("planes")) {
    image.planes.push_back({load_unit(entry, "normal"), entry.number("n", json::kPositive),
                            entry.number_or("k", 0, json::kNotNegative)});
    entry.finish();
  }
  if (image.planes.empty()) in.fail("planes", "must hold at least one plane");
  image.radiance = in.number("radiance", json::kPositive);
  return image;
}

// The quadrature of lobes that are narrower would need more nodes.
constexpr json::Range kWideAlpha{0.1, 1};

PlasticBrdf load_plastic(ObjectReader& in) {
  PlasticBrdf plastic{in.number("plastic_ior", {1, 4}), in.boolean_or("nonlinear", false), 0};
  if (in.has("plastic_alpha")) plastic.alpha = in.number("plastic_alpha", kWideAlpha);
  return plastic;
}

BallBrdf load_ball_brdf(ObjectReader& in) {
  std::vector<BallBrdf> all;
  if (in.has("oren_nayar_roughness"))
    all.emplace_back(OrenNayarBrdf{in.number("oren_nayar_roughness", {0, 1})});
  if (in.has("ggx_alpha")) all.emplace_back(GgxBrdf{in.number("ggx_alpha", kWideAlpha)});
  if (in.has("metal_alpha")) all.emplace_back(MetalBrdf{in.number("metal_alpha", kWideAlpha)});
  if (in.has("metallic"))
    all.emplace_back(MetallicRoughnessBrdf{in.number("metallic", {0, 1}), in.number("roughness", {0.32, 1})});
  if (in.has("phong_exponent")) all.emplace_back(PhongBrdf{in.number("phong_exponent", {0, 100})});
  if (in.has("plastic_ior")) all.emplace_back(load_plastic(in));
  if (all.size() != 1)
    in.fail("",
            "needs one of 'oren_nayar_roughness', 'ggx_alpha', 'metal_alpha', 'metallic', 'phong_exponent' "
            "and 'plastic_ior'");
  return all.front();
}

AlbedoBall load_albedo_ball(ObjectReader& in) {
  const auto centre = in.vec3("centre");
  const double radius_m = in.number("radius", json::kPositive);
  return {centre, radius_m, in.number("reflectance", {0, 1}), load_ball_brdf(in)};
}

SkyBall load_sky_ball(ObjectReader& in) {
  SkyBall image{in.vec3("centre"), in.number("radius", json::kPositive), in.number("reflectance", {0, 1}),
                three_numbers(in, "constant", json::kNotNegative)};
  const auto rows = in.number_rows("gradients", 3);
  if (rows.size() != 3) in.fail("gradients", "needs one for each of the three channels");
  for (std::size_t c = 0; c < 3; ++c) {
    image.gradients.at(c) = {rows[c][0], rows[c][1], rows[c][2]};
    if (length(image.gradients.at(c)) > image.constant.at(c))
      in.fail_at("gradients", c,
                 "is longer than the constant, so that some directions would shine below zero");
  }
  image.shows_sky = in.boolean_or("shows_sky", true);
  return image;
}

MirrorCorridor load_mirror_corridor(ObjectReader& in) {
  return {in.number("half_width", json::kPositive), in.number("floor"), in.number("reflectance", {0, 1})};
}

PlaneWrap load_wrap(ObjectReader& in, const std::string& key) {
  const auto word = in.one_of_or(key, "repeat", {"repeat", "clamp", "mirror"});
  if (word == "mirror") return PlaneWrap::Mirror;
  return word == "clamp" ? PlaneWrap::Clamp : PlaneWrap::Repeat;
}

TexturedPlane load_textured_plane(ObjectReader& in) {
  TexturedPlane image{in.vec3("origin"), in.vec3("u_edge"), in.vec3("v_edge"), 1, {}, {}, false, 1};
  if (!(length(cross(image.u_edge, image.v_edge)) > 0)) in.fail("v_edge", "must not be parallel to 'u_edge'");
  for (const auto& row : in.number_rows("texels", 3)) image.texels.push_back({row[0], row[1], row[2]});
  constexpr int kMostColumns = 1024;
  image.columns = in.integer("columns", 1, kMostColumns);
  if (image.texels.empty() || static_cast<int>(image.texels.size()) % image.columns != 0)
    in.fail("texels",
            fmt::format("must be rows of {} colours, holds {}", image.columns, image.texels.size()));
  image.wrap = {load_wrap(in, "wrap_u"), load_wrap(in, "wrap_v")};
  image.is_nearest = in.one_of_or("filter", "linear", {"linear", "nearest"}) == "nearest";
  image.radiance = in.number("radiance", json::kPositive);
  return image;
}

AnalyticImage load_image(ObjectReader& in) {
  const auto formula = in.one_of("formula", {"constant", "direct_light", "fresnel_plane", "polarised_planes",
                                             "albedo_ball", "sky_ball", "mirror_corridor", "textured_plane"});
  if (formula == "constant") return ConstantImage{three_numbers(in, "value", json::kNotNegative)};
  if (formula == "direct_light") return load_direct_light(in);
  if (formula == "fresnel_plane") return load_fresnel_plane(in);
  if (formula == "polarised_planes") return load_polarised_planes(in);
  if (formula == "albedo_ball") return load_albedo_ball(in);
  if (formula == "sky_ball") return load_sky_ball(in);
  if (formula == "textured_plane") return load_textured_plane(in);
  return load_mirror_corridor(in);
}

}  // namespace

AnalyticReference load_analytic(ObjectReader in) {
  AnalyticReference reference{load_image(in), in.text("law"), in.text("source")};
  if (reference.law.empty()) in.fail("law", "must say by which formula the image is known");
  if (reference.source.empty()) in.fail("source", "must say where the formula comes from");
  in.finish();
  return reference;
}

}  // namespace orbs::registry
