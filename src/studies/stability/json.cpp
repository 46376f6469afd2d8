#include "studies/stability/json.h"

#include "base/error.h"
#include "json/document.h"
#include "json/object_reader.h"
#include "results/field_reader.h"
#include "results/field_writer.h"
#include "results/stability_study.h"
#include "studies/stability/numbers.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

using json::Writer;

void put_definitions(Writer& out) {
  const auto put_one = [&](std::string_view name, std::string_view text) {
    out.begin_object().member("name", name).member("text", text).end_object();
  };
  out.key("definitions").begin_array();
  put_one(
      "mean",
      "mean over pixels and pairs of seeds of changed - original, divided by the mean of the original; a "
      "pixel's value is (R + G + B) / 3, linear Rec.709, no clamp; the image of the changed scene is first "
      "turned back into what the original shows");
  put_one(
      "block",
      "the same of a block of 8 x 8 px, divided by its mean in the original, but at least by a tenth of the "
      "image's mean; of the blocks that are off for sure the one that is off most, else the most certain one");
  put_one("mean_error, block_error",
          "standard error from the scatter of each pixel's difference over the pairs; 0 with one pair, of a "
          "renderer without noise");
  put_one(
      "pixels",
      "mean over pixels and pairs of the absolute difference, divided by the mean of the original: with other "
      "random numbers mostly noise; by double precision, with the same ones, the share of the image that "
      "rounding decides");
  put_one("confidence",
          "1 - probability that noise makes such a difference: Student's distribution with the degrees of "
          "freedom of Welch and Satterthwaite, times the number of blocks plus one");
  put_one(
      "outcome",
      "breaks: the mean is off by more than mean_bound or a block by more than block_bound, each with a "
      "confidence of 0.9999; or an exact relation is not followed to the bit; or pixels by double precision are "
      "above pixels_bound. no image: the renderer ends "
      "without one. inconclusive: the standard error of the mean is above 0.25 %. not applicable: the scene "
      "has nothing that the relation changes");
  put_one("held_to", "of a ladder: the magnitude up to which all scenes held without a break before");
  put_one("decades", "the absolute logarithm to base ten of held_to");
  out.end_array();
}

void put_cell(Writer& out, const StabilityRecord& record, const StabilityCell& cell) {
  out.begin_object()
      .member("relation", record.relations[cell.relation].name)
      .member("renderer", record.renderers[cell.renderer].name)
      .member("scenes", cell.scenes)
      .member("bit_equal", cell.scenes > 0 && cell.is_bit_equal)
      .member("inconclusive", cell.inconclusive);
  if (cell.held_to) out.member("held_to", *cell.held_to);
  if (cell.decades) out.member("decades", *cell.decades);
  if (cell.first_break) {
    const auto& step = record.steps[*cell.first_break];
    out.key("first_break")
        .begin_object()
        .member("magnitude", step.magnitude)
        .member("scene", record.scenes[step.scene].name)
        .member("outcome", step.outcome)
        .member("confidence", step.confidence)
        .member("reason", step.reason)
        .end_object();
  }
  out.end_object();
}

}  // namespace

std::string stability_json(const StabilityRecord& record) {
  Writer out;
  out.begin_object().member("format", results::kStabilityFormat);
  results::write_fields(out, record);
  put_definitions(out);
  out.key("matrix").begin_array();
  for (const auto& cell : stability_cells(record)) put_cell(out, record, cell);
  out.end_array();
  return out.end_object().text();
}

StabilityRecord read_stability_file(const std::filesystem::path& file) {
  const auto document = json::parse_file(file);
  json::ObjectReader in(document);
  results::check_format(in, results::kStabilityFormat);
  StabilityRecord record;
  results::FieldReader read(in);
  fields(read, record);
  for (const auto& step : record.steps)
    if (step.scene >= record.scenes.size() || step.renderer >= record.renderers.size() ||
        step.relation >= record.relations.size())
      throw InputError(
          fmt::format("{}: a step is of scene {}, renderer {} and relation {}, which are not listed",
                      file.string(), step.scene, step.renderer, step.relation));
  return record;
}

bool all_hold(const StabilityRecord& record) {
  const auto is = [&](const char* outcome) {
    return std::any_of(record.steps.begin(), record.steps.end(),
                       [&](const auto& step) { return step.outcome == outcome; });
  };
  return is(kHolds) && !is(kBreaks) && !is(kNoImage);
}

}  // namespace orbs::studies
