#include "run/cluster/export_plan.h"

#include "base/files.h"
#include "base/text.h"
#include "json/field_writer.h"
#include "registry/image_size.h"
#include "run/cluster/carried_files.h"
#include "run/job_folder.h"
#include "run/prepare.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::run {

namespace {

namespace fs = std::filesystem;

// One image, as export.json has it for a program that starts the renderer in another way.
struct ExportedImage {
  std::string image;
  std::string scene_file;
  std::string scene;
  std::string renderer;
  int width_px = 0;
  int height_px = 0;
  int spp = 0;
  long long seed = 0;
  int trace_depth = 0;
  double time_limit_seconds = 0;
  std::vector<std::string> files;  // that the scene is made of: what there is to convert
};

template <class Visitor, json::RecordOf<ExportedImage> Record>
void fields(Visitor& visit, Record& one) {
  visit.required("image", one.image);
  visit.required("scene_file", one.scene_file);
  visit.required("scene", one.scene);
  visit.required("renderer", one.renderer);
  visit.required("width_px", one.width_px);
  visit.required("height_px", one.height_px);
  visit.required("spp", one.spp);
  visit.required("seed", one.seed);
  visit.required("trace_depth", one.trace_depth);
  visit.required("time_limit_seconds", one.time_limit_seconds);
  visit.required("files", one.files);
}

// What the program is called where it is found by its name: no folder of this machine.
std::string program_elsewhere(const ChosenRenderer& renderer) {
  return renderer.executable.filename().string();
}

// The words of the command as they are in the folder of the job, where the program is whatever RENDERER says.
std::string command_line(const adapters::Job& job,
                         const ChosenRenderer& renderer,
                         const CarriedFiles& carried) {
  std::vector<std::string> words;
  for (const auto& variable : renderer.entry.command.environment)
    if (variable.find('=') != std::string::npos) words.push_back(shell_text({variable}));
  // A quoted word is no assignment to the shell, but one to env.
  if (!words.empty()) words.insert(words.begin(), "env");
  for (const auto& word : job.argv) {
    const bool is_program = word == renderer.executable.string();
    const auto text = with_copies(named_within(job.folder, word), carried, job.folder);
    words.push_back(is_program ? "\"$renderer\"" : shell_text({text}));
  }
  return fmt::format("{}", fmt::join(words, " "));
}

// What the shell takes for the program: it ends with a message where nobody says what it is called.
std::string program_of(const ChosenRenderer& renderer) {
  return renderer.entry.command.is_elsewhere
             ? "${RENDERER:?is not set: the program that renders; export.json lists the images}"
             : fmt::format("${{RENDERER:-{}}}", shell_text({program_elsewhere(renderer)}));
}

std::string job_lines(const Plan& plan,
                      const PlannedJob& job,
                      const std::vector<adapters::Job>& replicas,
                      const CarriedFiles& carried) {
  const auto& renderer = plan.renderers[job.renderer];
  const auto& scene = plan.scenes[job.scene];
  const auto& camera = scene.scene->camera;
  std::vector<std::string> commands;
  for (const auto& replica : replicas) commands.push_back(command_line(replica, renderer, carried));
  return fmt::format(
      "# {}: {} x {} px, trace depth {}, {} samples per pixel{}, seed {}\n"
      "renderer={}\n"
      "(cd {} && {})\n\n",
      scene.name, camera.width_px, camera.height_px, scene.scene->trace_depth, job.spp,
      replicas.size() > 1 ? fmt::format(" in {} images", replicas.size()) : "", plan.settings.seed,
      program_of(renderer), shell_text({job.folder.string()}), fmt::join(commands, " && "));
}

// All that lies in the folder of the render, which holds nothing else before it is rendered.
std::vector<std::string> files_of_scene(const fs::path& scene_folder, const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(scene_folder))
    if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(folder).string());
  std::sort(files.begin(), files.end());
  return files;
}

void list_images(const Plan& plan,
                 const PlannedJob& job,
                 const std::vector<adapters::Job>& replicas,
                 const fs::path& folder,
                 std::vector<ExportedImage>& images) {
  const auto& scene = plan.scenes[job.scene];
  const auto files = files_of_scene(replicas.front().folder, folder);
  const auto seconds = limits_of(plan, job).wall_seconds;
  for (const auto& replica : replicas)
    images.push_back({replica.image.lexically_relative(folder).string(),
                      replica.scene_file.lexically_relative(folder).string(), scene.name,
                      plan.renderers[job.renderer].entry.name, replica.width_px, replica.height_px,
                      replica.spp, replica.seed, scene.scene->trace_depth, seconds, files});
}

constexpr const char* kImageFormat =
    "OpenEXR with the channels R, G and B, 32-bit float: linear Rec.709 radiance without a tone curve, not denoised; "
    "each pixel is the mean over its square. In place of an .exr that is not there, a .pfm or .hdr of the same name is "
    "taken";

void write_list(const Plan& plan, const std::vector<ExportedImage>& images, const fs::path& folder) {
  json::Writer out;
  out.begin_object().member("format", "orbs-export/1").member("suite", plan.suite.name);
  out.member("size", registry::size_text(plan.settings.size_divisor));
  out.member("image_format", kImageFormat).key("images").begin_array();
  for (const auto& image : images) json::write_record(out, image);
  write_file(folder / "export.json", out.end_array().end_object().text());
}

}  // namespace

ExportedPlan export_plan(const Plan& plan, const fs::path& folder) {
  ExportedPlan exported;
  std::string script =
      "#!/bin/sh\n"
      "# Renders all images that orbs judge wants. RENDERER=/path/to/program sh render.sh\n"
      "# Without RENDERER, the program of its name on PATH. export.json lists the images.\n"
      "# An image is linear and has no tone curve: 32-bit float EXR, no denoiser, a box filter of one pixel.\n"
      "cd \"$(dirname \"$0\")\" || exit\n\n";
  std::vector<ExportedImage> images;
  std::vector<CarriedFiles> carried;
  for (const auto& renderer : plan.renderers) carried.push_back(carry_files(plan, renderer, folder));
  for (const auto& job : plan.jobs) {
    const auto prepared = scene_for(plan, job);
    if (const auto* reason = std::get_if<std::string>(&prepared)) {
      exported.left_out.push_back(fmt::format("{} {}: {}", plan.renderers[job.renderer].entry.name,
                                              plan.scenes[job.scene].name, *reason));
      continue;
    }
    const auto replicas = replicas_of(plan, job, folder);
    make_folder(replicas.front().folder);
    write_job_scene(plan, job, std::get<scene::Scene>(prepared), replicas.front());
    script += job_lines(plan, job, replicas, carried[job.renderer]);
    list_images(plan, job, replicas, folder, images);
    ++exported.renders;
  }
  write_file(folder / "render.sh", script);
  write_list(plan, images, folder);
  return exported;
}

}  // namespace orbs::run
