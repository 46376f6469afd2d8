#pragma once

#include "base/file_lock.h"
#include "image/image.h"
#include "references/passes.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace orbs::references {

/// The passes of a reference that is not complete. They stay on the disk until it is, so that the next call
/// resumes one that was stopped or killed.
struct UnfinishedReference {
  std::filesystem::path folder;  // of this reference alone
  std::string made_from;         // hash of what a pass depends on beside its samples and seed
  // Keeps other calls from rendering the same passes, and from removing them.
  std::unique_ptr<FileLock> lock;
};

/// In `<references>/.unfinished/<name>`: passes of this scene, seen by this camera of its file, by this very
/// build of the tracer, with or without layers of path classes. Makes the folder, and locks it beside it.
/// InputError when the scene or the tracer cannot be read, or another call, which is named, is at work on
/// this reference.
UnfinishedReference unfinished_reference(const std::filesystem::path& target,
                                         const std::filesystem::path& scene,
                                         const std::string& camera,
                                         const std::filesystem::path& tracer,
                                         bool split_paths);

/// The file of a pass, whether or not it exists.
std::filesystem::path file_of(const UnfinishedReference& unfinished, const Pass& pass);

/// The pass of an earlier call. Nothing when there is none or it is incomplete: a tracer that was stopped
/// leaves a part of the samples, a power cut an unreadable file.
std::optional<image::Image> kept_pass(const UnfinishedReference& unfinished, const Pass& pass);

/// Removes all passes; called when the reference is in place.
void remove_passes(UnfinishedReference unfinished);

}  // namespace orbs::references
