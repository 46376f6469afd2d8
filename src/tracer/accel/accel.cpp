#include "tracer/accel/accel.h"

#include "tracer/accel/curved_surface.h"
#include "tracer/accel/double_triangles.h"
#include "tracer/accel/embree_api.h"
#include "tracer/accel/moving_triangles.h"
#include "tracer/accel/open_triangles.h"
#include "tracer/accel/solid_geometry.h"
#include "tracer/accel/user_geometry.h"
#include "tracer/numeric_fault.h"
#include "tracer/plugins/plugin_hit.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace orbs::tracer {

namespace {

constexpr std::size_t kPacket = 16;
constexpr unsigned int kTimeSteps = 2;  // of what moves: start and end of the frame

constexpr std::array<std::array<std::uint32_t, 3>, 2> kQuadTriangles{{{0, 1, 2}, {0, 2, 3}}};

std::vector<DoubleTriangle> triangles_of(const Quad& quad) {
  const auto& corners = quad.corners;
  std::vector<DoubleTriangle> triangles;
  for (const auto& [a, b, c] : kQuadTriangles) triangles.push_back({corners[a], corners[b], corners[c]});
  return triangles;
}

/// What filters of hits need beside Embree's own: the rays of the packet as they came, in world space.
struct PacketContext {
  RayContext embree;  // first: Embree hands a pointer to it back
  const Ray* rays = nullptr;
};

// Rejects hits of rays that pass.
void let_pass(const RTCFilterFunctionNArguments* args) {
  const auto& openings = *static_cast<const Openings*>(args->geometryUserPtr);
  const Ray* rays = reinterpret_cast<const PacketContext*>(args->context)->rays;
  const unsigned int n = args->N;
  for (unsigned int i = 0; i < n; ++i) {
    if (args->valid[i] == 0) continue;
    const unsigned int instance = RTCHitN_instID(args->hit, n, i, 0);
    const Hit hit{0,
                  {RTCHitN_u(args->hit, n, i), RTCHitN_v(args->hit, n, i)},
                  instance == RTC_INVALID_GEOMETRY_ID ? RTCHitN_geomID(args->hit, n, i) : instance,
                  RTCHitN_primID(args->hit, n, i)};
    const Ray& ray = rays[RTCRayN_id(args->ray, n, i)];
    if (passes(openings, ray.origin, ray.direction, hit)) args->valid[i] = 0;
  }
}

void on_error(void*, RTCError, const char* text) { throw std::runtime_error(std::string("Embree: ") + text); }

// Of a processor without the kernels that are asked for, or no memory.
std::string no_device() {
  return fmt::format("Embree makes no device with the settings '{}': error {}", kDeviceSettings,
                     static_cast<int>(rtcGetDeviceError(nullptr)));
}

}  // namespace

struct Accel::State {
  Openings openings;
  bool is_double = false;
  RTCDevice device = nullptr;
  RTCScene top = nullptr;
  std::vector<RTCScene> mesh_scenes;
  std::vector<std::shared_ptr<const void>> surfaces;          // with tests of their own
  std::vector<std::vector<DoubleTriangle>> double_triangles;  // of the objects, where they are wanted
  std::vector<std::vector<MovingTriangle>> moving_triangles;  // likewise

  State(const Openings& given, bool triangles_are_double)
      : openings(given), is_double(triangles_are_double), device(rtcNewDevice(kDeviceSettings)) {
    if (device == nullptr) throw std::runtime_error(no_device());
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

  // The vertices are copied because Embree reads 16 bytes at the last one, past the end of a shared buffer.
  static void set_vertices(RTCGeometry geometry,
                           unsigned int time_step,
                           const std::vector<Vec3f>& positions) {
    auto* vertices = static_cast<Vec3f*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, time_step, RTC_FORMAT_FLOAT3, sizeof(Vec3f), positions.size()));
    std::copy(positions.begin(), positions.end(), vertices);
  }

  void add_mesh(RTCScene scene, const TriangleMesh& mesh, unsigned int id, bool is_open) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    if (is_open) {
      rtcSetGeometryUserData(geometry, &openings);
      rtcSetGeometryIntersectFilterFunction(geometry, let_pass);
      rtcSetGeometryOccludedFilterFunction(geometry, let_pass);
    }
    if (!mesh.end_positions.empty()) {
      rtcSetGeometryTimeStepCount(geometry, kTimeSteps);
      set_vertices(geometry, 1, mesh.end_positions);
    }
    set_vertices(geometry, 0, mesh.positions);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                               sizeof(mesh.triangles[0]), mesh.triangles.size());
    attach(scene, geometry, id);
  }

  void add_light(const Quad& quad, bool is_vast, unsigned int id) {
    if (is_double || is_vast) return add_double(triangles_of(quad), id);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<Vec3f*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), 4));
    std::transform(quad.corners.begin(), quad.corners.end(), vertices,
                   [](Vec3d p) { return cast<float>(p); });
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), 2));
    for (const auto& triangle : kQuadTriangles)
      indices = std::copy(triangle.begin(), triangle.end(), indices);
    attach(top, geometry, id);
  }

  template <typename Triangle>
  void add_open(std::vector<Triangle> triangles, unsigned int id) {
    const auto kept = std::make_shared<const std::vector<OpenTriangle<Triangle>>>(
        open_triangles(std::move(triangles), openings, id));
    surfaces.push_back(kept);
    attach(top, make_user_geometry(device, std::span<const OpenTriangle<Triangle>>(*kept)), id);
  }

  void add_double(std::vector<DoubleTriangle> triangles, unsigned int id) {
    double_triangles.push_back(std::move(triangles));  // capacity was reserved: the references stay valid
    attach(top, make_user_geometry(device, std::span<const DoubleTriangle>(double_triangles.back())), id);
  }

  void add_moving_double(std::vector<MovingTriangle> triangles, unsigned int id) {
    moving_triangles.push_back(std::move(triangles));  // as above
    attach(top, make_user_geometry(device, std::span<const MovingTriangle>(moving_triangles.back())), id);
  }

  template <typename Surface>
  void add_surface(Surface surface, unsigned int id) {
    const auto kept = std::make_shared<const Surface>(std::move(surface));
    surfaces.push_back(kept);
    attach(top, make_user_geometry(device, std::span<const Surface>(kept.get(), 1)), id);
  }

  // Rays meet curved surfaces in double, whatever their size.
  template <typename Surface>
  void add_light(Surface surface, bool, unsigned int id) {
    add_surface(std::move(surface), id);
  }

  static void set_transform(RTCGeometry geometry, unsigned int time_step, const Affine& to_world) {
    const std::array<Vec3f, 4> columns{to_world.axes[0], to_world.axes[1], to_world.axes[2], to_world.offset};
    rtcSetGeometryTransform(geometry, time_step, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
  }

  void add_instance(const RenderObject& object, const TriangleMesh& mesh, unsigned int id) {
    if (mesh_scenes.size() <= object.mesh) mesh_scenes.resize(object.mesh + 1, nullptr);
    RTCScene& own = mesh_scenes[object.mesh];
    if (own == nullptr) {
      own = new_scene();
      add_mesh(own, mesh, 0, !openings.of_material.empty());
      rtcCommitScene(own);
    }
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, own);
    if (object.kind == ObjectKind::MovingMesh) {
      rtcSetGeometryTimeStepCount(geometry, kTimeSteps);
      set_transform(geometry, 1, object.end_to_world);
    }
    set_transform(geometry, 0, object.to_world);
    attach(top, geometry, id);
  }
};

Accel::Accel(const AccelGeometry& geometry, Intersection intersection)
    : state_(std::make_unique<State>(geometry.openings, intersection == Intersection::Double)) {
  state_->double_triangles.reserve(geometry.objects.size());
  state_->moving_triangles.reserve(geometry.objects.size());
  for (unsigned int id = 0; id < geometry.objects.size(); ++id) {
    const RenderObject& object = geometry.objects[id];
    const bool is_moving = object.kind == ObjectKind::MovingMesh;
    const bool is_instance = object.kind == ObjectKind::InstancedMesh || is_moving;
    if (object.kind == ObjectKind::WorldMesh || is_instance) {
      const TriangleMesh& mesh = geometry.meshes[object.mesh];
      const bool is_open = may_let_pass(state_->openings, object);
      const bool is_exact = !mesh.exact_positions.empty();
      if (is_open && state_->is_double && is_moving)
        state_->add_open(moving_triangles(object, mesh), id);
      else if (is_open && (state_->is_double || is_exact))
        state_->add_open(world_triangles(object, mesh), id);
      else if (state_->is_double && is_moving)
        state_->add_moving_double(moving_triangles(object, mesh), id);
      else if (state_->is_double || is_exact)
        state_->add_double(world_triangles(object, mesh), id);
      else if (is_instance)
        state_->add_instance(object, mesh, id);
      else
        state_->add_mesh(state_->top, mesh, id, is_open);
    }
    if (object.kind == ObjectKind::Sphere)
      state_->add_surface(surface_of(geometry.spheres[object.sphere]), id);
    if (object.kind == ObjectKind::Solid)
      State::attach(
          state_->top,
          make_user_geometry(state_->device, std::span<const Solid>(&geometry.solids[object.solid], 1)), id);
    if (object.kind == ObjectKind::PluginShape)
      State::attach(state_->top,
                    make_user_geometry(state_->device, std::span<const PluginShape>(
                                                           &geometry.plugin_shapes[object.plugin_shape], 1)),
                    id);
    if (object.kind == ObjectKind::Light) {
      const AreaLight& light = geometry.lights[object.light];
      std::visit(
          [&](const auto& emitter) {
            if constexpr (requires { surface_of(emitter); })
              state_->add_light(surface_of(emitter), light.is_vast, id);
          },
          light.shape);
    }
  }
  rtcCommitScene(state_->top);
}

Accel::~Accel() = default;

namespace {

// A tenth of a millimetre, in units of the direction.
float least_distance(const Ray& ray) { return 1e-4F / length(ray.direction); }

template <typename Packet>
void load_ray(Packet& packet, std::size_t lane, const Ray& ray) {
  packet.org_x[lane] = ray.origin.x;
  packet.org_y[lane] = ray.origin.y;
  packet.org_z[lane] = ray.origin.z;
  packet.dir_x[lane] = ray.direction.x;
  packet.dir_y[lane] = ray.direction.y;
  packet.dir_z[lane] = ray.direction.z;
  packet.tnear[lane] = has_fault(NumericFault::HitsNearOriginIgnored) ? least_distance(ray) : ray.nearest;
  packet.tfar[lane] = ray.reach;
  packet.time[lane] = ray.time;
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

void Accel::intersect(std::span<const Ray> rays, std::span<Hit> hits, Coherence coherence) const {
  PacketContext context;
  init(context.embree);
  alignas(64) RTCRayHit16 packet;
  alignas(64) std::array<int, kPacket> valid{};
  for (std::size_t first = 0; first < rays.size(); first += kPacket) {
    const std::size_t count = std::min(kPacket, rays.size() - first);
    load_packet(packet.ray, valid, rays.subspan(first, count));
    std::fill_n(packet.hit.geomID, kPacket, RTC_INVALID_GEOMETRY_ID);
    std::fill_n(packet.hit.instID[0], kPacket, RTC_INVALID_GEOMETRY_ID);
    context.rays = &rays[first];
    intersect_packet(valid.data(), state_->top, context.embree, packet, coherence == Coherence::Neighbours);
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
  PacketContext context;
  init(context.embree);
  alignas(64) RTCRay16 packet;
  alignas(64) std::array<int, kPacket> valid{};
  for (std::size_t first = 0; first < rays.size(); first += kPacket) {
    const std::size_t count = std::min(kPacket, rays.size() - first);
    load_packet(packet, valid, rays.subspan(first, count));
    context.rays = &rays[first];
    occluded_packet(valid.data(), state_->top, context.embree, packet);
    for (std::size_t lane = 0; lane < count; ++lane) blocked[first + lane] = packet.tfar[lane] < 0 ? 1 : 0;
  }
}

}  // namespace orbs::tracer
