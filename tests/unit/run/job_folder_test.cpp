#include "run/job_folder.h"

#include "base/nth.h"
#include "structure/source_files.h"

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

using namespace orbs;
using structure::TestFolder;

namespace {

namespace fs = std::filesystem;

// Folders that renders share, one in the other: each is a chance that two threads make it at the same time.
fs::path shared_folder(int round) {
  constexpr int kDeep = 15;
  fs::path path = std::to_string(round);
  for (int i = 0; i < kDeep; ++i) path /= "shared";
  return path;
}

}  // namespace

// Renders that start together share the folder of their renderer.
TEST(JobFolder, RendersMakeTheFoldersThatTheyShareAtTheSameTime) {
  const TestFolder folder("job-folder");
  constexpr int kThreads = 2;
  constexpr int kRounds = 40;
  std::atomic<int> arrived = 0;  // no thread sleeps before it starts: they would wake up one after the other
  std::vector<std::string> failures(kThreads);
  std::vector<std::thread> threads;
  for (int thread = 0; thread < kThreads; ++thread)
    threads.emplace_back([&, thread] {
      for (int round = 0; round < kRounds; ++round) {
        const auto own = folder.path() / shared_folder(round) / std::to_string(thread);
        ++arrived;
        while (arrived < kThreads * (round + 1)) std::this_thread::yield();
        try {
          if (run::make_own_folder(folder.path(), own))
            nth(failures, thread) = "something is said to be replaced";
        } catch (const std::exception& e) {
          nth(failures, thread) = e.what();
        }
      }
    });
  for (auto& thread : threads) thread.join();
  for (const auto& failure : failures) EXPECT_EQ(failure, "");
  for (int round = 0; round < kRounds; ++round)
    for (int thread = 0; thread < kThreads; ++thread)
      ASSERT_TRUE(fs::is_directory(folder.path() / shared_folder(round) / std::to_string(thread)));
}

TEST(JobFolder, WhatIsNoFolderMakesWay) {
  const TestFolder folder("job-folder");
  const auto own = folder.path() / "renderer/scene";
  fs::create_directories(folder.path() / "elsewhere");
  EXPECT_FALSE(run::make_own_folder(folder.path(), own));
  EXPECT_FALSE(run::make_own_folder(folder.path(), own)) << "it is there";
  fs::remove_all(folder.path() / "renderer");
  fs::create_symlink(folder.path() / "elsewhere", folder.path() / "renderer");
  EXPECT_TRUE(run::make_own_folder(folder.path(), own));
  EXPECT_FALSE(fs::is_symlink(folder.path() / "renderer"));
  EXPECT_TRUE(fs::is_empty(folder.path() / "elsewhere"));
  fs::remove_all(own);
  std::ofstream(own) << "a file";
  EXPECT_TRUE(run::make_own_folder(folder.path(), own));
  EXPECT_TRUE(fs::is_directory(own));
}

// A render of root's could leave a program there that makes root of everybody.
TEST(JobFolder, FilesThatARendererLeavesGiveNobodyRightsOfItsUser) {
  const TestFolder folder("job-rights");
  folder.write("own/below/tool", "");
  folder.write("own/secret", "");
  folder.write("elsewhere", "");
  const auto mode_of = [&](const char* name) {
    struct stat status {};
    EXPECT_EQ(::stat((folder.path() / name).c_str(), &status), 0) << name;
    return status.st_mode & 07777U;
  };
  ASSERT_EQ(::chmod((folder.path() / "own/below/tool").c_str(), 06755), 0);
  ASSERT_EQ(::chmod((folder.path() / "own/secret").c_str(), 04000), 0);
  ASSERT_EQ(::chmod((folder.path() / "elsewhere").c_str(), 04755), 0);
  fs::create_symlink(folder.path() / "elsewhere", folder.path() / "own/link");
  run::make_room(folder.path(), folder.path() / "own");
  EXPECT_EQ(mode_of("own/below/tool"), 0755U);
  EXPECT_EQ(mode_of("own/secret"), 0U);
  EXPECT_EQ(mode_of("elsewhere"), 04755U) << "no link is followed";
}
