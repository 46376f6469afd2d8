#pragma once

#include "base/file_lock.h"
#include "image/image.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace orbs::references {

/// One render of a scene among several with different seeds.
struct Pass {
  int spp = 0;
  std::uint64_t seed = 0;
};

/// Sums of passes, in double: n m of every channel and n^2 v of the channels "variance.*", where n is the
/// number of samples of a pass, m its mean and v the variance of that mean.
struct PassSum {
  int width = 0;
  int height = 0;
  std::map<std::string, std::vector<double>> channels;
  std::map<std::string, std::string> attributes;  // of the first pass
  std::vector<Pass> passes;
  int spp = 0;                // of all passes
  long long bad_samples = 0;  // as their headers say
};

/// Adds an image whose samples are independent of those before: another seed. A channel that a pass lacks (a
/// class of light paths that did not occur) counts as black. InputError when the size is another one.
void add_pass(PassSum& sum, const image::Image& image, const Pass& pass);

/// The mean of all samples, sum n m / N, and its variance, sum n^2 v / N^2, as the passes are independent.
/// R, G, B come first, then their variances, then the other channels by name. At least one pass is the
/// caller's promise.
image::Image mean_image(const PassSum& sum);

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
