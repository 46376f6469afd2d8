#pragma once

#include <filesystem>

namespace orbs::runner {

/// Makes the folder of a render fit for what orbs writes there after it, whatever the renderer has left: what
/// is no file under a name of ours goes (a folder called job.json), and the folder is there and can be
/// written to. WriteError when the disk refuses.
void make_room(const std::filesystem::path& folder);

}  // namespace orbs::runner
