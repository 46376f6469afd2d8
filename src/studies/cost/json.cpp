#include "studies/cost/json.h"

#include "base/error.h"
#include "json/document.h"
#include "json/field_reader.h"
#include "json/field_writer.h"
#include "json/writer.h"

#include <fmt/format.h>

namespace orbs::studies {

namespace {

std::string number_text(const std::optional<double>& number) {
  return number ? fmt::format("{}", *number) : "";
}

}  // namespace

std::vector<results::Definition> cost_definitions() {
  std::vector<results::Definition> all;
  for (const auto& metric : kCostMetrics) all.push_back({metric.name, metric.definition});
  const std::vector<results::Definition> others{
      {"cpu_seconds",
       "user and system time of all processes of a render; the median of its seeds. Of a render whose seed is the "
       "last of as many images of one process: fixed_cpu_seconds + (that time - fixed_cpu_seconds) / images, where "
       "images are those rendered for each that counts"},
      {"wall_seconds",
       "from the start of the program to its end; the median of its seeds; of images likewise"},
      {"render_seconds", "what the renderer states itself; the median of its seeds"},
      {"trial_seconds",
       "the part of render_seconds that trial renderings took, which choose algorithms; likewise"},
      {"other_share",
       "the share of the time of all processors that processes other than the render took while it went on, from "
       "/proc/stat; a render with more than 0.05 is repeated up to twice, and then left out of every number, or, where its setting has "
       "no other, counts and is named as disturbed"},
      {"mean_ratios",
       "geometric mean over the scenes of the time of the second renderer over that of the first; the interval is "
       "Student's of the logarithms, by their scatter over the scenes; of one scene it is that of its seeds"},
      {"self_comparison",
       "the first renderer under two names on every scene, the third of its settings: ratios of CPU time and of "
       "relmse; 99 % intervals by the scatter of the seeds. scatter: the standard deviation over the scenes of the "
       "logarithm of the ratio"},
      {"interval",
       "95 % confidence: of medians between order statistics (of fewer than six values all of them), of "
       "means by Student's distribution"},
      {"fixed_cpu_seconds", "the scene in 4 x 4 px with 8 samples: start, reading, building, writing"},
      {"fit",
       "relmse(t) = bias_squared + variance / t^exponent, t: CPU seconds above the fixed cost that the samples "
       "take at the renderer's mean rate; weighted least squares. A floor is called where bias_squared is above 0 "
       "at a level of 1 in 1000, the model is not refuted, and a third of the last setting's error is bias"},
      {"times_to_error",
       "CPU seconds to a level, the fixed cost included: between two settings, linear in the logarithms; "
       "never beyond the settings"},
      {"efficiency", "1 / (relmse x CPU seconds) at the last setting that the reference can judge"},
      {"seconds_per_db",
       "the share by which the time grows for one more decibel, between the two last such settings"},
      {"on_frontier", "no other point of the scene, of any renderer, is faster and has less relmse"},
      {"below_reference_noise", "the noise of the reference makes more relmse than the renderer"},
  };
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

std::string cost_json(const CostRecord& record) {
  json::Writer out;
  out.begin_object().member("format", results::kCost.format);
  json::write_fields(out, CostStudy{.record = record, .numbers = cost_numbers(record)});
  return out.end_object().text();
}

CostRecord read_cost_file(const std::filesystem::path& file) {
  const auto document = json::parse_file(file);
  json::ObjectReader in(document);
  json::check_format(in, results::kCost.format);
  CostRecord record;
  json::FieldReader read(in);
  fields(read, record);
  for (const auto& sweep : record.sweeps)
    if (sweep.target >= record.targets.size() || sweep.renderer >= record.renderers.size())
      throw InputError(fmt::format("{}: a sweep is of target {} and renderer {}, which are not listed",
                                   file.string(), sweep.target, sweep.renderer));
  for (const auto& render : record.renders)
    if (render.target >= record.targets.size() || render.renderer >= record.renderers.size())
      throw InputError(fmt::format("{}: a render is of target {} and renderer {}, which are not listed",
                                   file.string(), render.target, render.renderer));
  return record;
}

std::string cost_csv(const CostRecord& record) {
  std::string text =
      "target,renderer,purpose,setting,spp,seed,order,images,cpu_seconds,wall_seconds,render_seconds,trial_seconds,load,other_share,repeats,relmse,mse,psnr_srgb8,"
      "flip\n";
  for (const auto& render : record.renders)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                        record.targets[render.target].name, record.renderers[render.renderer].name,
                        json::to_text(render.purpose), render.setting, render.spp, render.seed, render.order,
                        render.images, render.cpu_seconds, render.wall_seconds,
                        number_text(render.render_seconds), number_text(render.trial_seconds), render.load,
                        number_text(render.other_share), render.repeats, number_text(render.relmse),
                        number_text(render.mse), number_text(render.psnr_srgb8), number_text(render.flip));
  return text;
}

}  // namespace orbs::studies
