#include "studies/probe.h"

#include "adapters/export.h"
#include "adapters/native_scene.h"
#include "base/error.h"
#include "base/scratch_folder.h"
#include "base/text.h"
#include "runner/render_once.h"

#include <fmt/format.h>

namespace orbs::studies {

namespace {

struct Stand {
  const runner::Plan& plan;
  const ProbeSettings& settings;
  const ProbeContext& context;
  const std::filesystem::path& scratch;
};

bool is_stopped(const ProbeContext& context) { return context.stop != nullptr && context.stop->load(); }

template <typename Compare>
ProbeImage take_image(const Stand& stand,
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
    const auto folder = stand.scratch / renderer.entry.name;
    std::filesystem::remove_all(folder);
    const auto subject = runner::prepare_render(renderer, stand.plan, scene, folder);
    const auto made =
        runner::render_once(subject, {stand.settings.spp, 1, stand.settings.threads}, stand.context.stop);
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

void say_record(const Stand& stand, const ProbeRecord& record) {
  stand.context.say(fmt::format("{:<20} {:<8} {}", record.scene, record.renderer, probe_message(record)));
}

void probe_scene(const Stand& stand, const runner::PlannedScene& planned, std::vector<ProbeRecord>& records) {
  const auto probe = coloured_by_thing(*planned.scene, stand.settings.most_px);
  const auto surfaces = primary_visibility(probe.scene, {}, stand.settings.threads);
  const auto coordinates = coloured_by_coordinates(probe, stand.scratch / "ramp.exr");
  for (const auto& renderer : stand.plan.renderers) {
    if (is_stopped(stand.context)) return;
    ProbeRecord record{planned.name, renderer.entry.name, {}, {}, {}};
    for (const auto& thing : probe.things) record.thing_names.push_back(thing.name);
    if (!adapters::native_scene(renderer.entry, planned.file, planned.name).empty()) {
      record.things.unsupported = "is rendered from a hand-written scene, which nobody can colour";
      say_record(stand, record);
      records.push_back(std::move(record));
      continue;
    }
    record.things = take_image(stand, renderer, probe.scene, [&](const image::Image& image) {
      return compare_things(probe, surfaces, image);
    });
    if (record.things.unsupported.empty())
      record.coordinates = take_image(stand, renderer, coordinates, [&](const image::Image& image) {
        return compare_coordinates(probe, surfaces, image);
      });
    if (is_stopped(stand.context)) return;
    say_record(stand, record);
    records.push_back(std::move(record));
  }
}

}  // namespace

std::vector<ProbeRecord> run_probe(const runner::Plan& plan,
                                   const ProbeSettings& settings,
                                   const ProbeContext& context) {
  const ScratchFolder scratch("orbs-probe");
  write_ramp(scratch.path() / "ramp.exr");
  const Stand stand{plan, settings, context, scratch.path()};
  std::vector<ProbeRecord> records;
  for (const auto& scene : plan.scenes)
    if (!is_stopped(context)) probe_scene(stand, scene, records);
  return records;
}

}  // namespace orbs::studies
