#include "run/machine_time.h"

#include "structure/source_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

using orbs::run::machine_time;
using orbs::run::MachineTime;
using orbs::run::share_of_others;

TEST(MachineTime, IsWhatTheKernelCounted) {
  const orbs::structure::TestFolder folder("machine-time");
  folder.write("proc/stat", "cpu  100 20 30 400 50 6 7 8 90 10\ncpu0 1 1 1\ncpu1 1 1 1\nintr 5\n");
  const auto time = machine_time(folder.path());
  ASSERT_TRUE(time);
  const double tick = 1.0 / static_cast<double>(sysconf(_SC_CLK_TCK));
  EXPECT_NEAR(time->busy_seconds, 171 * tick, 1e-9) << "guests are in user and nice already";
  EXPECT_NEAR(time->all_seconds, 621 * tick, 1e-9);
  EXPECT_NEAR(time->error_of_seconds, 2 * tick, 1e-9) << "one tick of each processor";
}

TEST(MachineTime, IsUnknownWhereTheKernelDoesNotSay) {
  const orbs::structure::TestFolder folder("machine-time");
  EXPECT_FALSE(machine_time(folder.path()));
  folder.write("proc/stat", "cpu  100 20 30\n");
  EXPECT_FALSE(machine_time(folder.path()));
}

TEST(MachineTime, OthersTakeWhatIsBusyAndNotOurs) {
  const MachineTime before{
      .busy_seconds = 10, .all_seconds = 100, .own_seconds = 1, .error_of_seconds = 0.02};
  const MachineTime after{
      .busy_seconds = 18.02, .all_seconds = 120, .own_seconds = 2, .error_of_seconds = 0.02};
  // 8.02 s are busy: 1 s ours, 5 s of the renderer, 2 s of others and 0.02 s that may be counted wrongly.
  EXPECT_NEAR(share_of_others(before, after, 5).value(), 0.1, 1e-9);
  EXPECT_EQ(share_of_others(before, after, 9), 0.0);
  EXPECT_FALSE(share_of_others(before, before, 0));
}
