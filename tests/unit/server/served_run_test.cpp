// A run as the server holds it, whatever becomes of its folder.
#include "results/record.h"
#include "server/served.h"
#include "structure/source_files.h"

#include <thread>

#include <gtest/gtest.h>

using namespace orbs;

TEST(ServedRun, ARunWhoseFolderIsGoneIsNoLongerFollowed) {
  const structure::TestFolder scratch("served-run");
  results::RunRecord record;
  record.finished = false;
  scratch.write("results.json", results::run_json(record));
  const results::RunLock lock(scratch.path());
  server::ServedRun run(scratch.path());
  ASSERT_TRUE(run.is_live());
  const auto version = run.version();
  std::filesystem::remove_all(scratch.path());
  while (run.is_live()) std::this_thread::yield();  // it looks now and then
  EXPECT_GT(run.version(), version);
}

// Messages name the folder as the user does, and not the descriptor by which the server holds it.
TEST(ServedRun, ARecordIsOfTheFolderThatWasNamed) {
  const structure::TestFolder scratch("served-record");
  scratch.write("results.json", results::run_json(results::RunRecord{}));
  server::ServedRun run(scratch.path());
  EXPECT_EQ(run.record().folder, std::filesystem::weakly_canonical(scratch.path()).string());
}
