// What the page reads: packed images, the overview, one image, the one-file page.
#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "image/image_io.h"
#include "image/reduced_precision.h"
#include "json/document.h"
#include "page/fixture_runs.h"
#include "report/overview.h"
#include "report/packed_image.h"
#include "report/page_file.h"
#include "report/progress.h"
#include "report/target_data.h"
#include "structure/source_files.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>
#include <zlib.h>

using namespace orbs;

namespace {

std::string unzipped(const std::string& bytes) {
  std::string out(1U << 20U, '\0');
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  std::string in = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  inflateEnd(&stream);
  return out;
}

// The values of a plane whose bytes were separated.
std::string joined(const std::string& bytes, std::size_t size) {
  std::string out(bytes.size(), '\0');
  unsigned byte = 0;
  std::size_t from = 0;
  for (std::size_t place = size; place-- > 0;)
    for (std::size_t at = place; at < out.size(); at += size)
      out[at] = static_cast<char>(byte = (byte + static_cast<unsigned char>(bytes[from++])) & 255U);
  return out;
}

image::Image target_with(std::vector<std::string> channels, const std::vector<float>& pixels) {
  auto target = image::make_image(2, 1, std::move(channels));
  target.pixels = pixels;
  return target;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST(PackedImage, KeepsEveryNumberAsHalfOnlyWhereNothingIsLost) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  // R: halves, among them NaN and infinity; G: a third is no half; B: beyond the largest half.
  const auto target = target_with({"R", "G", "B"}, {0.5F, 1.0F / 3, 70000.0F, nan, 0.25F, INFINITY});
  for (const auto packing : {report::Packing::Fast, report::Packing::Small}) {
    const auto bytes = unzipped(report::packed_image(target, "", report::Rounding::Exact, packing));
    EXPECT_TRUE(holds(bytes, R"("name": "R",
      "type": "half")"));
    EXPECT_TRUE(holds(bytes, R"("name": "G",
      "type": "float")"));
    const bool is_small = packing == report::Packing::Small;
    EXPECT_TRUE(holds(bytes, is_small ? R"("separated": true)" : R"("separated": false)"));
    std::string planes;
    std::size_t at = bytes.size() - 2 * 2 - 2 * 4 - 2 * 4;
    for (const std::size_t size : {2, 4, 4}) {
      const auto plane = bytes.substr(at, 2 * size);
      planes += is_small ? joined(plane, size) : plane;
      at += 2 * size;
    }
    std::uint16_t half = 0;
    std::memcpy(&half, planes.data(), sizeof(half));
    EXPECT_EQ(image::float_of_half(half), 0.5F);
    std::memcpy(&half, planes.data() + 2, sizeof(half));
    EXPECT_TRUE(std::isnan(image::float_of_half(half)));
    std::array<float, 4> floats{};
    std::memcpy(floats.data(), planes.data() + 4, sizeof(floats));
    EXPECT_EQ(floats[0], 1.0F / 3);
    EXPECT_EQ(floats[2], 70000.0F);
    EXPECT_EQ(floats[3], INFINITY);
  }
}

TEST(PackedImage, RoundingIsSaidAndNeverOverflows) {
  const auto target = target_with({"R", "G", "B"}, {1.0F / 3, 70000.0F, 0, 0, 0, 0});
  const auto bytes =
      unzipped(report::packed_image(target, "", report::Rounding::Rounded, report::Packing::Fast));
  EXPECT_TRUE(holds(bytes, R"("type": "half",
      "exact": false)"));
  EXPECT_TRUE(holds(bytes, R"("type": "float",
      "exact": true)"));
}

TEST(PackedImage, HasOneLayerAndNamesAll) {
  const auto target = target_with({"R", "S1.R", "S1.G", "path.ESDL.R"}, std::vector<float>(8, 1));
  EXPECT_EQ(report::layers_of(target), (std::vector<std::string>{"", "S1", "path.ESDL"}));
  EXPECT_TRUE(holds(
      unzipped(report::packed_image(target, "path.ESDL", report::Rounding::Exact, report::Packing::Fast)),
      R"("layers": ["", "S1", "path.ESDL"])"));
  EXPECT_THROW(report::packed_image(target, "S2", report::Rounding::Exact, report::Packing::Fast),
               InputError);
}

TEST(PackedImage, PixelsStartAtAMultipleOfEight) {
  for (const char* layer : {"", "a", "ab", "abc", "abcd", "abcde", "abcdef", "abcdefg"}) {
    const auto channel = *layer == '\0' ? "R" : std::string(layer) + ".R";
    const auto bytes = unzipped(report::packed_image(target_with({channel}, {1, 2}), layer,
                                                     report::Rounding::Exact, report::Packing::Fast));
    EXPECT_EQ((bytes.size() - 4) % 8, 0U) << layer;
  }
}

// A page on a slow line shows it first.
TEST(Preview, IsASmallPngOfTheDisplayedImage) {
  const structure::TestFolder scratch("preview");
  auto large = image::make_image(600, 300, {"R", "G", "B", "S1.R"});
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 600; ++x) large.at(x, y, 1) = x < 300 ? 1.0F : 4.0F;
  const auto png = report::preview_png(large);
  scratch.write("preview.png", png);
  const auto read = image::read_image(scratch.path() / "preview.png");
  EXPECT_EQ(read.width, 200);
  EXPECT_EQ(read.height, 100);
  EXPECT_FLOAT_EQ(read.at(20, 20, 0), 0.0F);
  EXPECT_FLOAT_EQ(read.at(20, 20, 1), 1.0F);
  EXPECT_FLOAT_EQ(read.at(180, 20, 1), 1.0F);
  EXPECT_THROW(report::preview_png(image::make_image(4, 4, {"Y"})), InputError);
  auto odd = image::make_image(513, 2, {"R", "G", "B"});
  odd.at(512, 0, 0) = 1;
  odd.at(512, 1, 0) = 1;
  scratch.write("odd.png", report::preview_png(odd));
  const auto edge = image::read_image(scratch.path() / "odd.png");
  EXPECT_EQ(edge.width, 171);
  EXPECT_NEAR(edge.at(170, 0, 0), 1.0F / 3, 0.01F) << "columns 510 to 512";
}

TEST(Base64, IsThatOfRfc4648) {
  EXPECT_EQ(report::base64(""), "");
  EXPECT_EQ(report::base64("f"), "Zg==");
  EXPECT_EQ(report::base64("fo"), "Zm8=");
  EXPECT_EQ(report::base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(report::base64("\xff\xfe"), "//4=");
}

TEST(ShellText, IsReadBackByAShell) {
  EXPECT_EQ(shell_text({"orbs", "run", "a b", "it's", "", "$(x)"}), "orbs run 'a b' 'it'\\''s' '' '$(x)'");
}

// Every image also has conditions on edge_blur and the means, whose names come before that of the gate.
TEST(PageData, ShowsTheMetricOfTheGatesFirst) {
  results::TargetRecord target;
  for (const char* name : {"edge_blur", "psnr_srgb8"}) {
    results::Measure measure;
    measure.name = name;
    measure.value = 1;
    target.measures.push_back(measure);
  }
  target.checks = {{"pixel [0,0,1,1]", true, "", {}, {}},
                   {"psnr_srgb8", true, "", 35, {}},
                   {"edge_blur", true, "", {}, 0.2}};
  results::RunView view;
  view.run.targets = {target, target};
  EXPECT_TRUE(holds(report::overview_json(view), R"("main_metric": "psnr_srgb8")"));
}

// "pass, 34.6 dB" looked like a mistake where at least 35 dB are needed.
// One number under one name: that of the image, with the one that it passes by beside it.
TEST(PageData, ShowsThePsnrOfTheImageAndWhatItPassesByBesideIt) {
  results::TargetRecord target;
  for (const auto& [name, value] :
       {std::pair{"psnr_srgb8", 34.6}, std::pair{"psnr_without_noise", 40.5}, std::pair{"ssim", 0.9}}) {
    results::Measure measure;
    measure.name = name;
    measure.value = value;
    target.measures.push_back(measure);
  }
  results::Check gate;
  gate.what = "psnr_srgb8";
  gate.min = 35;
  gate.passed = true;
  target.checks = {gate};
  results::RunView view;
  view.run.targets = {target};
  const auto text = report::overview_json(view);
  EXPECT_TRUE(holds(text, R"("psnr_srgb8": [34.6])")) << text;
  EXPECT_TRUE(holds(text, R"("texts_beside_psnr": ["", "40.5 dB without noise"])")) << text;
  EXPECT_TRUE(holds(text, R"("ssim": [0.9])")) << text;
}

// A render that a difference looks at, too, took its time once.
TEST(PageData, CountsEachRenderOnce) {
  results::JobRecord job;
  job.identity.id = "full";
  job.identity.renderer = "r";
  job.cost.wall_seconds = 3;
  job.cost.cpu_seconds = 5;
  job.cost.peak_rss_bytes = 700;
  auto other = job;
  other.identity.id = "direct";
  other.cost.peak_rss_bytes = 900;
  results::TargetRecord target;
  target.renderer = "r";
  target.jobs = {"full"};
  auto difference = target;
  difference.jobs = {"full", "direct"};
  results::RunView view;
  view.run.jobs = {job, other};
  view.run.targets = {target, difference};
  const auto text = report::overview_json(view);
  for (const char* cost : {R"("wall_seconds": 6)", R"("cpu_seconds": 10)", R"("peak_rss_bytes": 900)"})
    EXPECT_TRUE(holds(text, cost)) << text;
}

TEST(PageData, SaysWhatThePageShowsInColumns) {
  const structure::TestFolder scratch("page-data");
  page_tests::write_small_run(scratch.path());
  const auto view = results::read_run_folder(scratch.path());
  const auto text = report::overview_json(view);
  EXPECT_NO_THROW(json::parse("overview.json", text));
  EXPECT_TRUE(holds(text, R"("main_metric": "psnr_srgb8")"));
  EXPECT_TRUE(holds(text, R"("suite": "beta")"));
  EXPECT_TRUE(holds(text, "\"l1\": [0.02, 0.04,")) << text;
  EXPECT_TRUE(holds(text, R"("machines": ["a processor, 2 cores"])"));
  EXPECT_TRUE(holds(text, "\"machine\": [0, 0,"));
  EXPECT_EQ(text.size(), report::overview_json(view).size());
  const auto target = report::target_json(view, 0);
  EXPECT_NO_THROW(json::parse("image.json", target));
  EXPECT_TRUE(holds(target, R"("name": "wobble")"));
  EXPECT_TRUE(holds(target, R"("min": 35)"));
  EXPECT_TRUE(holds(target, "--case m1_values --scene values --renderer one --seed 1 --spp-scale 0.5"))
      << target;
}

// Also those that no section of the page lays out: it lists all members of the record.
TEST(PageData, HoldsEveryMemberOfTheRecordOfARender) {
  results::RunView view;
  view.run.folder = "/nowhere";
  results::JobRecord job;
  job.identity.id = "i";
  job.hashes.judged = "0123";
  job.end.core_dumped = true;
  view.run.jobs = {job};
  view.run.targets.resize(1);
  view.run.targets[0].jobs = {"i"};
  const auto text = report::target_json(view, 0);
  for (const char* member : {R"("judged": "0123")", R"("core_dumped": true)", R"("outcome": "skipped")"})
    EXPECT_TRUE(holds(text, member)) << text;
}

// The commands that the page shows: `orbs run --accept-failures` writes an entry for no other target.
TEST(PageData, NamesTheCommandsThatAcceptAFailureAndItsReference) {
  using results::Expectation;
  using results::Verdict;
  results::RunView view;
  view.run.suite = "s";
  view.run.size = "1/4";
  auto& target = view.run.targets.emplace_back();
  target.case_name = "m1_grey";
  target.target = "grey";
  target.renderer = "r";
  target.declared = true;
  const auto detail = [&](Verdict verdict, Expectation expectation = Expectation::None) {
    target.verdict = verdict;
    target.expectation = expectation;
    return report::target_detail(view, 0);
  };
  EXPECT_EQ(detail(Verdict::Fail).accept_command,
            "orbs run --suite s --case m1_grey --scene grey --renderer r --size 1/4 --accept-failures");
  EXPECT_NE(detail(Verdict::Crash, Expectation::News).accept_command, "");
  EXPECT_EQ(detail(Verdict::Fail, Expectation::Known).accept_command, "");
  EXPECT_EQ(detail(Verdict::Pass).accept_command, "");
  EXPECT_EQ(detail(Verdict::PassWithRemarks).accept_command, "");
  EXPECT_EQ(detail(Verdict::MissingReference).accept_command, "");
  EXPECT_EQ(detail(Verdict::MissingReference).reference_command,
            "orbs reference --suite s --case m1_grey --scene grey");
  EXPECT_EQ(detail(Verdict::Fail).reference_command,
            "orbs reference --suite s --case m1_grey --scene grey --accept");
  view.run.strict = true;
  EXPECT_NE(detail(Verdict::PassWithRemarks).accept_command, "");
  target.declared = false;
  EXPECT_EQ(detail(Verdict::Fail).accept_command, "");
}

// A run that goes on, with one render that has been looked at twice.
TEST(PageData, AVerdictIsPreliminaryWhileItsRenderGoesOn) {
  results::RunView view;
  view.run.folder = "/nowhere";
  view.is_live = true;
  view.states = {results::JobState::Running};
  auto& job = view.run.jobs.emplace_back();
  job.identity.id = "i";
  job.identity.renderer = "r";
  job.identity.scene = "101";
  job.identity.spp = 32;
  job.cost.started = "2026-01-01T00:00:00";
  job.end.outcome = results::JobOutcome::Image;
  job.sampling = {.looks = 2, .most_looks = 9, .end = ""};
  auto& target = view.run.targets.emplace_back();
  target.jobs = {"i"};
  target.verdict = results::Verdict::Inconclusive;
  target.looks = {{.spp = 16, .verdict = results::Verdict::Inconclusive, .gate = "edge_blur", .value = 0.25},
                  {.spp = 32, .verdict = results::Verdict::Inconclusive, .gate = "mean_ratio_g"}};
  auto text = report::overview_json(view);
  const std::string inconclusive = R"("state": [4])";
  EXPECT_TRUE(holds(text, inconclusive)) << text;
  EXPECT_TRUE(holds(text, R"("preliminary": [1])")) << text;
  EXPECT_TRUE(holds(text, R"("spp": [32])")) << text;
  EXPECT_TRUE(holds(report::progress_json(view), R"x("running": ["r 101 (32 samples so far)"])x"));
  const auto detail = report::target_json(view, 0);
  EXPECT_TRUE(holds(detail, R"("gate": "edge_blur")")) << detail;
  EXPECT_TRUE(holds(detail, R"("most_looks": 9)")) << detail;
  view.run.jobs[0].sampling.end = "decided";
  view.states = {results::JobState::Done};
  text = report::overview_json(view);
  EXPECT_TRUE(holds(text, inconclusive)) << text;
  EXPECT_TRUE(holds(text, R"("preliminary": [0])")) << text;
}

TEST(PageData, WhatWaitsHasNoReasonYet) {
  results::RunView view;
  view.run.folder = "/nowhere";
  view.is_live = true;
  view.states = {results::JobState::Waiting};
  view.run.jobs.emplace_back().identity.id = "i";
  auto& target = view.run.targets.emplace_back();
  target.jobs = {"i"};
  target.verdict = results::Verdict::Skipped;
  target.reason = "the run ended before its turn";
  EXPECT_EQ(report::overview_of(view).reasons, std::vector<std::string>{""});
  view.is_live = false;
  EXPECT_EQ(report::overview_of(view).reasons, std::vector<std::string>{target.reason});
}

// The image that shows a diagnosis stands between the reference and the maps.
TEST(PageData, TheProofOfADiagnosisIsAnImageOfTheTarget) {
  results::RunView view;
  view.run.folder = "/nowhere";
  auto& target = view.run.targets.emplace_back();
  target.image = "r/101/result.exr";
  EXPECT_EQ(report::target_detail(view, 0).images.size(), 1U);
  target.proof = {"r/101/fault-undone.exr", true};
  const auto images = report::target_detail(view, 0).images;
  ASSERT_EQ(images.size(), 2U);
  EXPECT_EQ(images[1].kind, "proof");
  EXPECT_EQ(images[1].name, "fault undone");
}

// Somebody else's results.json may name any file of this machine.
TEST(PageData, NamesOfFilesOutsideTheRunLeadNowhere) {
  const structure::TestFolder scratch("page-outside");
  scratch.write("secret.txt", "secret");
  scratch.write("web/single.html", "<!--orbs-data-->");
  scratch.write("run/x", "");
  for (const auto& name : {(scratch.path() / "secret.txt").string(), std::string("../secret.txt")}) {
    results::RunView view;
    view.run.folder = (scratch.path() / "run").string();
    view.run.jobs.resize(1);
    view.run.jobs[0].files.log = name;
    view.run.targets.resize(1);
    view.run.targets[0].jobs = {""};
    view.run.targets[0].image = name;
    EXPECT_FALSE(holds(report::target_json(view, 0), "\"log\": \"secret")) << name;
    const auto page = report::page_file(view, {scratch.path() / "web", 1000, true});
    EXPECT_EQ(page.images, 0U) << name;
    EXPECT_EQ(page.left_out.size(), 1U) << name;
  }
}

TEST(PageFile, HoldsNoMarkupOfTheRunAndKeepsToItsSize) {
  const structure::TestFolder scratch("page-file");
  page_tests::write_small_run(scratch.path() / "run");
  scratch.write("web/single.html", "before<!--orbs-data-->after");
  const auto view = results::read_run_folder(scratch.path() / "run");
  const auto all = report::page_file(view, {scratch.path() / "web", 1'000'000, true});
  EXPECT_EQ(all.text.substr(0, 6), "before");
  EXPECT_TRUE(all.left_out.empty());
  EXPECT_FALSE(holds(all.text, "<img")) << "text of the run stands there as markup";
  EXPECT_EQ(all.images, 8U);
  const auto none = report::page_file(view, {scratch.path() / "web", 0, true});
  EXPECT_EQ(none.images, 0U);
  EXPECT_EQ(none.left_out.size(), 8U);
  // What failed comes first.
  EXPECT_EQ(none.left_out.front(), "one/values/result.exr");
  EXPECT_THROW(report::page_file(view, {scratch.path() / "nowhere", 0, true}), InputError);
}

// What two kinds of machine took together is the time of neither.
TEST(PageData, ADifferenceOfRendersOnTwoMachinesHasNone) {
  results::RunView view;
  view.run.folder = "/nowhere";
  results::TargetRecord difference;
  for (const char* cpu : {"a", "b"}) {
    results::JobRecord job;
    job.identity.id = cpu;
    job.cost.started = "2026-01-01T00:00:00";
    job.cost.host.cpu = cpu;
    view.run.jobs.push_back(job);
    view.states.push_back(results::JobState::Done);
    difference.jobs.emplace_back(cpu);
  }
  view.run.targets = {difference};
  EXPECT_TRUE(holds(report::overview_json(view), "\"machine\": [null]"));
  view.run.jobs[1].cost.host.cpu = "a";
  EXPECT_TRUE(holds(report::overview_json(view), "\"machine\": [0]"));
}
