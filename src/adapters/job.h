#pragma once

#include "adapters/exporter.h"
#include "registry/configuration.h"
#include "registry/placeholders.h"
#include "scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace orbs::adapters {

/// One render from the point of view of the renderer: command, working directory, and the place where its
/// image is expected.
struct Job {
  std::vector<std::string> argv;
  std::filesystem::path folder;  // working directory, holds everything of the job
  std::filesystem::path scene_file;
  std::filesystem::path image;
  int width_px = 0;
  int height_px = 0;
  int spp = 0;
  std::int64_t seed = 0;                               // as the renderer gets it
  bool may_be_negative = false;                        // its pixels
  ImageChannels channels = kColourChannels;            // of its image, which hold R, G and B
  std::map<std::string, std::string> channel_names{};  // of others, by ours; see registry::ImageNames
  std::vector<std::string> fails_on{};                 // patterns for lines of its output
  // Proof that an image belongs to this render; an empty member is not checked.
  std::string id;                                              // given to the renderer as ORBS_JOB
  std::string scene_file_hash;                                 // hash_text of scene_file's bytes
  std::optional<std::filesystem::file_time_type> ready_since;  // by the clock of the disk
};

struct JobSettings {
  int spp = 64;
  int seed = 1;
  int threads = 1;
  std::filesystem::path root;             // {root}
  std::filesystem::path build;            // {build}
  std::filesystem::path executable;       // {executable}, already found
  std::string image_file = "result.exr";  // its name in the job's folder
  std::vector<std::string> arguments{};   // of the scene, after those of the renderer's variant
  std::string scene_file{};               // its name in the job's folder; "" for that of an exported scene
};

/// Samples that a renderer gets for a case's `spp`, rounded, at least 1. InputError above 2^30.
int scaled_spp(int spp, double renderer_scale, double run_scale);

/// The files of the renderer's plug-ins, absolute; whether they are there is not asked.
std::vector<std::filesystem::path> plugin_files(const registry::Renderer& renderer,
                                                const std::filesystem::path& root,
                                                const std::filesystem::path& build);

/// Likewise the files and folders that it may read in a sandbox beside what is found out.
std::vector<std::filesystem::path> readable_places(const registry::Renderer& renderer,
                                                   const std::filesystem::path& root,
                                                   const std::filesystem::path& build);

/// The job in `folder` (absolute), where all its files lie, since some renderers may only read and write the
/// folder that they are started in. {transport} is transport_word of the scene, {seed} is the seed times the
/// renderer's seed_stride; the words of an image sequence stand in the place of {images} as often as it says.
/// Exporters add placeholders of their formats. Arguments of the renderer's variant and of the scene replace
/// {arguments}, or stand at the end of a command without it; a word with {plugin} stands there once for each
/// plug-in. Pure, touches no file. argv[0] is settings.executable where the command starts with {executable}.
Job make_job(const registry::Renderer& renderer,
             const scene::Scene& scene,
             const JobSettings& settings,
             const std::filesystem::path& folder);

}  // namespace orbs::adapters
