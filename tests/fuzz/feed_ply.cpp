#include "fuzz/feed.h"
#include "fuzz/mesh_promises.h"
#include "scene/geometry/ply.h"

namespace orbs::fuzz {

std::string feed_ply(std::string_view bytes) {
  return complaint_of("mesh.ply", [&] { check_mesh_file(scene::parse_ply("mesh.ply", bytes)); });
}

}  // namespace orbs::fuzz
