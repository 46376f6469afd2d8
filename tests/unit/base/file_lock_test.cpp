#include "base/file_lock.h"

#include "base/error.h"
#include "structure/source_files.h"

#include <chrono>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace orbs;
using structure::TestFolder;

namespace {

std::string busy(const std::string& holder) { return "held by " + holder; }

// A process takes the lock, starts another one that has the file open for so long, and is gone.
void leave_lock_to_child(const std::filesystem::path& file, std::chrono::milliseconds how_long) {
  const pid_t holder = ::fork();
  if (holder == 0) {
    const FileLock lock(file, busy);
    if (::fork() == 0) std::this_thread::sleep_for(how_long);
    ::_exit(0);
  }
  ::waitpid(holder, nullptr, 0);
}

}  // namespace

TEST(FileLock, OfALivingHolderIsRefusedAtOnce) {
  const TestFolder folder("file-lock");
  const auto file = folder.path() / "run.lock";
  const FileLock lock(file, busy);
  try {
    const FileLock other(file, busy);
    FAIL() << "two hold it";
  } catch (const InputError& e) {
    EXPECT_EQ(e.what(), "held by " + std::to_string(::getpid()));
  }
}

TEST(FileLock, OfAHolderThatIsGoneIsWaitedFor) {
  const TestFolder folder("file-lock");
  const auto file = folder.path() / "run.lock";
  leave_lock_to_child(file, std::chrono::milliseconds(200));
  EXPECT_TRUE(is_locked(file));
  EXPECT_NO_THROW(FileLock(file, busy));
}
