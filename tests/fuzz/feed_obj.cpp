#include "fuzz/feed.h"
#include "fuzz/mesh_promises.h"
#include "scene/geometry/obj.h"

namespace orbs::fuzz {

std::string feed_obj(std::string_view bytes) {
  return complaint_of("mesh.obj", [&] { check_mesh_file(scene::parse_obj("mesh.obj", bytes)); });
}

}  // namespace orbs::fuzz
