#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <sys/types.h>

namespace orbs::supervisor {

using Device = std::pair<unsigned, unsigned>;  // major and minor number

/// What the tmpfs hold that tasks have mounted in namespaces of their own, as a sandbox mounts its /tmp: by
/// device, in bytes. All of it is of the job, since nobody else sees them, open or not.
std::map<Device, std::size_t> own_tmpfs_bytes(const std::vector<pid_t>& tasks);

}  // namespace orbs::supervisor
