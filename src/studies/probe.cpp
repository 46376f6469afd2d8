#include "studies/probe.h"

#include "adapters/export.h"
#include "adapters/native_scene.h"
#include "base/error.h"
#include "base/scratch_folder.h"
#include "base/text.h"
#include "runner/render_once.h"
#include "studies/probe_report.h"

#include <fmt/format.h>

namespace orbs::studies {

namespace {

struct ProbeInputs {
  const runner::Plan& plan;
  const ProbeSettings& settings;
  const StudyContext& context;
  const std::filesystem::path& scratch;
};

template <typename Compare>
ProbeImage render_pass(const ProbeInputs& inputs,
                       const runner::ChosenRenderer& renderer,
                       const scene::Scene& scene,
                       Compare compare) {
  ProbeImage taken;
  const auto prepared = adapters::prepare_scene(renderer.entry, scene);
  if (const auto* reason = std::get_if<std::string>(&prepared)) {
    taken.unsupported = *reason;
    return taken;
  }
  try {
    const auto folder = inputs.scratch / renderer.entry.name;
    std::filesystem::remove_all(folder);
    const auto subject = runner::prepare_render(renderer, inputs.plan, scene, folder);
    const auto made =
        runner::render_once(subject, {inputs.settings.spp, 1, inputs.settings.threads}, inputs.context.stop);
    if (!made) {
      taken.no_image = "was stopped";
      return taken;
    }
    taken.findings = compare(made->image);
  } catch (const InputError& e) {
    taken.no_image = split(e.what(), '\n').front();
  }
  return taken;
}

void say_record(const ProbeInputs& inputs, const ProbeRecord& record) {
  inputs.context.say(fmt::format("{:<20} {:<8} {}", record.scene, record.renderer, probe_message(record)));
}

void probe_scene(const ProbeInputs& inputs,
                 const runner::PlannedScene& planned,
                 std::vector<ProbeRecord>& records) {
  const auto probe = make_id_pass(*planned.scene, inputs.settings.most_px);
  const auto surfaces = primary_visibility(probe.scene, {}, inputs.settings.threads);
  const auto uv_scene = make_uv_pass(probe, inputs.scratch / "ramp.exr");
  for (const auto& renderer : inputs.plan.renderers) {
    if (is_stopped(inputs.context)) return;
    ProbeRecord record{planned.name, renderer.entry.name, {}, {}, {}};
    for (const auto& object : probe.objects) record.object_names.push_back(object.name);
    if (!adapters::native_scene(renderer.entry, planned.file, planned.name).empty()) {
      record.id_pass.unsupported = "is rendered from a hand-written scene, which nobody can colour";
      say_record(inputs, record);
      records.push_back(std::move(record));
      continue;
    }
    record.id_pass = render_pass(inputs, renderer, probe.scene, [&](const image::Image& image) {
      return compare_id_pass(probe, surfaces, image);
    });
    if (record.id_pass.unsupported.empty())
      record.uv_pass = render_pass(inputs, renderer, uv_scene, [&](const image::Image& image) {
        return compare_uv_pass(probe, surfaces, image);
      });
    if (is_stopped(inputs.context)) return;
    say_record(inputs, record);
    records.push_back(std::move(record));
  }
}

}  // namespace

std::vector<ProbeRecord> run_probe(const runner::Plan& plan,
                                   const ProbeSettings& settings,
                                   const StudyContext& context) {
  const ScratchFolder scratch("orbs-probe");
  write_ramp(scratch.path() / "ramp.exr");
  const ProbeInputs inputs{plan, settings, context, scratch.path()};
  std::vector<ProbeRecord> records;
  for (const auto& scene : plan.scenes)
    if (!is_stopped(context)) probe_scene(inputs, scene, records);
  return records;
}

}  // namespace orbs::studies
