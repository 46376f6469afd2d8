#include "tracer/accel/accel.h"

#include "tracer/accel/solid_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include <embree3/rtcore.h>

namespace orbs::tracer {

namespace {

constexpr std::size_t kPacket = 16;

// Distance along the ray to the unit disk y = 0 or the unit sphere in the local space of the shape, in double
// precision because the origin may be far away in units of the shape. Nothing outside (near, far).
std::optional<double> disk_distance(Vec3d o, Vec3d d, double near, double far) {
  const double t = -o.y / d.y;
  if (!(t > near && t < far)) return std::nullopt;
  const double x = o.x + t * d.x;
  const double z = o.z + t * d.z;
  return x * x + z * z <= 1 ? std::optional(t) : std::nullopt;
}

std::optional<double> sphere_distance(Vec3d o, Vec3d d, double near, double far) {
  // Solved from the point of closest approach, as b^2 - 4ac cancels for small distant spheres (Haines et al.
  // 2019, Ray Tracing Gems, ch. 7).
  const double dd = dot(d, d);
  const double middle = -dot(o, d) / dd;
  const Vec3d nearest = o + d * middle;
  const double room = 1 - dot(nearest, nearest);
  if (room < 0) return std::nullopt;
  const double half = std::sqrt(room / dd);
  for (const double t : {middle - half, middle + half})
    if (t > near && t < far) return t;
  return std::nullopt;
}

struct CurvedSurface {
  Vec3d centre;
  std::array<Vec3d, 3> inverse_rows;
  bool is_sphere = false;
};

std::array<Vec3d, 3> inverse_rows(Vec3d a, Vec3d b, Vec3d c) {
  const double determinant = dot(a, cross(b, c));
  return {cross(b, c) / determinant, cross(c, a) / determinant, cross(a, b) / determinant};
}

std::optional<double> distance_to(
    const CurvedSurface& surface, Vec3f origin, Vec3f direction, float near, float far) {
  const auto local = [&](Vec3d v) {
    return Vec3d{dot(surface.inverse_rows[0], v), dot(surface.inverse_rows[1], v),
                 dot(surface.inverse_rows[2], v)};
  };
  const Vec3d o = local(cast<double>(origin) - surface.centre);
  const Vec3d d = local(cast<double>(direction));
  return surface.is_sphere ? sphere_distance(o, d, near, far) : disk_distance(o, d, near, far);
}

std::optional<double> distance_to(const CurvedSurface& surface,
                                  RTCRayN* rays,
                                  unsigned int n,
                                  unsigned int i) {
  return distance_to(surface,
                     {RTCRayN_org_x(rays, n, i), RTCRayN_org_y(rays, n, i), RTCRayN_org_z(rays, n, i)},
                     {RTCRayN_dir_x(rays, n, i), RTCRayN_dir_y(rays, n, i), RTCRayN_dir_z(rays, n, i)},
                     RTCRayN_tnear(rays, n, i), RTCRayN_tfar(rays, n, i));
}

void curved_bounds(const RTCBoundsFunctionArguments* args) {
  const auto& surface = *static_cast<const CurvedSurface*>(args->geometryUserPtr);
  // The columns of the map are dual to the rows of its inverse. The image of the unit ball extends along a
  // world axis by the length of the row of the map for that axis. One float step is added for rounding.
  const auto columns =
      inverse_rows(surface.inverse_rows[0], surface.inverse_rows[1], surface.inverse_rows[2]);
  const Vec3d extent{std::hypot(columns[0].x, columns[1].x, columns[2].x),
                     std::hypot(columns[0].y, columns[1].y, columns[2].y),
                     std::hypot(columns[0].z, columns[1].z, columns[2].z)};
  const auto low = [](double x) {
    return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
  };
  const auto high = [](double x) {
    return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
  };
  RTCBounds& out = *args->bounds_o;
  out.lower_x = low(surface.centre.x - extent.x);
  out.lower_y = low(surface.centre.y - extent.y);
  out.lower_z = low(surface.centre.z - extent.z);
  out.upper_x = high(surface.centre.x + extent.x);
  out.upper_y = high(surface.centre.y + extent.y);
  out.upper_z = high(surface.centre.z + extent.z);
}

void curved_intersect(const RTCIntersectFunctionNArguments* args) {
  const auto& surface = *static_cast<const CurvedSurface*>(args->geometryUserPtr);
  RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
  RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, args->N);
  for (unsigned int i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const auto t = distance_to(surface, rays, args->N, i);
    if (!t) continue;
    RTCRayN_tfar(rays, args->N, i) = static_cast<float>(*t);
    RTCHitN_geomID(hits, args->N, i) = args->geomID;
    RTCHitN_primID(hits, args->N, i) = args->primID;
    RTCHitN_instID(hits, args->N, i, 0) = args->context->instID[0];
    RTCHitN_u(hits, args->N, i) = 0;
    RTCHitN_v(hits, args->N, i) = 0;
  }
}

void curved_occluded(const RTCOccludedFunctionNArguments* args) {
  const auto& surface = *static_cast<const CurvedSurface*>(args->geometryUserPtr);
  for (unsigned int i = 0; i < args->N; ++i)
    if (args->valid[i] != 0 && distance_to(surface, args->ray, args->N, i))
      RTCRayN_tfar(args->ray, args->N, i) = -std::numeric_limits<float>::infinity();
}

CurvedSurface surface_of(const DiskEmitter& disk) {
  const Vec3d a = cast<double>(disk.a);
  const Vec3d b = cast<double>(disk.b);
  // The normal only completes the basis; the disk has no extent along it.
  return {cast<double>(disk.centre),
          inverse_rows(a, cast<double>(disk.normal) * std::sqrt(length(a) * length(b)), b), false};
}

CurvedSurface surface_of(const SphereEmitter& sphere) {
  return {
      cast<double>(sphere.centre),
      inverse_rows(cast<double>(sphere.axes[0]), cast<double>(sphere.axes[1]), cast<double>(sphere.axes[2])),
      true};
}

CurvedSurface surface_of(const SphereSurface& sphere) {
  const double r = sphere.radius;
  return {cast<double>(sphere.centre), inverse_rows({r, 0, 0}, {0, r, 0}, {0, 0, r}), true};
}

void on_error(void*, RTCError, const char* text) { throw std::runtime_error(std::string("Embree: ") + text); }

}  // namespace

struct Accel::State {
  RTCDevice device = nullptr;
  RTCScene top = nullptr;
  std::vector<RTCScene> mesh_scenes;
  std::vector<CurvedSurface> curved;
  std::vector<std::array<Vec3f, 4>> rect_corners;

  State() : device(rtcNewDevice(nullptr)) {
    rtcSetDeviceErrorFunction(device, on_error, nullptr);
    top = new_scene();
  }
  ~State() {
    for (RTCScene scene : mesh_scenes)
      if (scene != nullptr) rtcReleaseScene(scene);
    rtcReleaseScene(top);
    rtcReleaseDevice(device);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  State(State&&) = delete;
  State& operator=(State&&) = delete;

  RTCScene new_scene() const {
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    return scene;
  }

  static void attach(RTCScene scene, RTCGeometry geometry, unsigned int id) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, id);
    rtcReleaseGeometry(geometry);
  }

  void add_mesh(RTCScene scene, const TriangleMesh& mesh, unsigned int id) const {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    // The vertices are copied because Embree reads 16 bytes at the last one, past the end of a shared buffer.
    auto* vertices = static_cast<Vec3f*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), mesh.positions.size()));
    std::copy(mesh.positions.begin(), mesh.positions.end(), vertices);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                               sizeof(mesh.triangles[0]), mesh.triangles.size());
    attach(scene, geometry, id);
  }

  void add_rect(const RectEmitter& rect, unsigned int id) const {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<Vec3f*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), 4));
    vertices[0] = rect.centre - rect.a - rect.b;
    vertices[1] = rect.centre + rect.a - rect.b;
    vertices[2] = rect.centre + rect.a + rect.b;
    vertices[3] = rect.centre - rect.a + rect.b;
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), 2));
    constexpr std::array<std::uint32_t, 6> kCorners{0, 1, 2, 0, 2, 3};
    std::copy(kCorners.begin(), kCorners.end(), indices);
    attach(top, geometry, id);
  }

  void add_curved(const CurvedSurface& surface, unsigned int id) {
    curved.push_back(surface);  // capacity was reserved: the pointer stays valid
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, 1);
    rtcSetGeometryUserData(geometry, &curved.back());
    rtcSetGeometryBoundsFunction(
        geometry, [](const RTCBoundsFunctionArguments* args) { curved_bounds(args); }, nullptr);
    rtcSetGeometryIntersectFunction(geometry, curved_intersect);
    rtcSetGeometryOccludedFunction(geometry, curved_occluded);
    attach(top, geometry, id);
  }

  void add_instance(const RenderObject& object, const TriangleMesh& mesh, unsigned int id) {
    if (mesh_scenes.size() <= object.mesh) mesh_scenes.resize(object.mesh + 1, nullptr);
    RTCScene& own = mesh_scenes[object.mesh];
    if (own == nullptr) {
      own = new_scene();
      add_mesh(own, mesh, 0);
      rtcCommitScene(own);
    }
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, own);
    std::array<Vec3f, 4> columns{object.to_world.axes[0], object.to_world.axes[1], object.to_world.axes[2],
                                 object.to_world.offset};
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
    attach(top, geometry, id);
  }
};

Accel::Accel(const AccelGeometry& geometry) : state_(std::make_unique<State>()) {
  state_->curved.reserve(geometry.objects.size());
  for (unsigned int id = 0; id < geometry.objects.size(); ++id) {
    const RenderObject& object = geometry.objects[id];
    if (object.kind == ObjectKind::WorldMesh) state_->add_mesh(state_->top, geometry.meshes[object.mesh], id);
    if (object.kind == ObjectKind::InstancedMesh)
      state_->add_instance(object, geometry.meshes[object.mesh], id);
    if (object.kind == ObjectKind::Sphere)
      state_->add_curved(surface_of(geometry.spheres[object.sphere]), id);
    if (object.kind == ObjectKind::Solid)
      State::attach(state_->top, make_solid_geometry(state_->device, geometry.solids[object.solid]), id);
    if (object.kind != ObjectKind::Light) continue;
    const auto& shape = geometry.lights[object.light].shape;
    if (const auto* rect = std::get_if<RectEmitter>(&shape)) state_->add_rect(*rect, id);
    if (const auto* disk = std::get_if<DiskEmitter>(&shape)) state_->add_curved(surface_of(*disk), id);
    if (const auto* sphere = std::get_if<SphereEmitter>(&shape)) state_->add_curved(surface_of(*sphere), id);
  }
  rtcCommitScene(state_->top);
}

Accel::~Accel() = default;

namespace {

template <typename Packet>
void load_ray(Packet& packet, std::size_t lane, const Ray& ray) {
  packet.org_x[lane] = ray.origin.x;
  packet.org_y[lane] = ray.origin.y;
  packet.org_z[lane] = ray.origin.z;
  packet.dir_x[lane] = ray.direction.x;
  packet.dir_y[lane] = ray.direction.y;
  packet.dir_z[lane] = ray.direction.z;
  packet.tnear[lane] = ray.nearest;
  packet.tfar[lane] = ray.reach;
  packet.time[lane] = 0;
  packet.mask[lane] = 0xffffffffU;
  packet.id[lane] = static_cast<unsigned int>(lane);
  packet.flags[lane] = 0;
}

// Inactive lanes repeat the last ray, because Embree may still compute with their values.
template <typename Packet>
void load_packet(Packet& packet, std::array<int, kPacket>& valid, std::span<const Ray> rays) {
  for (std::size_t lane = 0; lane < kPacket; ++lane) {
    valid[lane] = lane < rays.size() ? -1 : 0;
    load_ray(packet, lane, rays[std::min(lane, rays.size() - 1)]);
  }
}

}  // namespace

void Accel::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  alignas(64) RTCRayHit16 packet;
  alignas(64) std::array<int, kPacket> valid{};
  for (std::size_t first = 0; first < rays.size(); first += kPacket) {
    const std::size_t count = std::min(kPacket, rays.size() - first);
    load_packet(packet.ray, valid, rays.subspan(first, count));
    std::fill_n(packet.hit.geomID, kPacket, RTC_INVALID_GEOMETRY_ID);
    std::fill_n(packet.hit.instID[0], kPacket, RTC_INVALID_GEOMETRY_ID);
    rtcIntersect16(valid.data(), state_->top, &context, &packet);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const bool instanced = packet.hit.instID[0][lane] != RTC_INVALID_GEOMETRY_ID;
      hits[first + lane] = {packet.ray.tfar[lane],
                            {packet.hit.u[lane], packet.hit.v[lane]},
                            instanced ? packet.hit.instID[0][lane] : packet.hit.geomID[lane],
                            packet.hit.primID[lane]};
    }
  }
}

void Accel::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  alignas(64) RTCRay16 packet;
  alignas(64) std::array<int, kPacket> valid{};
  for (std::size_t first = 0; first < rays.size(); first += kPacket) {
    const std::size_t count = std::min(kPacket, rays.size() - first);
    load_packet(packet, valid, rays.subspan(first, count));
    rtcOccluded16(valid.data(), state_->top, &context, &packet);
    for (std::size_t lane = 0; lane < count; ++lane) blocked[first + lane] = packet.tfar[lane] < 0 ? 1 : 0;
  }
}

}  // namespace orbs::tracer
