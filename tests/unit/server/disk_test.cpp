// The server shows what is on the disk, and nothing outside the folder that it was started for.
#include "base/files.h"
#include "image/image_io.h"
#include "page/fixture_runs.h"
#include "results/record.h"
#include "structure/source_files.h"
#include "unit/server/client.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace fs = std::filesystem;
using namespace orbs;
using namespace orbs::server_tests;

namespace {

// Asks until the answer holds the text; the server looks at the folder a few times each second.
bool comes_to_say(const RunningServer& server, const std::string& target, const std::string& text) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (std::chrono::steady_clock::now() < deadline) {
    if (server.get(target).find(text) != std::string::npos) return true;
    std::this_thread::yield();
  }
  return false;
}

void write_grey(const fs::path& file, float grey) {
  auto image = image::make_image(16, 16, {"R", "G", "B"});
  std::fill(image.pixels.begin(), image.pixels.end(), grey);
  image::write_exr(image, file);
}

}  // namespace

TEST(ServerDisk, ShowsTheResultsOfAFinishedRunThatWasResumed) {
  const structure::TestFolder scratch("server-resumed");
  results::RunRecord record;
  record.suite = "before";
  scratch.write("results.json", results::run_json(record));
  const RunningServer server(scratch.path());
  EXPECT_NE(server.get("/data/0/overview.json").find("before"), std::string::npos);
  record.suite = "after_";
  write_file(scratch.path() / "results.json", results::run_json(record));
  EXPECT_TRUE(comes_to_say(server, "/data/0/overview.json", "after_"));
}

TEST(ServerDisk, ShowsAnImageThatWasReplacedByOneOfTheSameSize) {
  const structure::TestFolder scratch("server-replaced");
  scratch.write("results.json", results::run_json({}));
  const auto file = scratch.path() / "result.exr";
  write_grey(file, 0.25F);
  const auto size = fs::file_size(file);
  const RunningServer server(scratch.path());
  const auto before = server.get("/data/0/image/result.exr");
  EXPECT_EQ(status_of(before), 200);
  EXPECT_EQ(server.get("/data/0/image/result.exr"), before);
  write_grey(file, -0.25F);  // as compressible as the other one
  ASSERT_EQ(fs::file_size(file), size);
  EXPECT_NE(body_of(server.get("/data/0/image/result.exr")), body_of(before));
}

TEST(ServerDisk, AFolderThatIsReplacedByALinkLeadsNowhereElse) {
  const structure::TestFolder scratch("server-moved");
  scratch.write("run/results.json", results::run_json({}));
  scratch.write("run/own.txt", "of the run");
  results::RunRecord other;
  other.suite = "secret";
  scratch.write("elsewhere/results.json", results::run_json(other));
  scratch.write("elsewhere/own.txt", "secret");
  scratch.write("elsewhere/more.txt", "secret");
  const RunningServer server(scratch.path() / "run");
  fs::rename(scratch.path() / "run", scratch.path() / "moved");
  fs::create_directory_symlink(scratch.path() / "elsewhere", scratch.path() / "run");
  EXPECT_EQ(body_of(server.get("/data/0/file/own.txt")), "of the run");
  EXPECT_EQ(status_of(server.get("/data/0/file/more.txt")), 404);
  results::RunRecord moved;
  moved.suite = "moved_run";
  scratch.write("moved/results.json", results::run_json(moved));
  EXPECT_TRUE(comes_to_say(server, "/data/0/overview.json", "moved_run"));
  EXPECT_NE(server.get("/data/0/overview.json").find("\"name\": \"run\""), std::string::npos);
}
