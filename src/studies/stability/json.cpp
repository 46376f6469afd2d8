#include "studies/stability/json.h"

#include "base/error.h"
#include "json/document.h"
#include "json/field_reader.h"
#include "json/field_writer.h"
#include "studies/stability/report.h"

#include <fmt/format.h>

namespace orbs::studies {

std::vector<results::Definition> stability_definitions() {
  return {
      {"mean",
       "mean over pixels and pairs of seeds of changed - original, divided by the mean of the original; a "
       "pixel's value is (R + G + B) / 3, linear Rec.709, no clamp; the image of the changed scene is first "
       "turned back into what the original shows"},
      {"block",
       "the same of a block of 8 x 8 px, divided by its mean in the original, but at least by a tenth of the "
       "image's mean; of the blocks that are off for sure the one that is off most, else the most certain one"},
      {"mean_error, block_error",
       "standard error from the scatter of each pixel's difference over the pairs; 0 with one pair, of a "
       "renderer without noise"},
      {"pixels",
       "mean over pixels and pairs of the absolute difference, divided by the mean of the original: with other "
       "random numbers mostly noise; by double precision, with the same ones, the share of the image that "
       "rounding decides"},
      {"confidence",
       "1 - probability that noise makes such a difference: Student's distribution with the degrees of "
       "freedom of Welch and Satterthwaite, times the number of blocks plus one"},
      {"outcome",
       "breaks: the mean is off by more than mean_bound or a block by more than block_bound, each with a "
       "confidence of 0.9999; or an exact relation is not followed to the bit; or pixels by double precision are "
       "above pixels_bound. no image: the renderer ends "
       "without one. inconclusive: the standard error of the mean is above 0.25 %. not applicable: the scene "
       "has nothing that the relation changes"},
      {"held_to", "of a sweep: the magnitude up to which all scenes held without a break before"},
      {"decades", "the absolute logarithm to base ten of held_to"},
  };
}

std::string stability_json(const StabilityRecord& record) {
  json::Writer out;
  out.begin_object().member("format", results::kStability.format);
  StabilityStudy study{.record = record, .matrix = stability_cells(record), .summaries = {}};
  for (std::size_t renderer = 0; renderer < record.renderers.size(); ++renderer)
    study.summaries.push_back(stability_summary(record, renderer));
  json::write_fields(out, study);
  return out.end_object().text();
}

StabilityRecord read_stability_file(const std::filesystem::path& file) {
  const auto document = json::parse_file(file);
  json::ObjectReader in(document);
  json::check_format(in, results::kStability.format);
  StabilityRecord record;
  json::FieldReader read(in);
  fields(read, record);
  for (const auto& step : record.steps)
    if (step.scene >= record.scenes.size() || step.renderer >= record.renderers.size() ||
        step.relation >= record.relations.size())
      throw InputError(
          fmt::format("{}: a step is of scene {}, renderer {} and relation {}, which are not listed",
                      file.string(), step.scene, step.renderer, step.relation));
  return record;
}

}  // namespace orbs::studies
