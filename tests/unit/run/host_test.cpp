#include "run/host.h"

#include "structure/source_files.h"

#include <gtest/gtest.h>

using orbs::results::Host;
using orbs::results::timing_machine;
using orbs::run::this_host;
using orbs::structure::TestFolder;

namespace {

Host known_host() {
  Host host;
  host.name = "a";
  host.cpu = "Processor 9000";
  host.cores = 8;
  host.governor = "performance";
  host.memory_bytes = std::size_t{1} << 34;
  host.system = "Linux 6.1 x86_64";
  host.distribution = "Debian 12";
  host.compiler = "g++ 12, optimised";
  return host;
}

}  // namespace

TEST(TimingMachine, NamesWhatTimesDependOn) {
  auto host = known_host();
  EXPECT_EQ(timing_machine(host), "Processor 9000, 8 cores, governor performance, Debian 12");
  host.cpu_limit_cores = 1.5;
  EXPECT_EQ(timing_machine(host),
            "Processor 9000, 8 cores, governor performance, container limited to 1.5 cores, Debian 12");
}

TEST(TimingMachine, IsAnotherOneWhenAnythingDiffersThatMakesItFasterOrSlower) {
  const auto differs = [](auto change) {
    auto host = known_host();
    change(host);
    return timing_machine(host) != timing_machine(known_host());
  };
  EXPECT_TRUE(differs([](Host& host) { host.cpu = "Processor 9001"; }));
  EXPECT_TRUE(differs([](Host& host) { host.cores = 4; }));
  EXPECT_TRUE(differs([](Host& host) { host.governor = "powersave"; }));
  EXPECT_TRUE(differs([](Host& host) { host.governor = ""; }));
  EXPECT_TRUE(differs([](Host& host) { host.cpu_limit_cores = 2; }));
  EXPECT_TRUE(differs([](Host& host) { host.distribution = "Debian 13"; }));
  // Nodes of one cluster, and two builds on one machine.
  EXPECT_FALSE(differs([](Host& host) { host.name = "b"; }));
  EXPECT_FALSE(differs([](Host& host) { host.memory_bytes *= 2; }));
  EXPECT_FALSE(differs([](Host& host) { host.compiler = "clang 14, optimised"; }));
}

TEST(TimingMachine, OfAnUnknownProcessorIsUnknown) { EXPECT_EQ(timing_machine(Host{}), ""); }

TEST(ThisHost, IsReadFromTheFilesOfTheKernel) {
  const TestFolder root("host");
  root.write("proc/cpuinfo", "processor\t: 0\nmodel name\t: Processor 9000 @ 3.10GHz\n");
  root.write("proc/meminfo", "MemTotal:       24684084 kB\nMemFree:         1 kB\n");
  root.write("etc/os-release", "ID=debian\nPRETTY_NAME=\"Debian GNU/Linux 12 (bookworm)\"\n");
  root.write("sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "powersave\n");
  root.write("sys/devices/system/cpu/cpu1/cpufreq/scaling_governor", "performance\n");
  const auto host = this_host(root.path());
  EXPECT_EQ(host.cpu, "Processor 9000 @ 3.10GHz");
  EXPECT_EQ(host.memory_bytes, std::size_t{24684084} * 1024);
  EXPECT_EQ(host.distribution, "Debian GNU/Linux 12 (bookworm)");
  EXPECT_EQ(host.governor, "performance and powersave");
  EXPECT_GT(host.cores, 0);
  EXPECT_FALSE(host.system.empty());
  EXPECT_FALSE(host.compiler.empty());
  EXPECT_FALSE(host.cpu_limit_cores || host.memory_limit_bytes);
}

// The smallest limit of all groups that we are in is the one that counts.
TEST(ThisHost, KnowsTheLimitsOfItsContainer) {
  const TestFolder root("host-limits");
  root.write("proc/self/cgroup", "0::/pod/ours\n");
  root.write("sys/fs/cgroup/pod/ours/cpu.max", "max 100000\n");
  root.write("sys/fs/cgroup/pod/cpu.max", "150000 100000\n");
  root.write("sys/fs/cgroup/cpu.max", "400000 100000\n");
  root.write("sys/fs/cgroup/pod/ours/memory.max", "1073741824\n");
  root.write("sys/fs/cgroup/pod/memory.max", "max\n");
  const auto host = this_host(root.path());
  EXPECT_EQ(host.cpu_limit_cores, 1.5);
  EXPECT_EQ(host.memory_limit_bytes, std::size_t{1} << 30);
}

TEST(ThisHost, ReadsTheOlderControlGroupsToo) {
  const TestFolder root("host-limits-1");
  root.write("proc/meminfo", "MemTotal: 2097152 kB\n");
  root.write("proc/self/cgroup", "4:memory:/ours\n2:cpu,cpuacct:/ours\n0::/\n");
  root.write("sys/fs/cgroup/cpu/ours/cpu.cfs_quota_us", "50000\n");
  root.write("sys/fs/cgroup/cpu/ours/cpu.cfs_period_us", "100000\n");
  root.write("sys/fs/cgroup/cpu/cpu.cfs_quota_us", "-1\n");
  root.write("sys/fs/cgroup/cpu/cpu.cfs_period_us", "100000\n");
  root.write("sys/fs/cgroup/memory/ours/memory.limit_in_bytes", "9223372036854771712\n");  // none
  const auto host = this_host(root.path());
  EXPECT_EQ(host.cpu_limit_cores, 0.5);
  EXPECT_FALSE(host.memory_limit_bytes);
}

TEST(ThisHost, SaysNothingWhereTheSystemDoesNot) {
  const TestFolder root("host-nothing");
  const auto host = this_host(root.path());
  EXPECT_EQ(host.cpu, "");
  EXPECT_EQ(host.memory_bytes, 0U);
  EXPECT_EQ(timing_machine(host), "");
}
