#include "studies/probe/probe.h"

#include "adapters/export.h"
#include "adapters/native_scene.h"
#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "metrics/seeds.h"
#include "run/job_folder.h"
#include "run/render.h"
#include "studies/probe/frames_pass.h"
#include "studies/probe/report.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

constexpr const char* kRampExr = "ramp.exr";
constexpr const char* kRampPng = "ramp.png";

struct ProbeInputs {
  const run::Plan& plan;
  const ProbeSettings& settings;
  const StudyContext& context;
  const std::filesystem::path& scratch;
};

// The renderer as if it declared the lamps and the plain emission that an id pass is made of: a new entry
// that declares no more than M1 can be probed, too. Textured emission is left to those that declare it.
run::ChosenRenderer with_emission(run::ChosenRenderer renderer) {
  for (const auto* requirement : {"M2", "L1", "L2"}) {
    const auto code = registry::parse_requirement(requirement);
    renderer.entry.support.declares[code.group].insert(code.level);
  }
  return renderer;
}

// With the variances that the renderer writes, or else with those that two seeds give; those of ratios are
// known by two seeds alone. Nothing when stopped.
std::optional<image::Image> render_with_noise(const ProbeInputs& inputs,
                                              const run::PreparedRender& subject,
                                              Ramp ramp,
                                              bool& has_equal_seeds) {
  std::vector<image::Image> replicas;
  const bool has_seed = registry::takes_seed(subject.renderer.entry.command);
  for (const int seed : {1, 2}) {
    // Noise of colours may be negative where the colour is dark.
    const auto made = run::render_once(subject,
                                       {.spp = inputs.settings.spp,
                                        .seed = seed,
                                        .threads = inputs.settings.threads,
                                        .may_be_negative = true},
                                       inputs.context.stop);
    if (!made) return std::nullopt;
    replicas.push_back(ramp == Ramp::Reflected ? ratios_to_blue(made->image) : made->image);
    if (!has_seed || image::channel_index(replicas.back(), "variance.R") >= 0) break;
  }
  has_equal_seeds = replicas.size() > 1 && metrics::are_equal(replicas);
  return replicas.size() == 1 || has_equal_seeds ? replicas.front() : metrics::mean_and_variance_of(replicas);
}

// In one line: how it ended, and the last of what it said.
std::string failure_text(const std::string& what) {
  auto lines = split(what, '\n');
  auto text = std::string(trim(lines.front()));
  std::erase_if(lines, [](const auto& line) { return trim(line).empty(); });
  return lines.size() < 2 ? text : fmt::format("{} {}", text, trim(lines.back()));
}

// Where a pass of a scene is rendered; of its own where all is kept.
std::filesystem::path folder_of(const ProbeInputs& inputs,
                                const scene::Scene& scene,
                                const std::string& renderer,
                                const std::string& pass) {
  return inputs.settings.keep.empty() ? inputs.scratch / renderer
                                      : inputs.scratch / scene.name / renderer / pass;
}

template <typename Compare>
ProbeImage render_pass(const ProbeInputs& inputs,
                       const run::ChosenRenderer& renderer,
                       const scene::Scene& scene,
                       const std::string& pass,
                       Ramp ramp,
                       Compare compare) {
  ProbeImage taken;
  const auto prepared = adapters::prepare_scene(renderer.entry, scene);
  if (const auto* reason = std::get_if<std::string>(&prepared)) {
    taken.unsupported = *reason;
    return taken;
  }
  try {
    const auto folder = folder_of(inputs, scene, renderer.entry.name, pass);
    run::make_way(folder);
    const auto subject = run::prepare_render(renderer, inputs.plan, scene, folder);
    const auto image = render_with_noise(inputs, subject, ramp, taken.has_equal_seeds);
    if (!image) {
      taken.no_image = "was stopped";
      return taken;
    }
    taken.findings = compare(*image);
  } catch (const InputError& e) {
    taken.no_image = failure_text(e.what());
  }
  return taken;
}

// By textured emission, or else by textures that reflect: many renderers have these alone.
ProbeImage uv_pass_of(const ProbeInputs& inputs,
                      const run::ChosenRenderer& renderer,
                      const ProbeScene& probe,
                      const std::vector<VisibleSurface>& surfaces,
                      int uv_set,
                      const char* ramp_file) {
  const auto file = inputs.scratch / ramp_file;
  const double step = ramp_file == std::string_view(kRampPng) ? kStepOfPng : 0;
  const auto pass = fmt::format("uv-{}-{}", uv_set + 1, ramp_file);
  const auto compared = [&](Ramp ramp) {
    return
        [&, ramp](const image::Image& image) { return compare_uv_pass(probe, surfaces, image, ramp, step); };
  };
  auto taken = render_pass(inputs, renderer, make_uv_pass(probe, file, uv_set), pass, Ramp::Emitted,
                           compared(Ramp::Emitted));
  if (taken.unsupported.empty()) return taken;
  taken = render_pass(inputs, renderer, make_reflecting_uv_pass(probe, file, uv_set), pass, Ramp::Reflected,
                      compared(Ramp::Reflected));
  if (taken.unsupported.empty() && taken.no_image.empty() && taken.findings.compared == 0)
    taken.unsupported =
        "its emission has no textures (M6), and no light of an environment reaches a textured pixel";
  return taken;
}

// Not every renderer reads a texture of floats. Eight bits are enough for what is compared.
ProbeImage uv_pass(const ProbeInputs& inputs,
                   const run::ChosenRenderer& renderer,
                   const ProbeScene& probe,
                   const std::vector<VisibleSurface>& surfaces,
                   int uv_set) {
  auto taken = uv_pass_of(inputs, renderer, probe, surfaces, uv_set, kRampExr);
  if (taken.no_image.empty() || is_stopped(inputs.context)) return taken;
  auto other = uv_pass_of(inputs, renderer, probe, surfaces, uv_set, kRampPng);
  if (!other.no_image.empty()) return taken;
  other.note = fmt::format("of a PNG; with an EXR {}", taken.no_image);
  return other;
}

// Nothing is compared where no mesh has second coordinates, and for renderers that are not given them.
ProbeImage second_uv_pass(const ProbeInputs& inputs,
                          const run::ChosenRenderer& renderer,
                          const ProbeScene& probe) {
  const auto second = at_second_coordinates(probe);
  if (!second) return {};
  return uv_pass(inputs, renderer, probe, primary_visibility(second->scene, {}, inputs.settings.threads), 1);
}

// Whether something that is shown turns its normals or its grain with the coordinates.
bool follows_frames(const scene::Scene& scene) {
  const auto shown = scene::visible_materials(scene);
  return std::any_of(shown.begin(), shown.end(), [&](int index) {
    const auto& material = material_at(scene, index);
    return turns_normals(material.detail) || std::holds_alternative<scene::AnisotropicGgx>(material.model);
  });
}

// Without a map, and with one that leans to u and to v.
ProbeImage frames_pass(const ProbeInputs& inputs,
                       const run::ChosenRenderer& renderer,
                       const ProbeScene& probe,
                       const std::vector<VisibleSurface>& surfaces) {
  const auto plain_scene = make_frames_pass(probe, surfaces, {});
  if (!plain_scene) return {};
  image::Image plain;
  const auto first =
      render_pass(inputs, renderer, *plain_scene, "frames", Ramp::Emitted, [&](const image::Image& image) {
        plain = image;
        return ProbeFindings{};
      });
  if (!first.unsupported.empty() || !first.no_image.empty()) return first;
  ProbeImage taken;
  for (const Lean lean : {Lean::U, Lean::V}) {
    const auto file = inputs.scratch / (lean == Lean::U ? "leaning-u.png" : "leaning-v.png");
    write_leaning_map(lean, file);
    const auto scene = make_frames_pass(probe, surfaces, file);
    const auto* const pass = lean == Lean::U ? "frames-u" : "frames-v";
    const auto one = render_pass(
        inputs, renderer, *scene, pass, Ramp::Emitted,
        [&](const image::Image& image) { return compare_frames(probe, surfaces, plain, image, lean); });
    if (!one.unsupported.empty() || !one.no_image.empty()) return one;
    taken.findings.compared += one.findings.compared;
    if (taken.findings.mismatches.empty()) taken.findings.mismatches = one.findings.mismatches;
  }
  return taken;
}

// The layers that the renderer can be asked for, each tried by itself.
std::vector<std::string> layers_to_ask(const registry::Renderer& renderer,
                                       const ProbeScene& probe,
                                       std::string& unsupported) {
  std::vector<std::string> layers;
  for (const auto& layer : kProbedLayers) {
    auto scene = probe.scene;
    scene.outputs.layers = {layer};
    const auto prepared = adapters::prepare_scene(renderer, scene);
    if (const auto* reason = std::get_if<std::string>(&prepared))
      unsupported = *reason;
    else
      layers.push_back(layer);
  }
  if (!layers.empty()) unsupported.clear();
  return layers;
}

ProbeLayers layers_pass(const ProbeInputs& inputs,
                        const run::ChosenRenderer& renderer,
                        const ProbeScene& probe,
                        const std::vector<VisibleSurface>& surfaces) {
  ProbeLayers taken;
  auto layers = layers_to_ask(renderer.entry, probe, taken.unsupported);
  if (layers.empty()) return taken;
  auto scene = probe.scene;
  scene.outputs.layers = layers;
  const auto made =
      render_pass(inputs, renderer, scene, "layers", Ramp::Emitted, [&](const image::Image& image) {
        taken.findings = compare_layers(probe, surfaces, image, layers);
        return ProbeFindings{};
      });
  taken.no_image = made.no_image;
  if (taken.no_image.empty()) taken.layers = std::move(layers);
  return taken;
}

void say_record(const ProbeInputs& inputs, const ProbeRecord& record) {
  inputs.context.say(fmt::format("{:<20} {:<8} {}", record.scene, record.renderer, probe_message(record)));
}

void probe_scene(const ProbeInputs& inputs,
                 const run::PlannedScene& planned,
                 std::vector<ProbeRecord>& records) {
  const auto probe = make_id_pass(*planned.scene, inputs.settings.most_px);
  const auto surfaces = primary_visibility(probe.scene, {}, inputs.settings.threads);
  for (const auto& chosen : inputs.plan.renderers) {
    if (is_stopped(inputs.context)) return;
    const auto renderer = with_emission(chosen);
    ProbeRecord record{planned.name, renderer.entry.name, {}, {}, {}, {}, {}, {}};
    for (const auto& object : probe.objects) record.object_names.push_back(object.name);
    if (!adapters::native_scene(renderer.entry, planned.file, planned.name).empty()) {
      record.id_pass.unsupported = "is rendered from a hand-written scene, which nobody can colour";
      say_record(inputs, record);
      records.push_back(std::move(record));
      continue;
    }
    record.id_pass =
        render_pass(inputs, renderer, probe.scene, "id", Ramp::Emitted,
                    [&](const image::Image& image) { return compare_id_pass(probe, surfaces, image); });
    if (record.id_pass.unsupported.empty()) {
      record.uv_pass = uv_pass(inputs, renderer, probe, surfaces, 0);
      record.second_uv_pass = second_uv_pass(inputs, renderer, probe);
      if (follows_frames(*planned.scene)) record.frames = frames_pass(inputs, renderer, probe, surfaces);
      record.layers = layers_pass(inputs, renderer, probe, surfaces);
    }
    if (is_stopped(inputs.context)) return;
    say_record(inputs, record);
    records.push_back(std::move(record));
  }
}

}  // namespace

std::vector<ProbeRecord> run_probe(const run::Plan& plan,
                                   const ProbeSettings& settings,
                                   const StudyContext& context) {
  std::optional<ScratchFolder> scratch;
  if (settings.keep.empty()) scratch.emplace("orbs-probe");
  const auto folder = scratch ? scratch->path() : settings.keep;
  write_ramps(folder / kRampExr, folder / kRampPng);
  const ProbeInputs inputs{plan, settings, context, folder};
  std::vector<ProbeRecord> records;
  for (const auto& scene : plan.scenes)
    if (!is_stopped(context)) probe_scene(inputs, scene, records);
  return records;
}

}  // namespace orbs::studies
