// A small path tracer for the scenes of orbs, to copy from: this file alone, with libpng for textures.
//
//   g++ -O3 -std=c++20 -pthread minimal_renderer.cpp -lpng -o minimal-renderer
//   ./minimal-renderer SCENE OUTPUT [--spp N] [--seed N] [--threads N] [--bug half-pixel|gamma|mis]
//
// It reads orbs-scene/1 in the form that renderers are given (docs/reference/scene-format.md), and writes an
// EXR. It declares G3/M4/L2/A1: instances of meshes, diffuse surfaces with textures, emission, mirrors, lamps
// that are rectangles, disks or spheres, and a limit of scatterings. What it does not know, it refuses.
//
// --bug is an exercise. It makes a usual mistake, to see what orbs says of it:
//   half-pixel  rays pass through the square about a pixel's corner, and not through the pixel
//   gamma       the image is encoded for a screen
//   mis         light is counted twice: where an emitter is sampled, and where a ray meets it by chance
#include <algorithm>
#include <array>
#include <atomic>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <png.h>

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = HUGE_VAL;
constexpr int kUnlimited = INT_MAX;  // trace depth

[[noreturn]] void fail(const std::string& what) { throw std::runtime_error(what); }

struct Vec {
  double x = 0, y = 0, z = 0;
};
constexpr std::array kAxes{&Vec::x, &Vec::y, &Vec::z};
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
Vec operator*(Vec a, double s) { return {a.x * s, a.y * s, a.z * s}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
double length(Vec a) { return std::sqrt(dot(a, a)); }
Vec normalised(Vec a) { return length(a) > 0 ? a * (1 / length(a)) : a; }
double luminance(Vec rgb) { return dot(rgb, {0.2126, 0.7152, 0.0722}); }

// The direction whose angle to the axis has that cosine, turned about it by a share of the circle.
Vec direction_about(Vec axis, double cosine, double turn) {
  const Vec x = normalised(cross(std::abs(axis.x) > 0.5 ? Vec{0, 1, 0} : Vec{1, 0, 0}, axis));
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return (x * std::cos(2 * kPi * turn) + cross(axis, x) * std::sin(2 * kPi * turn)) * sine + axis * cosine;
}

// Numbers in [0, 1). Those that a path needs first follow a Richtmyer sequence, i √p for the prime p of their
// dimension, which leaves fewer gaps than chance; each pixel shifts it by chance (Cranley and Patterson
// 1976).
struct Random {
  std::mt19937_64 engine{};
  std::array<double, 12> shifts{};
  int sample = 0;
  std::size_t dimension = 0;

  Random(int seed, int pixel) {
    std::seed_seq both{seed, pixel};
    engine.seed(both);
    for (double& shift : shifts) shift = by_chance();
  }
  double by_chance() { return static_cast<double>(engine() >> 11) * 0x1p-53; }
  double next() {
    constexpr std::array primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
    if (dimension == primes.size()) return by_chance();
    const double x = shifts[dimension] + sample * std::sqrt(primes[dimension]);
    ++dimension;
    return x - std::floor(x);
  }
};

// ---- The scene: all of it becomes triangles, lamps too

struct Texture {
  int width = 0, height = 0;
  std::vector<Vec> texels{};  // linear, from the top
};

struct Material {
  enum class Kind { Lambert, Mirror, Emission, Lamp } kind = Kind::Lambert;  // a lamp is black from behind
  Vec colour;                                                                // reflectance or radiance
  const Texture* texture = nullptr;
};

struct Vertex {
  Vec position, normal;
  double u = 0, v = 0;
};

struct Triangle {
  std::array<Vertex, 3> corners;
  const Material* material = nullptr;
};

// A few triangles, or two halves.
struct Box {
  Vec low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};
  std::span<const Triangle> triangles{};
  std::vector<Box> halves{};
  double Vec::*axis = nullptr;  // along which they lie
};

struct Scene {
  Vec eye, forward, right, up, environment;  // right and up reach from the centre of the image to its edges
  int width = 0, height = 0, trace_depth = kUnlimited;
  std::map<std::string, Texture> textures{};
  std::map<std::string, Material> materials{};
  std::vector<Triangle> triangles{};
  Box all{};
  std::map<double, const Triangle*> emitters{};  // by the power of all up to this one
};

// ---- Files

std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) fail("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

// A number of a binary file, in which it lies as in the memory of this machine.
template <typename T>
T take(const std::string& data, std::size_t& at) {
  T value{};
  if (at + sizeof value > data.size()) fail("a file ends too early");
  std::memcpy(&value, data.data() + at, sizeof value);
  at += sizeof value;
  return value;
}

template <typename T>
std::string bytes(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

// Of a pixel or a byte.
std::size_t place_of(int x, int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

// A JSON file as its words and numbers by their places: "/lights/0/radiance/2". Each is taken once. What is
// left over is not known here, and to skip it would make a wrong image that looks right.
struct Document {
  std::string text;
  std::size_t at = 0;
  std::map<std::string, std::string> words{};
  std::map<std::string, int> sizes{};  // of lists

  char next() { return text[at = std::min(text.find_first_not_of(" \t\r\n,:", at), text.size())]; }
  std::string word() {
    const bool is_quoted = next() == '"';
    const std::size_t begin = is_quoted ? at + 1 : at;
    at = std::min(text.find_first_of(is_quoted ? "\"\\" : " \t\r\n,:]}", begin), text.size());
    if (text[at] == '\\') fail("a word with a backslash is not known");
    return text.substr(begin, (is_quoted ? at++ : at) - begin);
  }
  void read(const std::string& place) {
    const char first = next();
    if (first != '{' && first != '[') {
      words[place] = word();
      return;
    }
    for (++at; next() != '}' && next() != ']'; ++sizes[place]) {
      if (at == text.size()) fail("the scene ends too early");
      const std::string key = first == '{' ? word() : std::to_string(sizes[place]);
      read(place + "/" + key);
    }
    ++at;
  }
  std::vector<std::string> list(const std::string& place) {
    std::vector<std::string> places;
    for (int i = 0; i < sizes[place]; ++i) places.push_back(place + "/" + std::to_string(i));
    return places;
  }
  std::string take(const std::string& place) {
    if (!words.contains(place)) fail("the scene lacks " + place);
    return words.extract(place).mapped();
  }
  double number(const std::string& place) {
    const std::string word = take(place);
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0') fail(place + " is " + word + ", and a number was expected");
    return value;
  }
  Vec vec(const std::string& place) {
    return {number(place + "/0"), number(place + "/1"), number(place + "/2")};
  }
};

// An EXR of lines that are not compressed, up to its pixels: each line has the floats of B, then of G, then
// of R.
std::string exr_header(int width, int height) {
  const std::string zero(1, '\0'), one = bytes(1.0F);
  const std::string window = bytes(0) + bytes(0) + bytes(width - 1) + bytes(height - 1);
  std::string channels, out = bytes(20000630) + bytes(2);
  for (const char* name : {"B", "G", "R"})
    channels += name + zero + bytes(2) + bytes(0) + bytes(1) + bytes(1);
  const auto attribute = [&](const char* name, const char* type, const std::string& data) {
    out += name + zero + type + zero + bytes(static_cast<int>(data.size())) + data;
  };
  attribute("channels", "chlist", channels + zero);
  attribute("compression", "compression", zero);
  attribute("dataWindow", "box2i", window);
  attribute("displayWindow", "box2i", window);
  attribute("lineOrder", "lineOrder", zero);
  attribute("pixelAspectRatio", "float", one);
  attribute("screenWindowCenter", "v2f", bytes(0.0F) + bytes(0.0F));
  attribute("screenWindowWidth", "float", one);
  out += zero;
  const std::size_t first = out.size() + sizeof first * static_cast<std::size_t>(height);
  for (int y = 0; y < height; ++y) out += bytes(first + place_of(0, y, 8 + 12 * width));
  return out;
}

void write_exr(const Scene& scene, const std::vector<Vec>& pixels, const std::string& file) {
  std::string out = exr_header(scene.width, scene.height);
  for (int y = 0; y < scene.height; ++y) {
    out += bytes(y) + bytes(12 * scene.width);
    for (const auto channel : {&Vec::z, &Vec::y, &Vec::x})
      for (int x = 0; x < scene.width; ++x)
        out += bytes(static_cast<float>(pixels[place_of(x, y, scene.width)].*channel));
  }
  if (!std::ofstream(file, std::ios::binary).write(out.data(), std::ssize(out))) fail("cannot write " + file);
}

// A texture is an EXR in the uv pass of `orbs probe` alone, and then of this size and kind.
Texture read_exr(const std::string& file) {
  constexpr int side = 256;
  const std::string data = read_file(file), header = exr_header(side, side);
  if (!data.starts_with(header)) fail(file + " is another EXR than that of orbs probe");
  Texture texture{side, side, std::vector<Vec>(side * side)};
  std::size_t at = header.size();
  for (int y = 0; y < side; ++y) {
    at += 8;
    for (const auto channel : {&Vec::z, &Vec::y, &Vec::x})
      for (int x = 0; x < side; ++x) texture.texels[place_of(x, y, side)].*channel = take<float>(data, at);
  }
  return texture;
}

double srgb_decoded(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
double srgb_encoded(double c) { return c <= 0.0031308 ? c * 12.92 : 1.055 * std::pow(c, 1 / 2.4) - 0.055; }

Texture read_png(const std::string& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&png, file.c_str()) == 0) fail(file + ": " + png.message);
  png.format = PNG_FORMAT_RGB;
  std::vector<png_byte> rgb(std::size_t{3} * png.width * png.height);
  if (png_image_finish_read(&png, nullptr, rgb.data(), 0, nullptr) == 0) fail(file + ": " + png.message);
  Texture texture{static_cast<int>(png.width), static_cast<int>(png.height)};
  const auto decoded = [&](std::size_t i) { return srgb_decoded(rgb[i] / 255.0); };
  for (std::size_t i = 0; i < rgb.size(); i += 3)
    texture.texels.push_back({decoded(i), decoded(i + 1), decoded(i + 2)});
  return texture;
}

// ---- From the files to triangles

struct Matrix {
  Vec x, y, z, origin;  // columns

  Vec point(Vec p) const { return x * p.x + y * p.y + z * p.z + origin; }
  // By the inverse transpose, whose sign is that of the determinant.
  Vec normal(Vec n) const {
    const Vec turned = cross(y, z) * n.x + cross(z, x) * n.y + cross(x, y) * n.z;
    return normalised(turned * dot(x, cross(y, z)));
  }
};

Matrix read_matrix(Document& in, const std::string& place) {
  std::array<double, 16> m{};  // row by row
  for (std::size_t i = 0; i < m.size(); ++i) m[i] = in.number(place + "/" + std::to_string(i));
  return {{m[0], m[4], m[8]}, {m[1], m[5], m[9]}, {m[2], m[6], m[10]}, {m[3], m[7], m[11]}};
}

struct Mesh {
  std::string ply;
  std::vector<const Material*> materials;
};

void add_instance(Scene& scene, const Mesh& mesh, const Matrix& matrix) {
  std::size_t vertex_count = 0, face_count = 0;
  int header = 0;  // its length
  std::sscanf(mesh.ply.c_str(),
              "ply format binary_little_endian 1.0 element vertex %zu property float x property float y "
              "property float z property float nx property float ny property float nz property float tx "
              "property float ty property float tz property float u property float v element face %zu "
              "property list uchar uint vertex_indices property int material end_header%n",
              &vertex_count, &face_count, &header);
  if (header == 0) fail("a mesh has another header than the scene format says");
  auto at = static_cast<std::size_t>(header) + 1;
  std::vector<Vertex> vertices(vertex_count);
  for (auto& vertex : vertices) {
    std::array<float, 11> f{};
    for (float& number : f) number = take<float>(mesh.ply, at);
    vertex = {matrix.point({f[0], f[1], f[2]}), matrix.normal({f[3], f[4], f[5]}), f[9], f[10]};
  }
  for (; face_count > 0; --face_count) {
    ++at;  // over the number of corners
    Triangle& triangle = scene.triangles.emplace_back();
    for (auto& corner : triangle.corners) corner = vertices.at(take<std::uint32_t>(mesh.ply, at));
    triangle.material = mesh.materials.at(take<std::uint32_t>(mesh.ply, at));
  }
}

// Lamps become a grid of points. Without L3 they are only moved.
void add_lamp(Scene& scene, Document& in, const std::string& place) {
  constexpr Vec down{0, -1, 0};
  const std::string type = in.take(place + "/type");
  const bool is_rect = type == "rect", is_sphere = type == "sphere";
  if (!is_rect && !is_sphere && type != "disk") fail("a lamp of the type " + type + " is not known");
  const int rows = is_sphere ? 64 : 1, columns = is_rect ? 1 : 128;
  const double step = 2 * kPi / columns;  // a polygon of this radius has the area of the circle:
  const double half_x = is_rect ? in.number(place + "/half_width")
                                : in.number(place + "/radius") * std::sqrt(step / std::sin(step));
  const double half_z = is_rect ? in.number(place + "/half_length") : half_x;
  const Vec centre = read_matrix(in, place + "/matrix").origin;
  const auto point = [&](int row, int column) {
    const double s = 1.0 * row / rows, t = 1.0 * column / columns;
    if (is_rect) return Vec{(2 * s - 1) * half_x, 0, (2 * t - 1) * half_z};
    return direction_about(down, is_sphere ? std::cos(kPi * s) : 0, t) * (is_sphere ? half_x : s * half_x);
  };
  const Material& material = scene.materials[place] = {Material::Kind::Lamp, in.vec(place + "/radiance")};
  for (int i = 0; i < rows * columns; ++i) {
    const int row = i / columns, column = i % columns;
    const Vec a = point(row, column), d = point(row + 1, column + 1), normal = is_sphere ? a + d : down;
    for (const Vec b : {point(row + 1, column), point(row, column + 1)})
      scene.triangles.push_back(
          {{{{centre + a, normal}, {centre + b, normal}, {centre + d, normal}}}, &material});
  }
}

Material read_material(Document& in, const std::string& place, const Scene& scene) {
  using Kind = Material::Kind;
  const std::string type = in.take(place + "/type");
  if (type == "emission") return {Kind::Emission, in.vec(place + "/radiance")};
  if (type == "mirror") return {Kind::Mirror, in.vec(place + "/reflectance")};
  if (type != "lambert") fail("a material of the type " + type + " is not known");
  Material out{Kind::Lambert, in.vec(place + "/reflectance")};
  if (!in.words.contains(place + "/texture/name")) return out;
  out.texture = &scene.textures.at(in.take(place + "/texture/name"));
  const Vec uv = read_matrix(in, place + "/texture/matrix").point({2, 3, 0});
  if (uv.x != 2 || uv.y != 3) fail("a texture has a matrix, which needs M5");
  return out;
}

void read_camera(Document& in, Scene& scene) {
  scene.width = static_cast<int>(in.number("/camera/width"));
  scene.height = static_cast<int>(in.number("/camera/height"));
  scene.eye = in.vec("/camera/position");
  scene.forward = normalised(in.vec("/camera/look_at") - scene.eye);
  const Vec right = normalised(cross(scene.forward, in.vec("/camera/up")));
  const double half = std::tan(in.number("/camera/fov_y") * kPi / 360);
  scene.up = cross(right, scene.forward) * half;
  scene.right = right * (half * scene.width / scene.height);
}

void read_scene(const std::filesystem::path& file, Scene& scene) {
  Document in{read_file(file)};
  in.read("");
  if (in.take("/format") != "orbs-scene/1") fail("expected a scene of the format orbs-scene/1");
  read_camera(in, scene);
  scene.environment = in.vec("/environment");
  if (in.words["/integrator/trace_depth"] == "unlimited")
    in.words.erase("/integrator/trace_depth");
  else
    scene.trace_depth = static_cast<int>(in.number("/integrator/trace_depth"));
  for (const auto& place : in.list("/textures")) {
    const std::string name = in.take(place + "/file");
    if (in.take(place + "/wrap_u") + in.take(place + "/wrap_v") != "repeatrepeat")
      fail("a texture is clamped");
    scene.textures[in.take(place + "/name")] = name.ends_with(".exr") ? read_exr(name) : read_png(name);
  }
  for (const auto& place : in.list("/materials"))
    scene.materials[in.take(place + "/name")] = read_material(in, place, scene);
  std::map<std::string, Mesh> meshes;
  for (const auto& place : in.list("/meshes")) {
    Mesh& mesh = meshes[in.take(place + "/name")];
    mesh.ply = read_file(file.parent_path() / in.take(place + "/file"));
    for (const auto& slot : in.list(place + "/materials"))
      mesh.materials.push_back(&scene.materials.at(in.take(slot)));
  }
  for (const auto& place : in.list("/instances"))
    add_instance(scene, meshes.at(in.take(place + "/mesh")), read_matrix(in, place + "/matrix"));
  for (const auto& place : in.list("/lights")) add_lamp(scene, in, place);
  for (const char* unused : {"/camera/near", "/camera/far", "/camera/focus_distance"}) in.words.erase(unused);
  for (const auto& [place, word] : in.words)
    if (!place.ends_with("/name")) fail(place + " is not known");
}

// ---- The tree of boxes

// Halves the triangles at the median of their centres, along the longest side of their box.
Box box_of(std::span<Triangle> triangles) {
  Box box;
  for (const auto& triangle : triangles)
    for (const auto& corner : triangle.corners)
      for (const auto axis : kAxes) {
        box.low.*axis = std::min(box.low.*axis, corner.position.*axis);
        box.high.*axis = std::max(box.high.*axis, corner.position.*axis);
      }
  if (triangles.size() <= 4) {
    box.triangles = triangles;
    return box;
  }
  const Vec size = box.high - box.low;
  const auto axis = size.x > std::max(size.y, size.z) ? &Vec::x : size.y > size.z ? &Vec::y : &Vec::z;
  const auto centre = [axis](const Triangle& triangle) {
    const auto& [a, b, c] = triangle.corners;
    return a.position.*axis + b.position.*axis + c.position.*axis;
  };
  const std::size_t half = triangles.size() / 2;
  std::nth_element(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(half), triangles.end(),
                   [&](const Triangle& a, const Triangle& b) { return centre(a) < centre(b); });
  box.axis = axis;
  box.halves.push_back(box_of(triangles.first(half)));
  box.halves.push_back(box_of(triangles.subspan(half)));
  return box;
}

struct Ray {
  Vec origin, direction;
  bool is_shadow = false;  // any hit will do
  Vec inverse{1 / direction.x, 1 / direction.y, 1 / direction.z};
};

struct Hit {
  double distance = kInfinity;
  const Triangle* triangle = nullptr;
  double b = 0, c = 0;  // shares of the second and the third corner
};

// Moeller and Trumbore 1997.
void meet(const Triangle& triangle, const Ray& ray, Hit& nearest) {
  constexpr double least = 1e-6;  // what is nearer is the surface that the ray leaves
  const Vec corner = triangle.corners[0].position;
  const Vec ab = triangle.corners[1].position - corner, ac = triangle.corners[2].position - corner;
  const Vec p = cross(ray.direction, ac), s = ray.origin - corner, q = cross(s, ab);
  const double scale = 1 / dot(ab, p);
  const double b = dot(s, p) * scale, c = dot(ray.direction, q) * scale, distance = dot(ac, q) * scale;
  if (b >= 0 && c >= 0 && b + c <= 1 && distance > least && distance < nearest.distance)
    nearest = {ray.is_shadow ? -1 : distance, &triangle, b, c};
}

void meet(const Box& box, const Ray& ray, Hit& nearest) {
  double enters = 0, leaves = nearest.distance;
  for (const auto axis : kAxes) {
    const double one = (box.low.*axis - ray.origin.*axis) * ray.inverse.*axis;
    const double other = (box.high.*axis - ray.origin.*axis) * ray.inverse.*axis;
    enters = std::max(enters, std::min(one, other));
    leaves = std::min(leaves, std::max(one, other));
  }
  if (enters > leaves) return;
  for (const auto& triangle : box.triangles) meet(triangle, ray, nearest);
  if (box.halves.empty()) return;
  const bool is_first_nearer = ray.direction.*box.axis > 0;
  meet(box.halves[is_first_nearer ? 0 : 1], ray, nearest);
  meet(box.halves[is_first_nearer ? 1 : 0], ray, nearest);
}

// ---- Light

// Bilinear between the centres of four texels; v = 0 is the bottom of the image.
Vec texel_at(const Texture& texture, double u, double v) {
  const double x = u * texture.width - 0.5, y = (1 - v) * texture.height - 0.5;
  const auto wrapped = [](double i, int size) { return static_cast<int>(i - size * std::floor(i / size)); };
  Vec sum;
  for (const double i : {std::floor(x), std::floor(x) + 1})
    for (const double j : {std::floor(y), std::floor(y) + 1})
      sum = sum +
            texture.texels[place_of(wrapped(i, texture.width), wrapped(j, texture.height), texture.width)] *
                ((1 - std::abs(x - i)) * (1 - std::abs(y - j)));
  return sum;
}

struct Surface {
  Vec position, normal, geometric;  // the latter on the side of the normal
  double u = 0, v = 0;
  const Material* material = nullptr;

  bool emits() const {
    return material->kind == Material::Kind::Emission || material->kind == Material::Kind::Lamp;
  }
  bool shines(Vec to_viewer) const {
    return emits() && (material->kind == Material::Kind::Emission || dot(geometric, to_viewer) > 0);
  }
};

Surface surface_at(const Triangle& triangle, double b, double c) {
  const auto& [p, q, r] = triangle.corners;
  const double a = 1 - b - c;
  const Vec normal = normalised(p.normal * a + q.normal * b + r.normal * c);
  Vec geometric = normalised(cross(q.position - p.position, r.position - p.position));
  if (dot(normal, geometric) < 0) geometric = geometric * -1;
  const Vec position = p.position * a + q.position * b + r.position * c;
  return {position,
          length(normal) > 0 ? normal : geometric,
          geometric,
          p.u * a + q.u * b + r.u * c,
          p.v * a + q.v * b + r.v * c,
          triangle.material};
}

// By their power, so that a point of an emitter is chosen with a density of its luminance over the sum.
void find_emitters(Scene& scene) {
  double sum = 0;
  for (const auto& triangle : scene.triangles) {
    const auto& [a, b, c] = triangle.corners;
    const double area = length(cross(b.position - a.position, c.position - a.position)) / 2;
    const double power = area * luminance(triangle.material->colour);
    if (surface_at(triangle, 0, 0).emits() && power > 0) scene.emitters[sum += power] = &triangle;
  }
}

// The same over the solid angle about the point from which it is chosen.
double light_density(const Scene& scene, const Surface& light, Vec from) {
  const Vec way = light.position - from;
  const double density = luminance(light.material->colour) / scene.emitters.rbegin()->first;
  return density * dot(way, way) * length(way) / std::abs(dot(light.geometric, way));
}

// Light of a random point of an emitter that a diffuse surface of reflectance 1 reflects. As a path may also
// meet the point by chance, the two share it by the balance heuristic (Veach 1997, 9.2.2).
Vec direct_light(const Scene& scene, const Surface& at, Random& random, bool is_shared) {
  if (scene.emitters.empty()) return {};
  const auto emitter = scene.emitters.upper_bound(random.next() * scene.emitters.rbegin()->first);
  if (emitter == scene.emitters.end()) return {};  // by rounding
  const double root = std::sqrt(random.next());
  const Surface light = surface_at(*emitter->second, 1 - root, root * random.next());
  const Vec way = light.position - at.position, direction = normalised(way);
  const double chance = dot(at.normal, direction) / kPi;  // the density of meeting it
  if (chance <= 0 || dot(at.geometric, direction) <= 0 || !light.shines(direction * -1)) return {};
  Hit shadow{length(way) * (1 - 1e-6)};
  meet(scene.all, {at.position, direction, true}, shadow);
  if (shadow.triangle != nullptr) return {};
  const double density = light_density(scene, light, at.position);
  return light.material->colour * (chance / (density + (is_shared ? chance : 0)));
}

// Along one path from the eye.
Vec radiance_along(const Scene& scene, Vec direction, Random& random, bool is_shared) {
  Vec sum, weight{1, 1, 1}, origin = scene.eye;
  double chance = kInfinity;  // the density of this direction; infinite where it is the only one
  for (int scatterings = 0;; ++scatterings) {
    Hit hit;
    meet(scene.all, {origin, direction}, hit);
    if (hit.triangle == nullptr) return sum + weight * scene.environment;
    Surface at = surface_at(*hit.triangle, hit.b, hit.c);
    if (at.shines(direction * -1) && luminance(at.material->colour) > 0) {
      const double density = is_shared ? light_density(scene, at, origin) : 0;
      sum = sum + weight * at.material->colour * (1 / (1 + density / chance));
    }
    if (at.emits() || scatterings == scene.trace_depth) return sum;
    const double side = dot(at.normal, direction) < 0 ? 1 : -1;  // that of the viewer
    at.normal = at.normal * side;
    at.geometric = at.geometric * side;
    if (dot(at.geometric, direction) >= 0) return sum;  // the two normals disagree about it
    weight = weight * at.material->colour;
    if (at.material->texture != nullptr) weight = weight * texel_at(*at.material->texture, at.u, at.v);
    if (scene.trace_depth == kUnlimited && scatterings > 3) {  // Russian roulette
      const double survives = std::min(1.0, luminance(weight));
      if (random.next() >= survives) return sum;
      weight = weight * (1 / survives);
    }
    if (at.material->kind == Material::Kind::Mirror) {
      direction = direction - at.normal * (2 * dot(at.normal, direction));
      chance = kInfinity;
    } else {
      sum = sum + weight * direct_light(scene, at, random, is_shared);
      const double cosine = std::sqrt(random.next());
      direction = direction_about(at.normal, cosine, random.next());
      chance = cosine / kPi;
    }
    if (dot(at.geometric, direction) <= 0) return sum;  // they disagree about the way on
    origin = at.position;
  }
}

// ---- The image

struct Options {
  int spp, threads;
  int seed;
  std::string bug;
};

Options read_options(const std::vector<std::string>& words) {
  std::map<std::string, std::string> values{
      {"--spp", "16"}, {"--seed", "1"}, {"--threads", "1"}, {"--bug", "none"}};
  if (words.size() < 2 || words.size() % 2 != 0)
    fail("expected SCENE OUTPUT, and a value behind each option");
  for (std::size_t i = 2; i < words.size(); i += 2) {
    if (!values.contains(words[i])) fail(words[i] + " is not known");
    values[words[i]] = words[i + 1];
  }
  if (!std::set<std::string>{"none", "half-pixel", "gamma", "mis"}.contains(values["--bug"]))
    fail("no such bug");
  return {std::stoi(values["--spp"]), std::stoi(values["--threads"]), std::stoi(values["--seed"]),
          values["--bug"]};
}

void render_rows(const Scene& scene,
                 const Options& options,
                 std::atomic<int>& next_row,
                 std::vector<Vec>& pixels) {
  const double shift = options.bug == "half-pixel" ? 0.5 : 0;
  for (int y = next_row++; y < scene.height; y = next_row++)
    for (int x = 0; x < scene.width; ++x) {
      const std::size_t place = place_of(x, y, scene.width);
      Random random(options.seed, static_cast<int>(place));  // the same in any thread
      Vec sum;
      for (; random.sample < options.spp; ++random.sample) {
        random.dimension = 0;
        const double across = 2 * (x - shift + random.next()) / scene.width - 1;
        const double along = 1 - 2 * (y - shift + random.next()) / scene.height;
        const Vec direction = normalised(scene.forward + scene.right * across + scene.up * along);
        sum = sum + radiance_along(scene, direction, random, options.bug != "mis") * (1.0 / options.spp);
      }
      pixels[place] = sum;
      if (options.bug == "gamma")
        pixels[place] = {srgb_encoded(sum.x), srgb_encoded(sum.y), srgb_encoded(sum.z)};
    }
}

void render(const std::vector<std::string>& words) {
  const Options options = read_options(words);
  Scene scene;
  read_scene(words[0], scene);
  scene.all = box_of(scene.triangles);
  find_emitters(scene);
  std::vector<Vec> pixels(static_cast<std::size_t>(scene.width * scene.height));
  std::atomic<int> next_row = 0;
  std::vector<std::jthread> threads;
  for (int i = 0; i < options.threads; ++i)
    threads.emplace_back([&] { render_rows(scene, options, next_row, pixels); });
  threads.clear();  // waits for their ends
  write_exr(scene, pixels, words[1]);
}

}  // namespace

int main(int count, char** words) {
  try {
    render({words + 1, words + count});
    return 0;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "minimal-renderer: %s\n", problem.what());
    return 1;
  }
}
