#include "run/plan/shipped_times.h"

#include "json/document.h"
#include "json/object_reader.h"
#include "registry/image_size.h"
#include "results/field_reader.h"

#include <limits>
#include <map>
#include <utility>

namespace orbs::run {

namespace {

// CPU seconds of one sample per pixel, by the names of renderer and scene.
using SecondsPerSample = std::map<std::pair<std::string, std::string>, double>;

SecondsPerSample read_times(const std::filesystem::path& file, const Plan& plan) {
  SecondsPerSample times;
  const auto document = json::parse_file(file);
  json::ObjectReader in(document);
  results::check_format(in, "orbs-render-times/1");
  in.text("machine");
  const bool is_same_suite = in.text("suite") == plan.suite.name;
  const bool is_same_size = in.text("size") == registry::size_text(plan.settings.size_divisor);
  for (auto& render : in.objects("renders")) {
    auto name = std::pair{render.text("renderer"), render.text("scene")};
    const double seconds = render.number("cpu_seconds", json::kPositive);
    const int spp = render.integer("spp", 1, std::numeric_limits<int>::max());
    render.finish();
    if (is_same_suite && is_same_size) times.emplace(std::move(name), seconds / spp);
  }
  in.finish();
  return times;
}

}  // namespace

std::filesystem::path shipped_times_file(const Plan& plan) {
  return plan.root / "data/bench/render-times.json";
}

std::vector<std::optional<double>> shipped_cpu_seconds(const Plan& plan) {
  std::vector<std::optional<double>> seconds(plan.jobs.size());
  const auto file = shipped_times_file(plan);
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return seconds;
  const auto times = read_times(file, plan);
  for (std::size_t job = 0; job < plan.jobs.size(); ++job) {
    const auto& planned = plan.jobs[job];
    const auto found =
        times.find({plan.renderers[planned.renderer].entry.name, plan.scenes[planned.scene].name});
    if (found != times.end()) seconds[job] = found->second * planned.spp;
  }
  return seconds;
}

std::vector<double> estimated_cpu_seconds(const Plan& plan) {
  const auto known = shipped_cpu_seconds(plan);
  double sum = 0;
  int count = 0;
  for (const auto& seconds : known)
    if (seconds) {
      sum += *seconds;
      ++count;
    }
  std::vector<double> estimated;
  for (const auto& seconds : known) estimated.push_back(seconds.value_or(count > 0 ? sum / count : 1));
  return estimated;
}

}  // namespace orbs::run
