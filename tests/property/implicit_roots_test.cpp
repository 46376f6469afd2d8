// No root of an implicit surface is passed over. The roots come from polynomials along the ray in quadruple
// precision, counted by Sturm's theorem, which shares nothing with the search by enclosures.
#include "scene/shapes/expression.h"
#include "tracer/shapes/implicit_boundary.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

using orbs::Vec3d;
using orbs::tracer::BoundaryHit;
using orbs::tracer::Crossing;
using orbs::tracer::ImplicitLeaf;
using orbs::tracer::LocalRay;
using orbs::tracer::RootCounts;
using orbs::tracer::Roots;

namespace {

__extension__ using Quad = __float128;
using Polynomial = std::vector<Quad>;  // coefficient of t^i

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial sum(std::max(a.size(), b.size()), 0);
  for (std::size_t i = 0; i < a.size(); ++i) sum[i] += a[i];
  for (std::size_t i = 0; i < b.size(); ++i) sum[i] += b[i];
  return sum;
}
Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial product(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  return product;
}
Polynomial number(Quad a) { return {a}; }
Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + number(-1) * b; }
Polynomial squared(const Polynomial& a) { return a * a; }

Quad value(const Polynomial& p, Quad t) {
  Quad sum = 0;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * t + p[i];
  return sum;
}

Quad magnitude(Quad a) { return a < 0 ? -a : a; }

// p, p', and the negated remainders; a remainder of nothing but rounding ends the sequence.
std::vector<Polynomial> sturm_sequence(Polynomial p) {
  while (p.size() > 1 && magnitude(p.back()) < 1e-28) p.pop_back();
  Polynomial slope;
  for (std::size_t i = 1; i < p.size(); ++i) slope.push_back(static_cast<Quad>(i) * p[i]);
  std::vector<Polynomial> sequence{p, slope};
  while (sequence.back().size() > 1) {
    Polynomial rest = sequence[sequence.size() - 2];
    const Polynomial& divisor = sequence.back();
    while (rest.size() >= divisor.size()) {
      const Quad factor = rest.back() / divisor.back();
      const std::size_t shift = rest.size() - divisor.size();
      for (std::size_t i = 0; i < divisor.size(); ++i) rest[i + shift] -= factor * divisor[i];
      rest.pop_back();
    }
    Quad largest = 0;
    for (const Quad c : rest) largest = std::max(largest, magnitude(c));
    if (rest.empty() || largest < 1e-26) break;
    for (Quad& c : rest) c /= -largest;
    while (rest.size() > 1 && magnitude(rest.back()) < 1e-26) rest.pop_back();
    sequence.push_back(rest);
  }
  return sequence;
}

int sign_changes(const std::vector<Polynomial>& sequence, Quad t) {
  int changes = 0;
  int last = 0;
  for (const auto& p : sequence) {
    const Quad v = value(p, t);
    const int sign = v > 0 ? 1 : (v < 0 ? -1 : 0);
    if (sign != 0 && last != 0 && sign != last) ++changes;
    if (sign != 0) last = sign;
  }
  return changes;
}

// The first root in (low, high], by bisection on the count of roots; where a single root is left and the
// polynomial changes its sign there, on the sign.
std::optional<double> first_root(const Polynomial& p, double low, double high) {
  const auto sequence = sturm_sequence(p);
  const int at_low = sign_changes(sequence, low);
  int at_high = sign_changes(sequence, high);
  if (at_low == at_high) return std::nullopt;
  Quad a = low;
  Quad b = high;
  for (int i = 0; i < 80; ++i) {
    const Quad middle = (a + b) / 2;
    const bool is_single = at_low - at_high == 1 && (value(p, a) < 0) != (value(p, b) < 0);
    const bool is_before =
        is_single ? (value(p, middle) < 0) == (value(p, a) < 0) : sign_changes(sequence, middle) == at_low;
    if (!is_before && !is_single) at_high = sign_changes(sequence, middle);
    (is_before ? a : b) = middle;
  }
  return static_cast<double>(b);
}

struct Axes {
  Polynomial x, y, z;
};
Axes along(const LocalRay& ray) {
  return {{ray.origin.x, ray.direction.x}, {ray.origin.y, ray.direction.y}, {ray.origin.z, ray.direction.z}};
}

// The double that the formula has, so that both mean the same surface.
const double kPhi = (1 + std::sqrt(5.0)) / 2;
const std::string kGolden = "((1 + sqrt(5)) / 2)";

Polynomial barth_sextic(const LocalRay& ray) {
  const auto [x, y, z] = along(ray);
  const Quad p2 = static_cast<Quad>(kPhi) * kPhi;
  const auto pair = [&](const Polynomial& a, const Polynomial& b) {
    return number(p2) * squared(a) - squared(b);
  };
  return number(4) * pair(x, y) * pair(y, z) * pair(z, x) -
         number(1 + 2 * static_cast<Quad>(kPhi)) * squared(squared(x) + squared(y) + squared(z) - number(1));
}

// Barth 1996, "Two projective surfaces with many nodes": 345 nodes, with w = 1.
Polynomial barth_decic(const LocalRay& ray) {
  const auto [x, y, z] = along(ray);
  const Quad phi = kPhi;
  const Quad p2 = phi * phi;
  const Quad p4 = p2 * p2;
  const auto pair = [&](const Polynomial& a, const Polynomial& b) {
    return squared(a) - number(p4) * squared(b);
  };
  const Polynomial x2 = squared(x);
  const Polynomial y2 = squared(y);
  const Polynomial z2 = squared(z);
  const Polynomial r2 = x2 + y2 + z2;
  const Polynomial quartics =
      squared(x2) + squared(y2) + squared(z2) - number(2) * (x2 * y2 + y2 * z2 + z2 * x2);
  return number(8) * pair(x, y) * pair(y, z) * pair(z, x) * quartics +
         number(3 + 5 * phi) * squared(r2 - number(1)) * squared(r2 - number(2 - phi));
}

std::string pair_text(const std::string& a, const std::string& b) {
  return "(" + a + "^2 - " + kGolden + "^4 * " + b + "^2)";
}

std::string decic_text() {
  return "8 * " + pair_text("x", "y") + " * " + pair_text("y", "z") + " * " + pair_text("z", "x") +
         " * (x^4 + y^4 + z^4 - 2 * (x^2 * y^2 + y^2 * z^2 + z^2 * x^2)) + (3 + 5 * " + kGolden +
         ") * (x^2 + y^2 + z^2 - 1)^2 * (x^2 + y^2 + z^2 - (2 - " + kGolden + "))^2";
}

std::string sextic_text() {
  const std::string p2 = kGolden + "^2";
  return "4 * (" + p2 + " * x^2 - y^2) * (" + p2 + " * y^2 - z^2) * (" + p2 + " * z^2 - x^2) - (1 + 2 * " +
         kGolden + ") * (x^2 + y^2 + z^2 - 1)^2";
}

ImplicitLeaf leaf_of(const std::string& formula, double half) {
  return {{orbs::scene::parse_expression(formula), {-half, -half, -half}, {half, half, half}, false}};
}

// Rays from a sphere around the box to points within it.
LocalRay random_ray(std::mt19937_64& random, double half) {
  std::uniform_real_distribution<double> even(-1, 1);
  const auto cube = [&] { return Vec3d{even(random), even(random), even(random)}; };
  Vec3d from = cube();
  while (length(from) < 0.1) from = cube();
  const Vec3d origin = normalised(from) * (4 * half);
  return {origin, normalised(cube() * half - origin)};
}

// Enough for a change to be seen; more on demand.
int ray_count() {
  const char* wanted = std::getenv("ORBS_ROOT_RAYS");
  return wanted == nullptr ? 1500 : std::atoi(wanted);
}

struct Tally {
  int hits = 0;
  int missed = 0;   // the search says later than Sturm, or never
  int phantom = 0;  // the search says earlier, and the polynomial is not tiny there
  int touching =
      0;  // the search says earlier, or a hit where there is none, and the polynomial is tiny there
  double largest_deviation = 0;  // of the roots that both find
};

// For the report of a run on demand (--gtest_output=json).
void record(const Tally& tally) {
  testing::Test::RecordProperty("rays", ray_count());
  testing::Test::RecordProperty("hits", tally.hits);
  testing::Test::RecordProperty("missed", tally.missed);
  testing::Test::RecordProperty("phantom", tally.phantom);
  testing::Test::RecordProperty("touching", tally.touching);
  testing::Test::RecordProperty("largest_deviation", std::to_string(tally.largest_deviation * 1e12) + "e-12");
}

Tally compare(const ImplicitLeaf& leaf, Polynomial (*polynomial)(const LocalRay&), double half) {
  std::mt19937_64 random(7);
  RootCounts counts;
  Tally tally;
  for (int i = 0; i < ray_count(); ++i) {
    const LocalRay ray = random_ray(random, half);
    const Polynomial p = polynomial(ray);
    const BoundaryHit found = next_boundary(leaf, ray, 0, Roots::All, counts);
    // The span of the box, in which alone the surface is defined.
    double low = 0;
    double high = 1e9;
    for (const auto& [o, d] :
         {std::array{ray.origin.x, ray.direction.x}, std::array{ray.origin.y, ray.direction.y},
          std::array{ray.origin.z, ray.direction.z}}) {
      low = std::max(low, std::min((-half - o) / d, (half - o) / d));
      high = std::min(high, std::max((-half - o) / d, (half - o) / d));
    }
    if (low >= high) continue;
    const auto exact = first_root(p, low, high);
    const double t = found.t;
    tally.hits += exact ? 1 : 0;
    constexpr double kTolerance = 1e-7;  // of double in double roots: the square root of its rounding
    if (exact && t > *exact + kTolerance && *exact < high - kTolerance) ++tally.missed;
    if (std::isfinite(t) && (!exact || t < *exact - kTolerance))
      ++(magnitude(value(p, t)) > 1e-11 ? tally.phantom : tally.touching);
    if (exact && std::abs(t - *exact) <= kTolerance)
      tally.largest_deviation = std::max(tally.largest_deviation, std::abs(t - *exact));
  }
  EXPECT_EQ(counts.unfinished, 0U);
  record(tally);
  return tally;
}

}  // namespace

TEST(ImplicitRoots, NoFirstRootOfTheBarthSexticIsPassedOver) {
  const auto tally = compare(leaf_of(sextic_text(), 2.2), barth_sextic, 2.2);
  EXPECT_GT(tally.hits, ray_count() / 3);
  EXPECT_EQ(tally.missed, 0);
  EXPECT_EQ(tally.phantom, 0);
}

TEST(ImplicitRoots, NoFirstRootOfTheBarthDecicIsPassedOver) {
  const auto tally = compare(leaf_of(decic_text(), 1.5), barth_decic, 1.5);
  EXPECT_GT(tally.hits, ray_count() / 3);
  EXPECT_EQ(tally.missed, 0);
  EXPECT_EQ(tally.phantom, 0);
}

// Two spheres whose radii differ by two steps of a double: f is below 1e-15 between them.
TEST(ImplicitRoots, ThinShellsTwoUlpsApartAreHit) {
  const auto leaf = leaf_of("(x^2 + y^2 + z^2 - 1) * (x^2 + y^2 + z^2 - 1.0000000000000004441)", 2);
  std::mt19937_64 random(11);
  RootCounts counts;
  for (int i = 0; i < ray_count(); ++i) {
    const LocalRay ray = random_ray(random, 2);
    const double middle = -dot(ray.origin, ray.direction);
    const Vec3d nearest = point_at(ray, middle);
    const double room = 1 - dot(nearest, nearest);
    const BoundaryHit found = next_boundary(leaf, ray, 0, Roots::All, counts);
    if (room < -1e-12) {
      EXPECT_TRUE(std::isinf(found.t)) << i;
    } else if (room > 1e-12) {
      // The error of the root grows as the ray becomes a tangent.
      EXPECT_NEAR(found.t, middle - std::sqrt(room), 1e-14 / std::sqrt(room) + 1e-13) << i;
    }
  }
  EXPECT_EQ(counts.unfinished, 0U);
}

// Nothing changes its sign: f is zero on the sphere and positive elsewhere.
TEST(ImplicitRoots, SurfacesThatOnlyTouchZeroAreHit) {
  const auto leaf = leaf_of("(x^2 + y^2 + z^2 - 1)^2", 1.5);
  RootCounts counts;
  const BoundaryHit found = next_boundary(leaf, {{0.1, 0.2, -5}, {0, 0, 1}}, 0, Roots::All, counts);
  EXPECT_NEAR(found.t, 5 - 0.9746794345, 1e-7);
  EXPECT_TRUE(std::isinf(next_boundary(leaf, {{0.1, 0.2, -5}, {0, 0, 1}}, 0, Roots::SignChanges, counts).t));
}

TEST(ImplicitRoots, APoleIsNoSurface) {
  const auto leaf = leaf_of("1 / x", 2);
  RootCounts counts;
  EXPECT_TRUE(std::isinf(next_boundary(leaf, {{-5, 0.1, 0.2}, {1, 0, 0}}, 0, Roots::All, counts).t));
  EXPECT_EQ(counts.undecided, 0U);
}

// y = sin(1 / x) has infinitely many roots near x = 0; the first ones are found, and the search ends.
TEST(ImplicitRoots, InfinitelyManyRootsEndAtTheLimit) {
  const auto leaf = leaf_of("y - sin(1 / x)", 2);
  RootCounts counts;
  const LocalRay ray{{0.5, 0.3, 0}, {-1, 0, 0}};
  double t = 0;
  // sin(1 / x) = 0.3 at 1 / x = asin(0.3) + 2 pi k and pi - asin(0.3) + 2 pi k; x = 0.5 is 1 / x = 2.
  for (const double inverse : {M_PI - std::asin(0.3), std::asin(0.3) + 2 * M_PI, 3 * M_PI - std::asin(0.3)}) {
    t = next_boundary(leaf, ray, t, Roots::All, counts).t;
    EXPECT_NEAR(0.5 - t, 1 / inverse, 1e-12);
  }
  const BoundaryHit last = next_boundary(leaf, ray, 0.5 - 1e-9, Roots::All, counts);
  EXPECT_NEAR(last.t, 0.5, 1e-8);
  EXPECT_GT(counts.unfinished + counts.undecided, 0U);
}

namespace {

struct Known {
  const char* name;
  const char* formula;
  double half;
  Vec3d origin;
  Vec3d direction;
  std::vector<double> roots;  // coordinate along the ray, the first ones
};

// Full bisection of dense samples in another program; rays along the axes through (0.1, 0.2), (0.3, 0.15) and
// (0.25, -0.35).
const Vec3d kAlongZ{0, 0, 1};
const Vec3d kAlongX{1, 0, 0};

const std::vector<Known>& known_roots() {
  static const std::vector<Known> kKnown{
      {"torus",
       "(x^2 + y^2 + z^2 + 1 - 0.16)^2 - 4 * (x^2 + y^2)",
       1.6,
       {-9, 0.3, 0.15},
       kAlongX,
       {-1.3375798476, -0.5530643283}},
      {"ding-dong", "x^2 + y^2 - (1 - z) * z^2", 2, {0.1, 0.2, -9}, kAlongZ, {-0.2038015805, 0.2599243340}},
      {"heart",
       "(x^2 + 9 * y^2 / 4 + z^2 - 1)^3 - x^2 * z^3 - 9 * y^2 * z^3 / 80",
       1.6,
       {0.1, 0.2, -9},
       kAlongZ,
       {-0.8345611468, 1.0784110948}},
      {"Barth sextic",
       "4*(((1+sqrt(5))/2)^2*x^2-y^2)*(((1+sqrt(5))/2)^2*y^2-z^2)*(((1+sqrt(5))/2)^2*z^2-x^2)"
       "-(2+sqrt(5))*(x^2+y^2+z^2-1)^2",
       2.2,
       {0.1, 0.2, -9},
       kAlongZ,
       {-1.0737039593, -0.9002934404}},
      {"Steiner",
       "x^2*y^2 + x^2*z^2 + y^2*z^2 + x*y*z",
       1.2,
       {-9, 0.3, 0.15},
       kAlongX,
       {-0.3483239697, -0.0516760303}},
      {"gyroid",
       "sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)",
       6.5,
       {0.1, 0.2, -9},
       kAlongZ,
       {-3.2420865198, -0.2936565072}},
      {"Klein",
       "(x^2+y^2+z^2+2*y-1)*((x^2+y^2+z^2-2*y-1)^2-8*z^2) + 16*x*z*(x^2+y^2+z^2-2*y-1)",
       4.5,
       {-9, 0.3, 0.15},
       kAlongX,
       {-1.7610105671, -1.1908782145}},
      {"superquartic", "x^4 + y^4 + z^4 - 1", 1.3, {0.1, 0.2, -9}, kAlongZ, {-0.9995747288, 0.9995747288}}};
  return kKnown;
}

}  // namespace

TEST(ImplicitRoots, ClassicsHaveTheirKnownRoots) {
  for (const auto& known : known_roots()) {
    const auto leaf = leaf_of(known.formula, known.half);
    RootCounts counts;
    double t = 0;
    for (const double root : known.roots) {
      const BoundaryHit found = next_boundary(leaf, {known.origin, known.direction}, t, Roots::All, counts);
      EXPECT_NEAR(found.t - 9, root, 2e-10) << known.name;
      t = found.t;
    }
  }
}

// The normal is the gradient's direction, whatever its length: squares of 1e-170 are zero in double.
TEST(ImplicitNormals, DoNotDependOnTheScaleOfTheFormula) {
  const Vec3d point{0.48, 0.6, 0.64};
  for (const char* scale : {"1", "1e-150", "1e-170", "1e-300", "1e150", "1e300"}) {
    const auto formula = orbs::scene::parse_expression(std::string(scale) + "*(x^2 + y^2 + z^2 - 1)");
    const Vec3d normal = orbs::tracer::implicit_normal(formula, point).value();
    EXPECT_NEAR(normal.x, point.x, 1e-12) << scale;
    EXPECT_NEAR(normal.y, point.y, 1e-12) << scale;
    EXPECT_NEAR(normal.z, point.z, 1e-12) << scale;
  }
}
