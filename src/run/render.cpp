#include "run/render.h"

#include "adapters/process/programs.h"
#include "base/files.h"
#include "image/image_io.h"
#include "metrics/seeds.h"
#include "run/job_folder.h"
#include "run/plan/render_seconds.h"

#include <fmt/format.h>

namespace orbs::run {

namespace {

using results::JobOutcome;

adapters::ProcessResult start(const RenderJob& job,
                              const adapters::Job& replica,
                              const std::atomic<bool>* stop) {
  adapters::ProcessRequest request;
  request.argv = replica.argv;
  request.argv[0] = adapters::find_program(replica.argv[0]).value_or(replica.argv[0]).string();
  if (job.isolation) request.argv = adapters::isolated(request.argv, *job.isolation);
  request.folder = replica.folder;
  request.environment = environment_of(job.renderer, replica);
  request.log = replica.folder / "log.txt";
  request.limits = job.renderer.limits;
  request.stop = stop;
  return adapters::run_process(request);
}

// Puts the image that came back in the place where a renderer would have left it. Without one nothing was
// written.
adapters::ProcessResult take_image(const adapters::Job& job, const std::filesystem::path& from) {
  const auto image = from / job.image.filename();
  if (no_file_problem(image).empty()) write_file(job.image, read_file(image));
  return {};
}

// Writes the mean image of all replicas to `file` and removes their own images.
image::Image merged_image(const std::vector<adapters::Job>& replicas,
                          const std::vector<image::Image>& images,
                          const std::filesystem::path& file) {
  // A later replica may have left anything under any of these names.
  for (const auto& job : replicas) make_way(job.image);
  make_way(file);
  auto image = metrics::are_equal(images) ? images.front() : metrics::mean_and_variance_of(images);
  image::write_exr(image, file);
  return image;
}

}  // namespace

std::vector<std::string> environment_of(const registry::Renderer& renderer, const adapters::Job& job) {
  auto allowed = renderer.command.environment;
  if (!job.id.empty()) allowed.push_back(fmt::format("ORBS_JOB={}", job.id));
  return adapters::child_environment(allowed);
}

Rendered render(const RenderJob& job, const std::atomic<bool>* stop) {
  Rendered rendered;
  std::vector<image::Image> images;
  for (const auto& replica : job.replicas) {
    forget_render_seconds(job.renderer.timing.render_seconds, replica.folder);
    rendered.image = replica.image;
    rendered.processes.push_back(job.came_back.empty() ? start(job, replica, stop)
                                                       : take_image(replica, job.came_back));
    const auto& process = rendered.processes.back();
    make_room(replica.folder);
    if (const auto seconds =
            render_seconds(job.renderer.timing.render_seconds, process.output, replica.folder))
      rendered.render_seconds = rendered.render_seconds.value_or(0) + *seconds;
    rendered.outcome = classify(process, replica, job.renderer.limits);
    if (rendered.outcome.kind != JobOutcome::Image) return rendered;
    if (job.replicas.size() > 1) {
      images.push_back(std::move(*rendered.outcome.image));
    } else if (replica.channels != adapters::kColourChannels) {
      // All who read the file later expect R, G and B.
      image::write_exr(*rendered.outcome.image, replica.image);
    }
  }
  if (images.empty()) return rendered;
  rendered.image = job.replicas.front().folder / adapters::JobSettings{}.image_file;
  rendered.outcome.image = merged_image(job.replicas, images, rendered.image);
  return rendered;
}

}  // namespace orbs::run
