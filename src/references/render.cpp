#include "references/render.h"

#include "adapters/process/process.h"
#include "adapters/process/programs.h"
#include "base/error.h"
#include "image/image_io.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::references {

namespace {

std::optional<image::Image> render_pass(const WantedReference& wanted,
                                        const Pass& pass,
                                        const ReferenceSettings& settings,
                                        const ReferenceContext& context,
                                        const std::filesystem::path& file) {
  constexpr double kDay_seconds = 86400;
  adapters::ProcessRequest request;
  request.argv = {context.tracer.string(),
                  wanted.file.string(),
                  "-o",
                  file.string(),
                  "--spp",
                  std::to_string(pass.spp),
                  "--seed",
                  std::to_string(pass.seed),
                  "--threads",
                  std::to_string(settings.threads)};
  if (!wanted.camera.empty()) request.argv.insert(request.argv.end(), {"--camera", wanted.camera});
  if (wanted.split_paths) request.argv.emplace_back("--split-paths");
  request.environment = adapters::child_environment({});
  request.limits.wall_seconds = kDay_seconds;
  request.stop = context.stop;
  const auto process = adapters::run_process(request);
  if (process.cause == supervisor::Cause::Stopped) return std::nullopt;
  for (const auto& problem : {process.start_error, process.orphaned})
    if (!problem.empty()) throw InputError(fmt::format("{}: {}", context.tracer.string(), problem));
  if (process.signal != 0 || process.exit_code != 0)
    throw InputError(fmt::format("scene '{}': the tracer failed:\n{}", wanted.name, process.output));
  return image::read_image(file);
}

// Noise power falls as 1 / spp, so what is there says how many samples are needed in all.
int enough_spp(int spp, double times) {
  constexpr double kReserve = 1.1;  // the noise is an estimate, too
  return static_cast<int>(std::min<double>(kMostReferenceSpp, std::ceil(spp * times * kReserve)));
}

// Bounds a pass to some two minutes on two cores. By samples and not by time: the passes, and so the bytes of
// the reference, must not depend on how fast the machine is.
int most_spp_of_a_pass(std::size_t pixels) {
  constexpr std::size_t kMostSamples = std::size_t{1} << 28;
  return static_cast<int>(std::clamp<std::size_t>(kMostSamples / pixels, 1, kMostReferenceSpp));
}

}  // namespace

std::optional<RenderedReference> render_reference(const WantedReference& wanted,
                                                  const ReferenceSettings& settings,
                                                  const ReferenceContext& context,
                                                  const UnfinishedReference& unfinished) {
  RenderedReference rendered;
  int target = settings.spp > 0 ? settings.spp : std::min(wanted.spp, kMostReferenceSpp);
  while (rendered.sum.spp < target) {
    const Pass pass{std::min(target - rendered.sum.spp, most_spp_of_a_pass(wanted.pixels)),
                    static_cast<std::uint64_t>(settings.seed) + rendered.sum.passes.size()};
    auto image = kept_pass(unfinished, pass);
    const bool is_of_an_earlier_call = image.has_value();
    if (!image) image = render_pass(wanted, pass, settings, context, file_of(unfinished, pass));
    if (!image) return std::nullopt;
    add_pass(rendered.sum, *image, pass);
    rendered.image = mean_image(rendered.sum);
    if (image::channel_index(rendered.image, "variance.R") < 0) {
      const auto& header = image->attributes;
      const auto reason = header.find("orbs.variance");
      throw InputError(fmt::format("{}: the tracer wrote no variance{}", context.tracer.string(),
                                   reason == header.end() ? "" : " (" + reason->second + ")"));
    }
    rendered.noise = noise_of(rendered.image);
    const double times = times_too_noisy(rendered.noise, wanted.most_noise);
    if (settings.spp == 0) target = times <= 1 ? rendered.sum.spp : enough_spp(rendered.sum.spp, times);
    if (rendered.sum.spp < target)
      context.say(fmt::format("      {:<18} {:>7} of some {} spp, noise {}{}", wanted.name, rendered.sum.spp,
                              target, noise_text(rendered.noise),
                              is_of_an_earlier_call ? ", of an earlier call" : ""));
  }
  return rendered;
}

}  // namespace orbs::references
