// Polarised images against the electric field itself (polarised_field.h) and closed forms. An image and that
// of the light alone share their wavelengths, hence most of their noise; if all paths hit the same surfaces,
// their quotient is exact.
#include "property/light_images.h"
#include "property/polarised_field.h"

#include <numbers>

#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::tests;

constexpr double kRadians = std::numbers::pi / 180;
const std::string kStokes = R"(, "outputs": {"stokes": true})";
constexpr std::array kNames{"S0.R", "S1.R", "S2.R", "S3.R"};

using StokesVector = std::array<double, 4>;

// The image of `content` divided by what the camera would record of an unpolarised environment of 1.
std::array<Estimate, 4> stokes(const View& view, const std::string& content, int samples_per_pixel = 512) {
  const auto bare =
      image_of(scene_of(view, R"("environment": [1, 1, 1], "materials": [])" + kStokes), samples_per_pixel);
  const auto image = image_of(scene_of(view, content + kStokes), samples_per_pixel);
  const double unpolarised_light = mean_of(bare, "S0.R");
  std::array<Estimate, 4> s;
  for (std::size_t k = 0; k < s.size(); ++k) {
    s[k] = estimate_of(image, kNames[k]);
    s[k].mean /= unpolarised_light;
    s[k].error /= unpolarised_light;
  }
  return s;
}

void expect_stokes(const std::array<Estimate, 4>& found, const StokesVector& expected) {
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(found[k].mean, expected[k], 4 * found[k].error + 1e-6) << kNames[k];
    EXPECT_LT(found[k].error, 0.0015) << kNames[k];
  }
}

// For paths that scatter once, which Russian roulette never ends.
void expect_exact_stokes(const std::array<Estimate, 4>& found,
                         const StokesVector& expected,
                         double tolerance) {
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(found[k].mean, expected[k], tolerance) << kNames[k];
}

std::string polariser(const std::string& name, Vec3d axis) {
  return fmt::format(R"({{"name": "{}", "type": "polariser", "axis": {}}})", name, text_of(axis));
}

std::string retarder(Vec3d fast_axis, double retardance_deg) {
  return fmt::format(R"({{"name": "retarder", "type": "retarder", "axis": {}, "retardance_deg": {}}})",
                     text_of(fast_axis), retardance_deg);
}

// The default camera looks along -z at thin elements one behind the other, the first the nearest.
std::string sheets_before_light(const std::vector<std::string>& materials,
                                const std::vector<std::string>& names) {
  std::vector<std::string> sheets;
  for (std::size_t i = 0; i < names.size(); ++i)
    sheets.push_back(square({0, 0, 3 - static_cast<double>(i)}, {0, 0, 1}, 1, names[i]));
  return fmt::format(R"("environment": [1, 1, 1], "materials": [{}], {})", fmt::join(materials, ", "),
                     meshes(sheets));
}

Vec3d axis_at(double degrees) { return {std::cos(degrees * kRadians), std::sin(degrees * kRadians), 0}; }

}  // namespace

// The first transmits half, the second cos^2 of that.
TEST(PolarisedLight, TwoPolarisersFollowMalus) {
  for (const double degrees : {0, 15, 30, 45, 60, 75, 90}) {
    const auto s =
        stokes({.width = 16, .height = 16},
               sheets_before_light({polariser("near", axis_at(degrees)), polariser("far", axis_at(0))},
                                   {"near", "far"}));
    const double passed = std::pow(std::cos(degrees * kRadians), 2) / 2;
    expect_stokes(
        s, {passed, passed * std::cos(2 * degrees * kRadians), passed * std::sin(2 * degrees * kRadians), 0});
  }
}

// Between two crossed polarisers there are three more, each rotated by 22.5 degrees: cos^8(22.5 degrees) / 2
// is transmitted.
TEST(PolarisedLight, FivePolarisersFannedOverARightAngleLetLightThrough) {
  std::vector<std::string> materials;
  std::vector<std::string> names;
  for (const double degrees : {0.0, 22.5, 45.0, 67.5, 90.0}) {
    names.push_back(fmt::format("p{}", names.size()));
    materials.push_back(polariser(names.back(), axis_at(degrees)));
  }
  const auto s0 = stokes({.width = 16, .height = 16}, sheets_before_light(materials, names))[0];
  EXPECT_NEAR(s0.mean, 0.26539502, 4 * s0.error);
}

// The signs as defined in the header of data/snippets/fresnel_mueller.h: S1 > 0 along x, to the right; S2 > 0
// at +45 degrees, right and up.
TEST(PolarisedLight, StokesVectorsAreInTheFrameOfTheImage) {
  const auto through = [](Vec3d axis, const std::string& up) {
    return stokes({.up = up}, sheets_before_light({polariser("p", axis)}, {"p"}), 4);
  };
  expect_exact_stokes(through({1, 0, 0}, "[0, 1, 0]"), {0.5, 0.5, 0, 0}, 1e-6);
  expect_exact_stokes(through({0, 1, 0}, "[0, 1, 0]"), {0.5, -0.5, 0, 0}, 1e-6);
  expect_exact_stokes(through({1, 1, 0}, "[0, 1, 0]"), {0.5, 0, 0.5, 0}, 1e-6);
  // A camera rolled clockwise by 45 degrees has the x axis of the world to its right and up.
  expect_exact_stokes(through({1, 0, 0}, "[1, 1, 0]"), {0.5, 0, 0.5, 0}, 1e-6);
}

// With the fast axis to the right and light at +45 degrees, Ey lags a quarter wave behind Ex. When Ex is
// largest, Ey is zero and grows, so for the viewer the field rotates counter-clockwise: left-circular, S3 <
// 0.
TEST(PolarisedLight, AQuarterWaveRetarderMakesCircularLightOfTheStatedSign) {
  const auto through = [](Vec3d fast, double retardance_deg) {
    return stokes(
        {.width = 16, .height = 16},
        sheets_before_light({retarder(fast, retardance_deg), polariser("p", {1, 1, 0})}, {"retarder", "p"}));
  };
  expect_stokes(through({1, 0, 0}, 90), {0.5, 0, 0, -0.5});
  expect_stokes(through({0, 1, 0}, 90), {0.5, 0, 0, 0.5});
  expect_stokes(through({1, 0, 0}, 180), {0.5, 0, -0.5, 0});
  expect_stokes(through({1, 0, 0}, 60), {0.5, 0, 0.25, -0.25 * std::sqrt(3)});
}

// The axis is a world direction: it is projected into a tilted element, and from there across the light. An
// axis along the light leaves a projection, too.
TEST(PolarisedLight, TheAxisOfATiltedPolariserLiesInTheSheet) {
  const Vec3d normal = normalised(Vec3d{0.3, 1, 0.8});
  for (const Vec3d axis : {Vec3d{1, 0.2, 0}, Vec3d{1, 0.5, 1}, Vec3d{0, 0, 1}}) {
    const auto content =
        fmt::format(R"("environment": [1, 1, 1], "materials": [{}], {})", polariser("filter", axis),
                    meshes({square({0, 0, 0}, normal, 1, "filter")}));
    const Beam beam = polarised_along(
        unpolarised({0, 0, 1}), axis - normal * (axis.x * normal.x + axis.y * normal.y + axis.z * normal.z));
    expect_exact_stokes(stokes({}, content, 4), stokes_of(beam, {1, 0, 0}), 2e-6);
  }
}

namespace {

// A glass surface at Brewster's angle, seen from -x; the light is where its reflection is visible.
constexpr double kIndex = 1.5;
std::string brewster_scene(const std::vector<std::string>& filters, const std::vector<std::string>& sheets) {
  const Vec3d to_light = normalised(Vec3d{kIndex, 1, 0});
  auto materials = filters;
  materials.push_back(R"({"name": "glass", "type": "dielectric", "index": 1.5})");
  materials.push_back(R"({"name": "light", "type": "emission", "radiance": [1, 1, 1]})");
  auto squares = sheets;
  squares.push_back(square({0, 0, 0}, {0, 1, 0}, 1, "glass"));
  squares.push_back(square(to_light * 5, to_light, 1, "light"));
  return fmt::format(R"("materials": [{}], {})", fmt::join(materials, ", "), meshes(squares));
}

const Vec3d kBrewsterEye = normalised(Vec3d{-kIndex, 1, 0}) * 5;

image::Image brewster_image(const std::string& content, int samples_per_pixel) {
  return image_of(scene_of({.position = text_of(kBrewsterEye)}, content + kStokes), samples_per_pixel);
}

}  // namespace

// At tan(angle) = index r_p = 0, and ((n^2 - 1) / (n^2 + 1))^2 / 2 of unpolarised light is reflected.
TEST(PolarisedLight, AtBrewstersAngleTheReflectionIsExtinctThroughTheCrossedPolariser) {
  const double kept = std::pow((kIndex * kIndex - 1) / (kIndex * kIndex + 1), 2) / 2;
  const auto open = brewster_image(brewster_scene({}, {}), 64);
  const auto open_s0 = estimate_of(open, "S0.R");
  EXPECT_NEAR(open_s0.mean, kept, 4 * open_s0.error);
  // Right is z here, across the plane of incidence: all reflected light is polarised along it.
  EXPECT_NEAR(mean_of(open, "S1.R") / open_s0.mean, 1, 1e-6);
  const auto through = [](Vec3d axis, int samples_per_pixel) {
    return brewster_image(
        brewster_scene({polariser("filter", axis)}, {square(kBrewsterEye * 0.5, kBrewsterEye, 1, "filter")}),
        samples_per_pixel);
  };
  // Roulette survives with the square root of the throughput: for 1e-6 these are ten of ten thousand
  // reflected paths.
  const double crossed = mean_of(through({1, kIndex, 0}, 2048), "S0.R");
  EXPECT_LT(std::abs(crossed), 1e-6 * open_s0.mean);
  RecordProperty("extinction", fmt::format("{:.2e}", crossed / open_s0.mean));
  const auto aligned = estimate_of(through({0, 0, 1}, 64), "S0.R");
  EXPECT_NEAR(aligned.mean, kept, 4 * aligned.error);
}

namespace {

// A camera ray in direction `first` hits mirrors that reflect it in the other directions, one after the
// other.
struct Zigzag {
  Vec3d eye;
  std::vector<Vec3d> normals;  // of the mirrors
  std::vector<std::string> squares;
  Vec3d last_point;
};

Zigzag zigzag(const std::vector<Vec3d>& directions, const std::vector<std::string>& materials) {
  Zigzag out{normalised(directions[0]) * -3, {}, {}, {}};
  for (std::size_t i = 0; i + 1 < directions.size(); ++i) {
    out.normals.push_back(normalised(normalised(directions[i + 1]) - normalised(directions[i])));
    out.squares.push_back(square(out.last_point, out.normals.back(), 0.3, materials[i]));
    out.last_point += normalised(directions[i + 1]) * 2;
  }
  return out;
}

const std::vector<Vec3d> kOutOfPlane{{1, -0.4, 0.2}, {1, 0.6, 0.5}, {0.5, 0.2, 1}, {1, 0.6, 0.1}};

}  // namespace

// The planes of incidence differ, so the second metal makes the polarised light of the first elliptical.
TEST(PolarisedLight, MetalReflectionsOutOfPlaneFollowTheField) {
  const std::vector<Complex> metals{{0.2, 3.4}, {2.9, 3.0}, {1.1, 6.9}};
  std::vector<std::string> materials;
  for (std::size_t i = 0; i < metals.size(); ++i)
    materials.push_back(
        fmt::format(R"({{"name": "m{}", "type": "conductor", "index": {{"n": {}, "k": {}}}}})", i,
                    metals[i].real(), metals[i].imag()));
  for (const std::size_t mirrors : {1U, 2U, 3U}) {
    const std::vector<Vec3d> directions(kOutOfPlane.begin(),
                                        kOutOfPlane.begin() + 1 + static_cast<int>(mirrors));
    const auto path = zigzag(directions, {"m0", "m1", "m2"});
    Beam beam = unpolarised(-directions.back());
    for (std::size_t i = mirrors; i-- > 0;) beam = reflected(beam, path.normals[i], metals[i]);
    const Vec3d right = cross(normalised(directions[0]), Vec3d{0, 1, 0});
    const auto s = stokes({.position = text_of(path.eye), .width = 16, .height = 16},
                          fmt::format(R"("environment": [1, 1, 1], "materials": [{}], {})",
                                      fmt::join(materials, ", "), meshes(path.squares)));
    expect_stokes(s, stokes_of(beam, right));
    // Otherwise the test could not fail.
    if (mirrors == 2) {
      EXPECT_GT(std::abs(s[3].mean), 0.01);
    }
  }
}

// ORB.S's mirror preserves the degree of polarisation and reverses the handedness.
TEST(PolarisedLight, PerfectMirrorsTurnThePlaneOfPolarisation) {
  const auto path = zigzag({kOutOfPlane[0], kOutOfPlane[1], kOutOfPlane[2]}, {"mirror", "mirror"});
  const Vec3d axis{1, 0.5, 0};
  auto squares = path.squares;
  squares.push_back(square(path.last_point, kOutOfPlane[2], 0.3, "filter"));
  const Beam behind = polarised_along(unpolarised(-kOutOfPlane[2]), axis);
  const Beam beam = mirrored(mirrored(behind, path.normals[1]), path.normals[0]);
  const Vec3d right = cross(normalised(kOutOfPlane[0]), Vec3d{0, 1, 0});
  const auto s = stokes(
      {.position = text_of(path.eye), .width = 16, .height = 16},
      fmt::format(
          R"("environment": [1, 1, 1], "materials": [{{"name": "mirror", "type": "mirror", "reflectance": [1, 1, 1]}}, {}], {})",
          polariser("filter", axis), meshes(squares)));
  expect_stokes(s, stokes_of(beam, right));
}

// A right-angled prism rotates the light of a 45 degree polariser by total reflection, which changes only its
// phases. Reflections at the two faces add R^2 = 0.16 % after three total reflections, and so on.
TEST(PolarisedLight, TotalReflectionInAPrismShiftsPhases) {
  const Vec3d axis{1, 0, 1};
  const auto content = fmt::format(
      R"("materials": [{{"name": "light", "type": "emission", "radiance": [1, 1, 1]}}, )"
      R"({{"name": "glass", "type": "dielectric", "index": 1.5}}, {}], {})",
      polariser("filter", axis),
      meshes({square({0, 0, 1}, {0, 0, 1}, 1, "glass"), square({0, 0, 0}, {0, 1, -1}, std::sqrt(2), "glass"),
              square({0, -1, 0}, {0, -1, 0}, 1, "glass"), square({0, -2, 0}, {0, 1, 0}, 1, "filter"),
              square({0, -3, 0}, {0, 1, 0}, 1, "light")}));
  const auto image = image_of(scene_of({.width = 16, .height = 16}, content + kStokes), 128);
  const Vec3d hypotenuse = normalised(Vec3d{0, 1, -1});
  Beam beam = dimmed(polarised_along(unpolarised({0, 1, 0}), axis), 0.96);  // amplitude: T of both faces
  StokesVector expected{};
  for (int pairs_of_reflections = 0; pairs_of_reflections < 4; ++pairs_of_reflections) {
    beam = reflected(beam, hypotenuse, 1 / 1.5);
    const auto s = stokes_of(beam, {1, 0, 0});
    for (std::size_t k = 0; k < 4; ++k) expected[k] += s[k];
    // Reflected at the face before the camera and again at the other; r = -0.2 inside, twice.
    beam.direction = -beam.direction;
    beam = reflected(dimmed(beam, 0.2), hypotenuse, 1 / 1.5);
    beam.direction = -beam.direction;
    beam = dimmed(beam, 0.2);
  }
  EXPECT_GT(std::abs(expected[3]), 0.1);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto found = estimate_of(image, kNames[k]);
    EXPECT_NEAR(found.mean, expected[k], 4 * found.error + 1e-6) << kNames[k];
    EXPECT_LT(found.error, 0.002);
  }
}

// All interreflections between the two faces: T = (1 - R) / (1 + R), for each polarisation separately. A
// renderer without polarisation has (1 - mean R) / (1 + mean R), which is 3.6 % less at 75 degrees.
TEST(PolarisedLight, AGlassSlabTransmitsEachPolarisationByItself) {
  for (const double degrees : {30, 60, 75}) {
    const double cos_i = std::cos(degrees * kRadians);
    const double beyond = std::sqrt(2.25 - 1 + cos_i * cos_i);
    const double r_s = std::pow((cos_i - beyond) / (cos_i + beyond), 2);
    const double r_p = std::pow((2.25 * cos_i - beyond) / (2.25 * cos_i + beyond), 2);
    const Vec3d eye{5 * std::sin(degrees * kRadians), 0, 5 * cos_i};
    const auto content =
        R"("materials": [{"name": "light", "type": "emission", "radiance": [1, 1, 1]},
                         {"name": "glass", "type": "dielectric", "index": 1.5}], )" +
        meshes({square({0, 0, 0}, {0, 0, 1}, 10, "glass"), square({0, 0, -0.1}, {0, 0, -1}, 10, "glass"),
                square({0, 0, -1}, {0, 0, 1}, 20, "light")}) +
        kStokes;
    auto image = image_of(scene_of({.position = text_of(eye), .width = 16, .height = 16}, content), 128);
    // Up is across the plane of incidence. S0 and S1 are replaced by s and p.
    const auto s0 = channel_of(image, "S0.R");
    const auto s1 = channel_of(image, "S1.R");
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const float sum = image.at(x, y, s0);
        const float difference = image.at(x, y, s1);
        image.at(x, y, s0) = sum - difference;
        image.at(x, y, s1) = sum + difference;
      }
    const auto s = estimate_of(image, "S0.R");
    const auto p = estimate_of(image, "S1.R");
    EXPECT_NEAR(s.mean, (1 - r_s) / (1 + r_s), 4 * s.error) << degrees;
    EXPECT_NEAR(p.mean, (1 - r_p) / (1 + r_p), 4 * p.error) << degrees;
    EXPECT_LT(s.error + p.error, 0.01);
    RecordProperty(fmt::format("s_and_p_at_{}", degrees), fmt::format("{:.5f} {:.5f}", s.mean, p.mean));
  }
}

namespace {

// A floor of the material under a large light, seen at 65 degrees; a dimmer light is below it.
image::Image lit_floor(const std::string& material) {
  const auto content =
      R"("materials": [{"name": "m", )" + material +
      R"(}, {"name": "glow", "type": "emission", "radiance": [0.2, 0.2, 0.2]}], )" +
      meshes({square({0, 0, 0}, {0, 1, 0}, 1, "m"), square({0, -1, 0}, {0, 1, 0}, 30, "glow")}) +
      R"(, "lights": [{"type": "rect", "half_width": 3, "half_length": 3, "radiance": [1, 1, 1],
                       "matrix": [{"translate": [2.7, 1.26, 0]}, {"rotate_z": -65}]}])" +
      kStokes;
  return image_of(
      scene_of({.position = "[-9.063, 4.226, 0]", .up = "[0.3, 1, 0.8]", .width = 16, .height = 16}, content),
      64);
}

}  // namespace

// Light sampling and BSDF sampling are polarised alike by the microfacets of a rough surface: an almost
// smooth surface shows the same as a smooth one.
TEST(PolarisedLight, AnAlmostSmoothSurfacePolarisesAsASmoothOne) {
  for (const std::string material :
       {R"("type": "conductor", "index": {"n": 2.9, "k": 3.0})", R"("type": "dielectric", "index": 1.5)",
        R"("type": "dielectric", "index": 1.5, "film": {"index": 2.2, "height_nm": 300})"})
    for (const std::string roughness :
         {R"(, "alpha": 0.002)", R"(, "alpha": 0.002, "distribution": "beckmann")"}) {
      const auto smooth = lit_floor(material);
      const auto rough = lit_floor(material + roughness);
      for (const char* channel : kNames) {
        const auto a = estimate_of(smooth, channel);
        const auto b = estimate_of(rough, channel);
        EXPECT_NEAR(a.mean, b.mean, 4 * std::hypot(a.error, b.error) + 1e-4)
            << material << roughness << " " << channel;
      }
      EXPECT_GT(std::abs(mean_of(smooth, "S2.R")), 0.02) << material;
    }
}

// Light sampled by way of a flat mirror is polarised like light that paths find there. A wall hides the light
// itself from the floor.
TEST(PolarisedLight, LightByAFlatMirrorIsAsPolarisedAsLightThatFindsIt) {
  const auto text = scene_of(
      {.position = "[0, 2, 6]", .look_at = "[0, 0, 0]", .fov_deg = 2, .width = 16, .height = 16},
      R"("materials": [{"name": "floor", "type": "conductor", "index": {"n": 2.9, "k": 3.0}, "alpha": 0.5},
                       {"name": "mirror", "type": "mirror", "reflectance": [1, 1, 1]},
                       {"name": "wall", "type": "lambert", "reflectance": [0, 0, 0]}], )" +
          meshes({square({0, 0, 0}, {0, 1, 0}, 3, "floor"), square({-2, 2, -1}, {1, 0, 0.3}, 2, "mirror"),
                  square({0.5, 0.3, -0.1}, {1, 0, 0}, 0.5, "wall")}) +
          R"(, "lights": [{"type": "rect", "half_width": 0.7, "half_length": 0.7, "radiance": [20, 20, 20],
                           "matrix": [{"translate": [2.5, 2, -1]}, {"rotate_z": -90}]}])" +
          kStokes);
  const auto asked = image_of(text, 256);
  const auto found = image_of(text, 1024, {.mirrored_light = false}, 2);
  for (const char* channel : kNames) {
    const auto a = estimate_of(asked, channel);
    const auto b = estimate_of(found, channel);
    EXPECT_NEAR(a.mean, b.mean, 4 * std::hypot(a.error, b.error)) << channel;
    EXPECT_LT(b.error, 0.06 * mean_of(asked, "S0.R")) << channel;
  }
  EXPECT_GT(std::abs(mean_of(asked, "S2.R")), 0.1 * mean_of(asked, "S0.R"));
}
