#include "page/fixture_runs.h"

#include "base/files.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "page/fixture_records.h"
#include "results/run_folder.h"

#include <cmath>
#include <iostream>
#include <limits>
#include <string>

#include <fmt/format.h>

namespace orbs::page_tests {

namespace {

namespace fs = std::filesystem;
using results::JobRecord;
using results::RunRecord;
using results::TargetRecord;
using results::Verdict;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

image::Image ramp(int width, int height) {
  auto target = image::make_image(width, height, {"R", "G", "B"});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      target.at(x, y, 0) = static_cast<float>(x) / static_cast<float>(width);
      target.at(x, y, 1) = static_cast<float>(y) / static_cast<float>(height);
      target.at(x, y, 2) = 0.25F;
    }
  return target;
}

image::Image map_of(const image::Image& a, const image::Image& b, bool is_signed) {
  auto map = image::make_image(a.width, a.height, {"R", "G", "B"});
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    const float d = a.pixels[i] - b.pixels[i];
    map.pixels[i] = is_signed ? d : std::fabs(d);
  }
  return map;
}

void write_exr(const fs::path& folder, const std::string& file, const image::Image& target) {
  fs::create_directories((folder / file).parent_path());
  image::write_exr(target, folder / file);
}

// The images of m1_values by "one".
void add_values(const fs::path& folder, TargetRecord& target) {
  auto result = ramp(64, 48);
  const auto plain = result;
  auto reference = plain;
  reference.at(40, 20, 0) += 1.0F;
  reference.at(10, 30, 1) += 0.5F;
  result.at(5, 7, 0) = kNan;
  result.at(6, 7, 0) = kInfinity;
  result.at(8, 9, 0) = 70000.0F;
  result.at(9, 9, 0) = -0.5F;
  result.attributes["orbs.program"] = "one <b>1.0</b>";
  auto wobble = image::make_image(64, 48, {"Y"});
  wobble.at(3, 4, 0) = 0.75F;
  target.image = "one/values/result.exr";
  target.reference_image = "references/values.exr";
  write_exr(folder, target.image, result);
  image::write_png(image::display_image(result), folder / "one/values/result.png");
  write_exr(folder, target.reference_image, reference);
  write_exr(folder, "one/values/error-l1.exr", map_of(plain, reference, false));
  write_exr(folder, "one/values/error-signed.exr", map_of(plain, reference, true));
  write_exr(folder, "one/values/error-wobble.exr", wobble);
  target.maps = {{"l1", "one/values/error-l1.exr", "|result - reference|", false, 0.2},
                 {"signed", "one/values/error-signed.exr", "result - reference", true, 0.2},
                 {"wobble", "one/values/error-wobble.exr", "a map that nobody knows", false, 1}};
  target.reference_provenance = {{"program", "reference <i>tracer</i>"}, {"spp", "4096"}};
}

// The image of the same scene by "two": a quarter more in G everywhere.
void add_values_by_two(const fs::path& folder, TargetRecord& target) {
  auto result = ramp(64, 48);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) result.at(x, y, 1) += 0.25F;
  target.image = "two/values/result.exr";
  target.reference_image = "references/values.exr";
  write_exr(folder, target.image, result);
  image::write_png(image::display_image(result), folder / "two/values/result.png");
}

void add_stokes(const fs::path& folder, TargetRecord& target) {
  std::vector<std::string> channels{"R", "G", "B"};
  for (const char* layer : {"S0", "S1", "S2", "S3"})
    for (const char* c : {"R", "G", "B"}) channels.push_back(fmt::format("{}.{}", layer, c));
  auto result = image::make_image(32, 32, channels);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      for (std::size_t c = 0; c < channels.size(); ++c)
        result.at(x, y, c) = c < 6 ? 0.5F : static_cast<float>(x - 16) / 16.0F;
  target.image = "one/stokes/result.exr";
  target.reference_image = "references/stokes.exr";
  write_exr(folder, target.image, result);
  write_exr(folder, target.reference_image, result);
}

// Text that would be markup if anybody took it for that.
void add_markup(const fs::path& folder, RunRecord& run) {
  const std::string attack =
      "</script><script>document.title='owned'</script><img src=x onerror=\"document.title='owned'\">";
  run.cases.push_back(case_of("beta", "e1_markup", "Title " + attack));
  auto job = job_of("markup", "one", 1);
  job.files.log = "one/markup/log.txt";
  job.end.exit_code = 3;
  job.end.reason = attack;
  fs::create_directories(folder / "one/markup");
  write_file(folder / job.files.log, "line one\n" + attack + "\n\x1b[31mred\x1b[0m \xff\n");
  auto target = target_of("e1_markup", job, Verdict::Crash);
  target.reason = attack;
  target.measures.clear();
  target.checks.clear();
  run.jobs.push_back(job);
  run.targets.push_back(target);
}

// One image for each verdict by "two" and "three".
void add_all_verdicts(RunRecord& run) {
  for (std::size_t i = 0; i < results::kVerdicts.size(); ++i) {
    const auto verdict = results::kVerdicts.at(i);
    const auto name = fmt::format("g{}_verdict", i % 9 + 1);
    if (i < 9) run.cases.push_back(case_of("alpha", name, fmt::format("Verdict {}", i + 1)));
    for (const char* renderer : {"two", "three"}) {
      auto job = job_of(fmt::format("verdict-{}", i), renderer, 0.5 + static_cast<double>(i));
      run.targets.push_back(target_of(name, job, renderer == std::string("two") ? verdict : Verdict::Pass));
      run.jobs.push_back(std::move(job));
    }
  }
}

results::EffectStudyRecord effect_study() {
  results::EffectStudyRecord study;
  study.started = "2026-11-20T10:00:00";
  study.cpu = "a processor";
  study.cores = 2;
  study.rounds = 4;
  study.load = 0.1;
  study.load_end = 0.2;
  study.has_intervals = true;
  study.renders = 16;
  study.repeats = 1;
  study.disturbed = 0;
  study.unknown = 0;
  study.self_scenes = 1;
  study.self_differing = 0;
  study.self_ratio = 1.001;
  study.self_low = 0.98;
  study.self_high = 1.02;
  return study;
}

RunRecord small_run(const fs::path& folder) {
  auto run = blank_run({"one", "two", "three"});
  run.cases.push_back(case_of("alpha", "m1_values", "Known values"));
  const auto values = job_of("values", "one", 2);
  run.jobs.push_back(values);
  run.targets.push_back(target_of("m1_values", values, Verdict::Fail));
  add_values(folder, run.targets.back());
  run.targets.back().diagnosis = "shifted by (2, 1) px: then 60.2 dB";
  run.targets.back().checks.push_back(
      {.what = "edge_blur", .reason = "noise hides the edges", .min = {}, .max = 0.2, .decided = false});
  const auto by_two = job_of("values", "two", 4);
  run.jobs.push_back(by_two);
  run.targets.push_back(target_of("m1_values", by_two, Verdict::Pass));
  add_values_by_two(folder, run.targets.back());
  run.cases.push_back(case_of("beta", "a1_stokes", "Polarised light"));
  run.scenes.push_back(
      {"stokes",
       "polarised",
       {{"polarisation", "material 'filter'", "is a polariser"},
        {"polarisation", "the image", "holds Stokes vectors"}},
       {{"spectral", "material 'grey'", "is constant <b>"}},
       "G2/M1",
       {{"spectral", 0.8, 0.5, "mean -15 +- 0.1 %", 0.75, 0.85, -0.15, 0.001},
        {"rgb", 0.6, 0, "mean -15 +- 0.2 %"},
        {"polarised-bispectral", 1.04, 1.04, "same to the bit", 1.02, 1.06, 0, 0, true, true}}});
  run.effect_study = effect_study();
  const auto stokes = job_of("stokes", "one", 3);
  run.jobs.push_back(stokes);
  run.targets.push_back(target_of("a1_stokes", stokes, Verdict::Pass));
  add_stokes(folder, run.targets.back());
  add_markup(folder, run);
  add_all_verdicts(run);
  return run;
}

void add_case(RunRecord& run, const std::string& name) {
  run.cases.push_back(case_of("alpha", name, name));
  const auto job = job_of(name, "one", 1);
  run.jobs.push_back(job);
  run.targets.push_back(target_of(name, job, Verdict::Pass));
}

}  // namespace

void write_small_run(const fs::path& folder) {
  auto run = small_run(folder);
  add_case(run, "m9_new");
  write_run(std::move(run), folder);
}

void write_earlier_run(const fs::path& folder) {
  auto run = small_run(folder);
  run.started = "2026-01-01T00:00:00";
  for (auto& target : run.targets) {
    if (target.case_name == "m1_values" && target.renderer == "two") target.verdict = Verdict::Fail;
    if (target.case_name == "e1_markup") target.verdict = Verdict::Pass;
  }
  add_case(run, "g9_gone");
  // Rendered elsewhere, as after a resume on another machine.
  for (auto& job : run.jobs)
    if (job.identity.renderer == "three") job.cost.host.cpu = "another processor";
  for (auto& job : run.jobs)
    if (job.identity.renderer == "two") job.cost.wall_seconds *= 2;
  for (auto& job : run.jobs) job.identity.spp = 32;
  write_run(std::move(run), folder);
}

void write_run_of_many_cells(const fs::path& folder) {
  constexpr int kImages = 1000;
  constexpr int kRenderers = 10;
  std::vector<std::string> names;
  for (int r = 0; r < kRenderers; ++r) names.push_back(fmt::format("renderer{}", r));
  auto run = blank_run(names);
  for (int p = 0; p < kImages; ++p) {
    run.cases.push_back(
        case_of("alpha", fmt::format("{}{}_case{}", "gmla"[p % 4], p % 9 + 1, p), fmt::format("Case {}", p)));
    for (const auto& renderer : names) {
      const auto job = job_of(fmt::format("scene-{}", p), renderer, 0.1 + p % 17);
      // Every seventh cell fails, each row at other renderers.
      const auto hash = content_hash(job.identity.id);
      run.targets.push_back(
          target_of(run.cases.back().name, job, hash % 7 == 0 ? Verdict::Fail : Verdict::Pass));
      run.jobs.push_back(job);
    }
  }
  write_run(std::move(run), folder);
}

void write_run_of_huge_images(const fs::path& folder) {
  auto run = blank_run({"one"});
  run.cases.push_back(case_of("alpha", "m1_huge", "Huge"));
  const auto job = job_of("huge", "one", 9);
  run.jobs.push_back(job);
  auto target = target_of("m1_huge", job, Verdict::Fail);
  const auto reference = ramp(4096, 4096);
  auto result = reference;
  for (int y = 4000; y < 4010; ++y)
    for (int x = 4000; x < 4010; ++x) result.at(x, y, 2) = 2.0F;
  target.image = "one/huge/result.exr";
  target.reference_image = "references/huge.exr";
  write_exr(folder, target.image, result);
  write_exr(folder, target.reference_image, reference);
  run.targets.push_back(target);
  write_run(std::move(run), folder);
}

void play_live_run(const fs::path& folder) {
  const results::RunLock lock(folder);
  const results::WorkFolder unfinished(folder);
  auto run = blank_run({"one"});
  run.finished = false;
  run.cases.push_back(case_of("alpha", "m1_live", "Live"));
  std::vector<JobRecord> done;
  for (const char* scene : {"first", "second", "third"}) {
    done.push_back(job_of(scene, "one", 10));
    auto waiting = done.back();
    waiting.cost.started.clear();
    waiting.end.outcome = results::JobOutcome::Skipped;
    run.jobs.push_back(waiting);
    run.targets.push_back(target_of("m1_live", waiting, Verdict::Skipped));
  }
  write_run(run, folder);
  std::cout << "ready" << std::endl;
  std::string line;
  for (std::size_t i = 0; i < done.size() && std::getline(std::cin, line); ++i) {
    fs::create_directories(folder / done[i].files.folder);
    fs::remove_all(unfinished.path() / done[i].files.folder);
    if (i + 1 < done.size()) fs::create_directories(unfinished.path() / done[i + 1].files.folder);
    const auto target = target_of("m1_live", done[i], i == 0 ? Verdict::Pass : Verdict::Fail);
    write_file(folder / done[i].files.folder / "job.json", results::job_json(done[i], {target}));
    run.jobs[i] = done[i];
    run.targets[i] = target;
  }
  while (std::getline(std::cin, line)) continue;
  run.finished = true;
  write_run(run, folder);
}

}  // namespace orbs::page_tests
