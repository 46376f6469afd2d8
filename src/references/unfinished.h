#pragma once

#include "base/file_lock.h"
#include "image/image.h"
#include "references/passes.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace orbs::references {

/// The passes of a reference that is not complete. They stay on the disk until it is, so that a call that was
/// stopped, killed or cut off by the night is gone on with by the next.
struct UnfinishedReference {
  std::filesystem::path folder;  // of this reference alone
  std::string made_from;         // hash of what a pass depends on beside its samples and seed
  // Another call would render the same passes, and remove them when it is done.
  std::unique_ptr<FileLock> lock;
};

/// In `<references>/.unfinished/<name>`: passes of this scene by this very build of the tracer, with or
/// without layers of path classes. Makes the folder, and locks it beside it. InputError when the scene or the
/// tracer cannot be read, or another call, which is named, is at work on this reference.
UnfinishedReference unfinished_reference(const std::filesystem::path& target,
                                         const std::filesystem::path& scene,
                                         const std::filesystem::path& tracer,
                                         bool split_paths);

/// Where a pass is, or is to be put.
std::filesystem::path file_of(const UnfinishedReference& unfinished, const Pass& pass);

/// The pass of an earlier call. Nothing when there is none, only a part of its samples, as a tracer leaves
/// that was stopped, or the torn file of a power cut.
std::optional<image::Image> kept_pass(const UnfinishedReference& unfinished, const Pass& pass);

/// When the reference is in its place: no pass is needed any more.
void remove_passes(UnfinishedReference unfinished);

}  // namespace orbs::references
