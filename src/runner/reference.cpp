#include "runner/reference.h"

#include "adapters/process.h"
#include "adapters/programs.h"
#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "image/image_io.h"
#include "registry/cases.h"
#include "runner/choose.h"
#include "runner/execute.h"
#include "runner/judge.h"
#include "runner/noise.h"
#include "runner/summary.h"
#include "scene/load_scene.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace orbs::runner {

namespace {

constexpr int kInterrupted = 130;

struct Wanted {
  std::string name;
  std::filesystem::path file;
  std::filesystem::path target;
  int spp = 64;         // of the case: where the search for enough samples begins
  double noise_db = 0;  // PSNR that the noise alone must reach
  bool split_paths = false;
};

// The strictest of the gates that look at a scene; 0 where no gate is in dB.
double gate_db(const registry::Case& one_case) {
  return one_case.gate.metric == "psnr_srgb8" ? one_case.gate.min.value_or(0) : 0;
}

std::vector<Wanted> wanted_references(const std::vector<registry::Case>& cases,
                                      const registry::Suite& suite) {
  std::vector<Wanted> all;
  for (const auto& one_case : cases)
    for (const auto& scene : one_case.scenes) {
      auto found = std::find_if(all.begin(), all.end(), [&](const auto& w) { return w.name == scene.name; });
      if (found == all.end()) {
        all.push_back(
            {scene.name, scene.file, suite.references / (scene.name + ".exr"), scene.spp, 0, false});
        found = std::prev(all.end());
      }
      found->noise_db = std::max(found->noise_db, gate_db(one_case) + kReferenceMargin_db);
      for (const auto& share : one_case.path_shares)
        found->split_paths = found->split_paths || share.scene == scene.name;
    }
  return all;
}

void refuse_replacing(const std::vector<Wanted>& all, const std::string& reason) {
  if (!reason.empty()) return;
  std::vector<std::string> existing;
  std::error_code ignored;
  for (const auto& wanted : all)
    if (std::filesystem::exists(wanted.target, ignored)) existing.push_back(wanted.name);
  if (!existing.empty())
    throw InputError(
        fmt::format("references exist for {}; say why they may be replaced with --accept \"reason\"",
                    fmt::join(existing, ", ")));
}

// A folder of ours for unfinished pictures.
class ScratchFolder {
 public:
  ScratchFolder()
      : path_(std::filesystem::temp_directory_path() / fmt::format("orbs-reference-{}", ::getpid())) {
    std::filesystem::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct Rendered {
  image::Image picture;
  std::vector<std::string> argv;
  int spp = 0;
  double noise_db = 0;
};

// Nothing when stopped. InputError with the tracer's last words when it fails: a fault of ours or of the
// scene.
std::optional<Rendered> render(const Wanted& wanted,
                               int spp,
                               const ReferenceSettings& settings,
                               const ReferenceContext& context,
                               const std::filesystem::path& scratch) {
  constexpr double kDay_seconds = 86400;
  const auto output = scratch / "reference.exr";
  adapters::ProcessRequest request;
  request.argv = {context.tracer.string(),
                  wanted.file.string(),
                  "-o",
                  output.string(),
                  "--spp",
                  std::to_string(spp),
                  "--seed",
                  std::to_string(settings.seed),
                  "--threads",
                  std::to_string(settings.threads)};
  if (wanted.split_paths) request.argv.emplace_back("--split-paths");
  request.environment = adapters::child_environment({});
  request.time_limit_seconds = kDay_seconds;
  request.stop = context.stop;
  const auto process = adapters::run_process(request);
  if (process.stopped) return std::nullopt;
  if (!process.start_error.empty())
    throw InputError(fmt::format("{}: {}", context.tracer.string(), process.start_error));
  if (process.signal != 0 || process.exit_code != 0)
    throw InputError(fmt::format("scene '{}': the tracer failed:\n{}", wanted.name, process.output));
  Rendered rendered{image::read_image(output), request.argv, spp, 0};
  const auto mse = noise_mse_srgb8(rendered.picture, rendered.picture);
  if (!mse) throw InputError(fmt::format("{}: the tracer wrote no variance", context.tracer.string()));
  rendered.noise_db = psnr_srgb8_of(*mse);
  return rendered;
}

// Noise power falls as 1 / spp, so one render says how many samples another one needs.
int enough_spp(const Rendered& rendered, double wanted_db) {
  constexpr double kReserve = 1.1;
  const double factor = std::pow(10, (wanted_db - rendered.noise_db) / 10) * kReserve;
  return static_cast<int>(std::min<double>(kMostReferenceSpp, std::ceil(rendered.spp * factor)));
}

std::optional<Rendered> render_enough(const Wanted& wanted,
                                      const ReferenceSettings& settings,
                                      const ReferenceContext& context,
                                      const std::filesystem::path& scratch) {
  constexpr int kMostTries = 4;
  auto rendered = render(wanted, settings.spp > 0 ? settings.spp : wanted.spp, settings, context, scratch);
  for (int tries = 1; rendered && settings.spp == 0 && tries < kMostTries; ++tries) {
    if (rendered->noise_db >= wanted.noise_db || rendered->spp >= kMostReferenceSpp) break;
    rendered = render(wanted, enough_spp(*rendered, wanted.noise_db), settings, context, scratch);
  }
  return rendered;
}

void stamp(const Rendered& rendered,
           const Wanted& wanted,
           const ReferenceSettings& settings,
           image::Image& picture) {
  auto& passport = picture.attributes;
  const auto host = this_host();
  const auto version = passport.contains("orbs.version") ? passport.at("orbs.version") : "unknown";
  const auto plus = version.find('+');
  passport["orbs.commit"] = plus == std::string::npos ? "unknown" : version.substr(plus + 1);
  passport["orbs.settings"] = fmt::format("--spp {} --seed {}{}", rendered.spp, settings.seed,
                                          wanted.split_paths ? " --split-paths" : "");
  passport["orbs.scene_hash"] = hash_text(scene_content_hash(scene::load_scene(wanted.file), wanted.file));
  passport["orbs.host"] = host.name;
  passport["orbs.cpu"] = host.cpu;
  passport["orbs.date"] = local_time_now();
  passport["orbs.noise_psnr_srgb8_db"] = fmt::format("{:.2f}", rendered.noise_db);
  passport["orbs.reason"] = settings.reason.empty() ? "first reference of this scene" : settings.reason;
  for (const auto& [name, share] : path_shares(rendered.picture))
    passport["orbs.path." + name] = fmt::format("{:.6g}", share);
}

bool fits_half(const image::Image& picture) {
  constexpr float kLargestHalf = 65504;
  return std::all_of(picture.pixels.begin(), picture.pixels.end(),
                     [](float x) { return std::fabs(x) <= kLargestHalf; });
}

}  // namespace

int render_references(const registry::Configuration& configuration,
                      const registry::Defaults& selection,
                      const ReferenceSettings& settings,
                      const ReferenceContext& context) {
  const auto& suite = registry::find_suite(configuration, selection.suite);
  const auto all = wanted_references(choose_cases(registry::load_cases(suite), selection), suite);
  refuse_replacing(all, settings.reason);
  for (const auto& wanted : all)
    with_note(fmt::format("reading scene '{}'", wanted.name), [&] { scene::load_scene(wanted.file); });
  std::filesystem::create_directories(suite.references);
  const ScratchFolder scratch;
  bool too_noisy = false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& wanted = all[i];
    const auto rendered = render_enough(wanted, settings, context, scratch.path());
    if (!rendered) {
      context.say(fmt::format("stopped at {}; {} of {} references are done", wanted.name, i, all.size()));
      return kInterrupted;
    }
    auto picture = without_layers(rendered->picture);
    stamp(*rendered, wanted, settings, picture);
    image::write_exr(picture, wanted.target,
                     fits_half(picture) ? image::Precision::Half : image::Precision::Float);
    const bool noisy = rendered->noise_db < wanted.noise_db;
    too_noisy = too_noisy || noisy;
    context.say(fmt::format("[{}/{}] {:<18} {:>7} spp, noise {:.2f} dB{}", i + 1, all.size(), wanted.name,
                            rendered->spp, rendered->noise_db,
                            noisy ? fmt::format("; {} is needed, so more samples", wanted.noise_db) : ""));
  }
  return too_noisy ? 1 : 0;
}

std::uint64_t scene_content_hash(const scene::Scene& scene, const std::filesystem::path& file) {
  auto hash = content_hash(read_file(file));
  const auto add = [&](const auto& values) {
    hash =
        content_hash({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0])}, hash);
  };
  for (const auto& mesh : scene.meshes) {
    add(mesh.positions);
    add(mesh.normals);
    add(mesh.tangents);
    add(mesh.uvs);
    add(mesh.triangles);
    add(mesh.triangle_materials);
  }
  for (const auto& texture : scene.textures) hash = content_hash(read_file(texture.file), hash);
  for (const auto& light : scene.lights)
    if (light.ies) hash = content_hash(read_file(light.ies->file), hash);
  return hash;
}

std::map<std::string, double> path_shares(const image::Image& picture) {
  std::vector<double> sums(picture.channel_count());
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    sums[i % sums.size()] += static_cast<double>(picture.pixels[i]);
  double whole = 0;
  std::map<std::string, double> shares;
  for (std::size_t c = 0; c < sums.size(); ++c) {
    const std::string_view name = picture.channels[c];
    if (name == "R" || name == "G" || name == "B") whole += sums[c];
    if (name.starts_with("path.") && name.size() > 7)
      shares[std::string(name.substr(5, name.size() - 7))] += sums[c];
  }
  for (auto& [name, share] : shares) share = whole > 0 ? share / whole : 0;
  return shares;
}

image::Image without_layers(const image::Image& picture) {
  const std::vector<std::string> kept{"R", "G", "B", "variance.R", "variance.G", "variance.B"};
  auto out = image::make_image(picture.width, picture.height, kept);
  out.attributes = picture.attributes;
  const auto colour = image::select_rgb(picture, "");
  const auto variance = image::select_rgb(picture, "variance.");
  for (std::size_t pixel = 0; pixel < out.pixel_count(); ++pixel)
    for (std::size_t c = 0; c < 3; ++c) {
      out.pixels[6 * pixel + c] = colour.pixels[3 * pixel + c];
      out.pixels[6 * pixel + 3 + c] = variance.pixels[3 * pixel + c];
    }
  return out;
}

}  // namespace orbs::runner
