#include "run/render.h"

#include "adapters/export.h"
#include "adapters/process/programs.h"
#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "image/image_io.h"
#include "json/document.h"
#include "json/object_reader.h"
#include "metrics/seeds.h"
#include "run/isolate.h"
#include "run/job_folder.h"
#include "run/other_images.h"
#include "run/plan/choose_renderers.h"
#include "run/plan/render_seconds.h"
#include "run/prepare.h"
#include "run/program_hash.h"

#include <cstdint>

#include <fmt/format.h>

namespace orbs::run {

namespace {

struct TracerReport {
  std::optional<double> traversal_share;
  std::optional<double> samples_cpu_seconds;
};

// From the last line of the tracer's --json report. It clocks traversal by the wall in each thread, so the
// whole is the wall clock of all threads: on a machine that others use, CPU time would be less than the part.
TracerReport read_report(const std::string& output, int threads) {
  for (const auto& line : split(output, '\n')) {
    if (!line.starts_with('{') || line.find("\"traversal_seconds\"") == std::string::npos) continue;
    const auto document = json::parse("the report of orbs-tracer", line);
    json::ObjectReader report(document);
    TracerReport found;
    found.samples_cpu_seconds = report.number("cpu_seconds", json::kNotNegative);
    const double whole = report.number("render_seconds", json::kNotNegative) * threads;
    if (whole > 0) found.traversal_share = report.number("traversal_seconds", json::kNotNegative) / whole;
    return found;
  }
  return {};
}

}  // namespace

PreparedRender prepare_render(const ChosenRenderer& renderer,
                              const Plan& plan,
                              const scene::Scene& scene,
                              const std::filesystem::path& folder,
                              double case_seconds) {
  const auto prepared = adapters::prepare_scene(renderer.entry, scene);
  if (const auto* reason = std::get_if<std::string>(&prepared))
    throw InputError(fmt::format("renderer '{}' cannot render the scene: {}", renderer.entry.name, *reason));
  PreparedRender subject{renderer, scene, {}, folder};
  subject.renderer.entry.limits = limits_of(renderer.entry, case_seconds);
  subject.settings.root = plan.root;
  subject.settings.build = plan.build;
  subject.settings.executable = renderer.executable;
  subject.is_built_in = is_built_in(plan, renderer);
  make_folder(folder);
  const auto job = adapters::make_job(renderer.entry, scene, subject.settings, folder);
  if (plan.settings.sandbox)
    subject.isolation = isolation_of(plan, renderer, scene, {job}, folder.parent_path());
  adapters::export_scene(renderer.entry, std::get<scene::Scene>(prepared), job.scene_file);
  return subject;
}

namespace {

RenderJob job_of(const PreparedRender& prepared, const RenderSettings& settings) {
  const auto& entry = prepared.renderer.entry;
  auto of_job = prepared.settings;
  of_job.spp = settings.spp;
  of_job.seed = (settings.seed - 1) * entry.sampling.seeds + 1;
  of_job.threads = settings.threads;
  RenderJob job{entry, replicas_of(entry, prepared.scene, of_job, prepared.folder), prepared.isolation,
                prepared.folder.parent_path(), files_of(prepared.scene)};
  job.inputs.push_back(job.replicas.front().scene_file);
  make_way(prepared.folder / "log.txt");
  for (auto& replica : job.replicas) {
    replica.may_be_negative = settings.may_be_negative;
    make_way(replica.image);
    if (prepared.is_built_in) replica.argv.emplace_back("--json");
    replica.argv.insert(replica.argv.end(), settings.more_arguments.begin(), settings.more_arguments.end());
  }
  return job;
}

// The seed of a sequence is the number of images that a process renders, of which the last one counts.
double images_for_each(const RenderJob& job) {
  if (job.renderer.command.sequence.words.empty()) return 1;
  std::int64_t images = 0;
  for (const auto& replica : job.replicas) images += replica.seed;
  return static_cast<double>(images) / static_cast<double>(job.replicas.size());
}

RenderCost cost_of(const PreparedRender& prepared, const RenderSettings& settings, const Rendered& rendered) {
  RenderCost cost;
  cost.spp = settings.spp;
  for (const auto& process : rendered.processes) {
    cost.cpu_seconds += process.user_seconds + process.system_seconds;
    cost.wall_seconds += process.wall_seconds;
    cost.supervisor_cpu_seconds += process.supervisor_cpu_seconds;
    if (!prepared.is_built_in) continue;
    const auto report = read_report(process.output, settings.threads);
    cost.traversal_share = report.traversal_share;
    if (report.samples_cpu_seconds)
      cost.samples_cpu_seconds = cost.samples_cpu_seconds.value_or(0) + *report.samples_cpu_seconds;
  }
  cost.render_seconds = rendered.render_seconds;
  cost.trial_seconds = rendered.trial_seconds;
  return cost;
}

}  // namespace

std::optional<RenderedImage> render_once(const PreparedRender& prepared,
                                         const RenderSettings& settings,
                                         const std::atomic<bool>* stop) {
  const auto job = job_of(prepared, settings);
  auto rendered = render(job, stop);
  if (rendered.outcome.kind == results::JobOutcome::Skipped) return std::nullopt;
  const auto& output = rendered.processes.back().output;
  if (!rendered.outcome.image)
    throw InputError(fmt::format("renderer '{}' {}; {}", prepared.renderer.entry.name,
                                 rendered.outcome.reason,
                                 output.empty() ? "it said nothing" : "it said:\n" + output));
  RenderedImage made{cost_of(prepared, settings, rendered), std::move(*rendered.outcome.image)};
  made.cost.images = images_for_each(job);
  return made;
}

namespace {

using results::JobOutcome;

adapters::ProcessResult start(const RenderJob& job,
                              const adapters::Job& replica,
                              const std::atomic<bool>* stop) {
  adapters::ProcessRequest request;
  request.argv = replica.argv;
  request.argv[0] = adapters::find_program(replica.argv[0]).value_or(replica.argv[0]).string();
  if (job.isolation) request.argv = adapters::isolated(request.argv, *job.isolation);
  request.has_own_keyring = job.isolation.has_value();
  request.folder = replica.folder;
  request.environment = environment_of(job.renderer, replica);
  request.log = replica.folder / "log.txt";
  request.limits = job.renderer.limits;
  request.stop = stop;
  return adapters::run_process(request);
}

// Who renders elsewhere may have no OpenEXR. Of what cannot be read the bytes are kept, for the verdict to
// say so.
void take_other_format(const std::filesystem::path& file, const std::filesystem::path& exr) {
  try {
    image::write_exr(image::read_rgb_with_steps(file), exr);
  } catch (const WriteError&) {
    throw;
  } catch (const InputError&) {
    write_file(exr, read_file(file));
  }
}

// Puts the image that came back in the place where a renderer would have left it. Without one nothing was
// written.
adapters::ProcessResult take_image(const adapters::Job& job, const std::filesystem::path& from) {
  auto image = from / job.image.filename();
  if (no_file_problem(image).empty()) {
    write_file(job.image, read_file(image));
    return {};
  }
  for (const char* ending : {".pfm", ".hdr"})
    if (no_file_problem(image.replace_extension(ending)).empty()) {
      take_other_format(image, job.image);
      break;
    }
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

namespace {

// The first of the inputs that is another than at the start; "" when none is.
std::string changed_input(const RenderJob& job,
                          const std::vector<std::string>& at_start,
                          FileHashes& hashes) {
  for (std::size_t i = 0; i < job.inputs.size(); ++i)
    if (hashes.of(job.inputs[i]) != at_start[i])
      return named_within(job.replicas.front().folder, job.inputs[i].string());
  return "";
}

// Where the image should be.
std::set<std::string> images_beside(const RenderJob& job, const adapters::Job& replica) {
  return other_images(job.came_back.empty() ? replica.folder : job.came_back,
                      replica.image.filename().string());
}

// The outcome of one process, and the folder ready for what we write into it. `before`: the images that were
// there before it.
Outcome outcome_of(const RenderJob& job,
                   const adapters::Job& replica,
                   const std::set<std::string>& before,
                   const adapters::ProcessResult& process) {
  const bool is_replaced = make_room(job.within, replica.folder);
  // The file of the log is where the renderer has moved the folder.
  const auto log = replica.folder / "log.txt";
  if (!no_file_problem(log).empty()) write_file(log, process.output);
  auto outcome = classify(process, replica, job.renderer.limits);
  if (outcome.kind == JobOutcome::NoOutput)
    outcome.reason += misnamed_text(replica.image.filename().string(), before, images_beside(job, replica));
  if (is_replaced)
    outcome.reason += "; it has put something else in the place of its folder, or of one above";
  return outcome;
}

}  // namespace

namespace {

// Adds what the renderer states of one process.
void add_stated(std::optional<double>& sum,
                const registry::RenderSeconds& place,
                const adapters::ProcessResult& process,
                const std::filesystem::path& folder) {
  if (const auto seconds = render_seconds(place, process.output, folder)) sum = sum.value_or(0) + *seconds;
}

}  // namespace

Rendered render(const RenderJob& job, const std::atomic<bool>* stop) {
  Rendered rendered;
  std::vector<image::Image> images;
  FileHashes hashes;
  std::vector<std::string> at_start;
  for (const auto& file : job.inputs) at_start.push_back(hashes.of(file));
  for (const auto& replica : job.replicas) {
    forget_render_seconds(job.renderer.timing.render_seconds, replica.folder);
    forget_render_seconds(job.renderer.timing.trial_seconds, replica.folder);
    rendered.image = replica.image;
    // A file of that name is none of this render, whatever its time says: a replica before may have left it.
    make_way(replica.image);
    const auto before = images_beside(job, replica);
    rendered.processes.push_back(job.came_back.empty() ? start(job, replica, stop)
                                                       : take_image(replica, job.came_back));
    const auto& process = rendered.processes.back();
    rendered.outcome = outcome_of(job, replica, before, process);
    const auto& timing = job.renderer.timing;
    add_stated(rendered.render_seconds, timing.render_seconds, process, replica.folder);
    add_stated(rendered.trial_seconds, timing.trial_seconds, process, replica.folder);
    if (rendered.outcome.kind != JobOutcome::Image) return rendered;
    if (const auto file = changed_input(job, at_start, hashes); !file.empty()) {
      rendered.outcome = {
          JobOutcome::Stale,
          fmt::format("{}, which its scene is made of, has changed while it was rendered", file),
          {}};
      return rendered;
    }
    if (job.replicas.size() > 1) {
      images.push_back(std::move(*rendered.outcome.image));
    } else if (!rendered.outcome.is_as_written) {
      // All who read the file later expect our names.
      image::write_exr(*rendered.outcome.image, replica.image);
    }
  }
  if (images.empty()) return rendered;
  rendered.image = job.replicas.front().folder / adapters::JobSettings{}.image_file;
  rendered.outcome.image = merged_image(job.replicas, images, rendered.image);
  rendered.renders = std::move(images);
  return rendered;
}

}  // namespace orbs::run
