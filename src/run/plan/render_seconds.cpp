#include "run/plan/render_seconds.h"

#include "base/error.h"
#include "base/files_inside.h"
#include "base/pattern.h"
#include "base/text.h"
#include "json/document.h"
#include "json/field_reader.h"
#include "json/object_reader.h"
#include "registry/image_size.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace orbs::run {

namespace {

// CPU seconds for the pixels of the scene's full size.
struct RecordedSeconds {
  double of_a_sample = 0;
  double of_all = 0;  // the samples of the recorded run, which took as many as its verdicts needed
};

struct RecordedTimes {
  std::string suite;
  std::string size;
  std::map<std::pair<std::string, std::string>, RecordedSeconds> of_scenes;  // by renderer and scene
};

double full_pixels_for_one(const std::string& size) {
  const double divisor = registry::size_divisor(size);
  return divisor * divisor;
}

RecordedTimes read_times(const std::filesystem::path& file) {
  const auto document = json::parse_file(file);
  json::ObjectReader in(document);
  json::check_format(in, "orbs-render-times/1");
  in.text("machine");
  RecordedTimes times{in.text("suite"), in.text("size"), {}};
  const double scale = full_pixels_for_one(times.size);
  for (auto& render : in.objects("renders")) {
    auto name = std::pair{render.text("renderer"), render.text("scene")};
    const double seconds = render.number("cpu_seconds", json::kPositive);
    const int spp = render.integer("spp", 1, std::numeric_limits<int>::max());
    render.finish();
    times.of_scenes.emplace(std::move(name), RecordedSeconds{seconds / spp * scale, seconds * scale});
  }
  in.finish();
  return times;
}

// The middle of the times of a sample of one renderer, or of all where it has none.
double typical_seconds(const RecordedTimes& times, const std::string& renderer) {
  std::vector<double> seconds;
  for (const bool is_any : {false, true}) {
    for (const auto& [name, time] : times.of_scenes)
      if (is_any || name.first == renderer) seconds.push_back(time.of_a_sample);
    if (!seconds.empty()) break;
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

// Of most scenes of the shipped file. Another scene's pixels are counted against it.
constexpr double kTypicalPixels = 512 * 512;

// Of the run's size.
double pixels_of(const PlannedScene& scene, const std::string& size) {
  if (!scene.scene) return kTypicalPixels / full_pixels_for_one(size);  // a plan that nobody renders
  return static_cast<double>(scene.scene->camera.width_px) * scene.scene->camera.height_px;
}

}  // namespace

std::filesystem::path shipped_times_file(const Plan& plan) {
  return plan.root / "data/bench/render-times.json";
}

std::vector<std::optional<ShippedTime>> shipped_cpu_seconds(const Plan& plan) {
  std::vector<std::optional<ShippedTime>> seconds(plan.jobs.size());
  const auto file = shipped_times_file(plan);
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return seconds;
  const auto times = read_times(file);
  if (times.of_scenes.empty()) return seconds;
  const auto size = registry::size_text(plan.settings.size_divisor);
  for (std::size_t job = 0; job < plan.jobs.size(); ++job) {
    const auto& planned = plan.jobs[job];
    const auto& scene = plan.scenes[planned.scene];
    const auto& renderer = plan.renderers[planned.renderer].entry.name;
    const auto found = times.of_scenes.find({renderer, scene.name});
    if (times.suite == plan.suite.name && found != times.of_scenes.end()) {
      const auto& recorded = found->second;
      const double all = planned.first_spp > 0 ? recorded.of_all : recorded.of_a_sample * planned.spp;
      const auto divisor = static_cast<double>(scene.size_divisor);
      seconds[job] = {all / (divisor * divisor), size != times.size};
    } else {
      seconds[job] = {
          typical_seconds(times, renderer) * planned.spp * pixels_of(scene, size) / kTypicalPixels, true};
    }
  }
  return seconds;
}

std::vector<double> estimated_cpu_seconds(const Plan& plan) {
  std::vector<double> estimated;
  for (const auto& known : shipped_cpu_seconds(plan))
    estimated.push_back(known.value_or(ShippedTime{}).cpu_seconds);
  return estimated;
}

namespace {

// Seconds in the units of time that programs write.
const std::map<std::string, double>& unit_seconds() {
  static const std::map<std::string, double> kUnits{{"us", 1e-6}, {"ms", 1e-3}, {"s", 1},    {"m", 60},
                                                    {"min", 60},  {"h", 3600},  {"d", 86400}};
  return kUnits;
}

// A number has its unit in the group behind it; without units one number is seconds, two are minutes and
// seconds, three hours, minutes and seconds.
std::optional<double> in_output(const std::string& pattern, const std::string& output) {
  const auto groups = Pattern(pattern).last_match(output);
  if (groups.empty()) return std::nullopt;
  double sum = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto number = to_number(trim(groups[i]));
    if (!number) return std::nullopt;
    const auto unit = i + 1 < groups.size() ? unit_seconds().find(groups[i + 1]) : unit_seconds().end();
    if (unit == unit_seconds().end()) {
      sum = 60 * sum + *number;
    } else {
      sum += *number * unit->second;
      ++i;
    }
  }
  return sum;
}

// The library of regular expressions reads no further than to a NUL.
std::string without_nul(std::string output) {
  std::replace(output.begin(), output.end(), '\0', ' ');
  return output;
}

std::optional<double> in_file(const registry::RenderSeconds& place, const std::filesystem::path& folder) {
  constexpr std::size_t kMost_bytes = std::size_t{16} << 20;
  const auto file = open_inside(folder, place.file);
  if (!file || file->size() > kMost_bytes) return std::nullopt;
  // The renderer's file is its own affair: one that is broken costs its time, not the image.
  try {
    const auto document = json::parse(place.file, file->read(0, static_cast<std::size_t>(file->size())));
    json::ObjectReader at(document);
    const auto keys = split(place.key, '/');
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) at = at.object(keys[i]);
    return at.number(keys.back());
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<double> render_seconds(const registry::RenderSeconds& place,
                                     const std::string& output,
                                     const std::filesystem::path& folder) {
  auto number = place.pattern.empty() ? std::nullopt : in_output(place.pattern, without_nul(output));
  if (!place.file.empty()) number = in_file(place, folder);
  if (number) *number *= place.unit_seconds;
  // No render took less than no time, or 30 years: what says so is no time.
  constexpr double kMost_seconds = 1e9;
  return number && *number >= 0 && *number <= kMost_seconds ? number : std::nullopt;
}

void forget_render_seconds(const registry::RenderSeconds& place, const std::filesystem::path& folder) {
  std::error_code ignored;
  if (!place.file.empty() && open_inside(folder, place.file))
    std::filesystem::remove(folder / place.file, ignored);
}

}  // namespace orbs::run
