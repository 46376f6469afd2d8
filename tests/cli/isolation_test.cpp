// A renderer that looks for what it must not see, with --sandbox and without, as root and as another user.
#include "base/files.h"
#include "cli/sandbox.h"
#include "image/image_io.h"

#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <linux/keyctl.h>
#include <sys/ipc.h>
#include <sys/shm.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

using orbs::ScratchFolder;
using orbs::cli_tests::Answer;
using orbs::cli_tests::contains;
using orbs::cli_tests::Sandbox;

namespace {

namespace fs = std::filesystem;

// What the machine of a run holds beside the run: a file that nobody named, a System V segment, a file in
// memory. They are gone with the object.
struct Surroundings {
  ScratchFolder folder{"orbs-private"};
  int segment = ::shmget(IPC_PRIVATE, 4096, 0600);
  fs::path shared = fmt::format("/dev/shm/orbs-test-{}", ::getpid());
  // -1 where a container refuses the call.
  long key = ::syscall(SYS_add_key, "user", "orbs-test-key", "secret", 6, KEY_SPEC_SESSION_KEYRING);

  Surroundings() {
    orbs::write_file(folder.path() / "key", "secret");
    orbs::write_file(shared, "secret");
    for (const auto& path : {folder.path(), folder.path() / "key", shared}) ::chmod(path.c_str(), 0755);
  }
  ~Surroundings() {
    ::shmctl(segment, IPC_RMID, nullptr);
    if (key >= 0) ::syscall(SYS_keyctl, KEYCTL_UNLINK, key, KEY_SPEC_SESSION_KEYRING);
    std::error_code ignored;
    fs::remove(shared, ignored);
  }
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;
};

constexpr const char* kCurious = R"sh(#!/bin/sh
say() {{ echo "curious: $*"; (echo "$*" >> {0}/said) 2> /dev/null; }}
cat {0}/references/*.exr ../references/*.exr ../../references/*.exr > found 2> /dev/null
test -n "$(find found -size +1k)" && say it reads references
cat /proc/[0-9]*/root{0}/references/*.exr > found 2> /dev/null
test -n "$(find found -size +1k)" && say it reads references through other processes
python3 -c '
import ctypes, platform
keyctl = dict(x86_64=250, aarch64=219)[platform.machine()]
exit(ctypes.CDLL(None).syscall(keyctl, 10, -3, b"user", b"orbs-test-key", 0) < 0)  # KEYCTL_SEARCH in the session
' && say it sees keys of the session
test -s {0}/.git/HEAD && say it sees a repository
test -s {0}/mine/copy.exr && say it sees a copy of a reference
test -n "$(find {0} -name case.json -size +0)" && say it sees cases
test -s {0}/other-references/x.exr && say it sees references of another suite
test -s {0}/mine/tables.exr || say it lacks its own data
test -r {1}/key && say it reads what nobody named
test -r /etc/shadow && say it reads passwords
(echo x > {0}/mark) 2> /dev/null && say it writes elsewhere
for root in /proc/[0-9]*/root; do (echo x > $root{0}/mark) 2> /dev/null && say it writes through other processes; done
test -e {2} && say it sees files in memory
test "$(grep -c . /proc/sysvipc/shm)" -gt 1 && say it sees memory of others
kill -0 {3} 2> /dev/null && say it can signal others
test "$(ls -d /proc/[0-9]* | wc -l)" -gt 8 && say it sees other processes
for name in pid={4} ipc={5} uts={6} net={7} mnt={8}; do
  test "$(readlink /proc/self/ns/${{name%%=*}})" = "${{name#*=}}" && say it shares the namespace ${{name%%=*}}
done
(: >> /proc/sys/kernel/core_pattern) 2> /dev/null && say it sets the kernel
grep -q 'CapEff:.*[1-9a-f]' /proc/self/status && say it has rights of root
grep -q 'eth\|ens\|enp' /proc/net/dev && say it has a network
case "$1" in --version) echo 7;; *) exec {9}/orbs-fake-renderer "$@";; esac
)sh";

// Renders as the one that it stands for, or says its version, and says in `said` what it could do beside: on
// its output, and where the disk lets it.
void write_curious_renderer(const Sandbox& sandbox, const Surroundings& around) {
  const auto space = [](const char* name) { return fs::read_symlink(fmt::format("/proc/self/ns/{}", name)); };
  sandbox.write("curious", fmt::format(kCurious, sandbox.folder().string(), around.folder.path().string(),
                                       around.shared.string(), ::getpid(), space("pid").string(),
                                       space("ipc").string(), space("uts").string(), space("net").string(),
                                       space("mnt").string(), ORBS_BINARY_WORD));
  ::chmod((sandbox.folder() / "curious").c_str(), 0755);
  // Its folder is a repository, with copies of references under other names.
  sandbox.shell("mkdir .git mine other-references; echo ref: refs/heads/main > .git/HEAD");
  auto image = orbs::image::make_image(8, 8, {"R", "G", "B"});
  orbs::image::write_exr(image, sandbox.folder() / "mine/tables.exr");
  image.attributes["orbs.spp"] = "64";
  for (const char* file : {"mine/copy.exr", "other-references/x.exr"})
    orbs::image::write_exr(image, sandbox.folder() / file);
  // The program that the script starts lies where nobody would look for it.
  sandbox.add_to_good(R"(, "readable": ["{build}"])");
}

// Everybody may write into the sandbox's folder then.
Answer orbs_as(const Sandbox& sandbox, const std::string& user, const std::string& arguments) {
  sandbox.shell("chmod -R a+rwX . && chmod a+rx curious");
  return sandbox.shell(fmt::format("{} {}/orbs {}",
                                   user.empty() ? "" : "setpriv --reuid=65534 --regid=65534 --clear-groups",
                                   ORBS_BINARY_WORD, arguments));
}

std::string said(const Sandbox& sandbox) { return sandbox.has("said") ? sandbox.read("said") : ""; }

// As whom the test can run: root can be anybody.
std::vector<std::string> users() {
  return ::geteuid() == 0 ? std::vector<std::string>{"", "nobody"} : std::vector<std::string>{""};
}

bool refuses_namespaces(const Answer& answer) { return contains(answer.text, "bwrap says"); }

const std::string kRun = "run -r good -s grey -e ./curious -o ";

}  // namespace

TEST(Isolation, ARendererSeesNothingButWhatItNeeds) {
  for (const auto& user : users()) {
    const Surroundings around;
    const Sandbox sandbox;
    write_curious_renderer(sandbox, around);
    const auto open = orbs_as(sandbox, user, kRun + "open");
    EXPECT_EQ(open.status, 0) << open.text;
    for (const char* part :
         {"it reads references", "it reads what nobody named", "it writes elsewhere", "it sees a repository",
          "it sees a copy of a reference", "it sees cases", "it sees references of another suite",
          "it sees files in memory", "it sees other processes", "it shares the namespace pid",
          "it shares the namespace ipc", "it shares the namespace uts"})
      EXPECT_TRUE(contains(said(sandbox), part)) << part << ", without a sandbox: " << said(sandbox);

    EXPECT_TRUE(around.key < 0 || contains(said(sandbox), "it sees keys")) << said(sandbox);

    fs::remove(sandbox.folder() / "said");
    fs::remove(sandbox.folder() / "mark");
    const auto shut = orbs_as(sandbox, user, kRun + "shut --sandbox");
    if (refuses_namespaces(shut)) GTEST_SKIP() << "the kernel or container refuses namespaces: " << shut.text;
    EXPECT_EQ(shut.status, 0) << shut.text;
    EXPECT_FALSE(sandbox.has("said")) << user << ": " << said(sandbox);
    EXPECT_FALSE(sandbox.has("mark"));
    EXPECT_FALSE(contains(sandbox.read("shut/good/grey/log.txt"), "curious: "))
        << user << ": " << sandbox.read("shut/good/grey/log.txt");
  }
}

// Version commands and studies start the same programs.
TEST(Isolation, HoldsForVersionCommandsAndStudies) {
  for (const char* command :
       {"run --dry-run", "probe -r good -s grey", "stability -r good -s grey --relation rotate -o study"}) {
    const Surroundings around;
    const Sandbox sandbox;
    write_curious_renderer(sandbox, around);
    replace_in(sandbox, "configuration.json",
               R"("executable": "{build}/orbs-fake-renderer", "version_command")",
               R"("executable": "{root}/curious", "version_command")");
    const bool is_run = std::string(command).starts_with("run");
    const auto words = is_run ? kRun + "out" : std::string(command);
    const auto answer = orbs_as(sandbox, "", words + " --sandbox");
    if (refuses_namespaces(answer)) GTEST_SKIP() << answer.text;
    EXPECT_FALSE(sandbox.has("said")) << command << ": " << said(sandbox) << answer.text;
    EXPECT_FALSE(sandbox.has("mark")) << command;
    EXPECT_FALSE(sandbox.has("found")) << command << ": the version command writes where orbs was started";
    fs::remove_all(sandbox.folder() / "study");
    orbs_as(sandbox, "", is_run ? kRun + "open" : std::string(command));
    EXPECT_TRUE(sandbox.has("said")) << command << " starts it";
  }
}

// A limit of memory holds for what lies in the folders in memory that the sandbox brings.
TEST(Isolation, FoldersInMemoryAreLimited) {
  const Sandbox sandbox;
  sandbox.add_to_good(R"(, "readable": ["{build}"], "limits": {"memory_megabytes": 50})");
  orbs::cli_tests::replace_in(sandbox, "configuration.json", R"("limits": {}, )", "");
  sandbox.write("hoarder", fmt::format("#!/bin/sh\nhead -c 80M /dev/zero > /dev/shm/x || exit 7\n"
                                       "exec {}/orbs-fake-renderer \"$@\"\n",
                                       ORBS_BINARY_WORD));
  ::chmod((sandbox.folder() / "hoarder").c_str(), 0755);
  const auto answer =
      sandbox.orbs({"run", "-r", "good", "-s", "grey", "-e", "./hoarder", "--sandbox", "-o", "out"});
  if (refuses_namespaces(answer)) GTEST_SKIP() << answer.text;
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_TRUE(contains(sandbox.read("out/good/grey/log.txt"), "No space left on device")) << answer.text;
}

// All of them together, too: each holds as much as the limit allows, and what is closed is open in no
// process.
TEST(Isolation, FoldersInMemoryCountTogether) {
  const Sandbox sandbox;
  sandbox.add_to_good(R"(, "readable": ["{build}"], "limits": {"memory_megabytes": 100})");
  orbs::cli_tests::replace_in(sandbox, "configuration.json", R"("limits": {}, )", "");
  sandbox.write(
      "hoarder",
      "#!/bin/sh\nhead -c 70M /dev/zero > /dev/shm/x\nhead -c 70M /dev/zero > /tmp/x\ntail -f /dev/null\n");
  ::chmod((sandbox.folder() / "hoarder").c_str(), 0755);
  const auto answer =
      sandbox.orbs({"run", "-r", "good", "-s", "grey", "-e", "./hoarder", "--sandbox", "-o", "out"});
  if (refuses_namespaces(answer)) GTEST_SKIP() << answer.text;
  EXPECT_TRUE(contains(answer.text, "was ended because it took more than its 100 MB of memory"))
      << answer.text;
}

// With a namespace of its own, a renderer mounts folders in memory, and no limit counts what they hold.
TEST(Isolation, NoNamespacesCanBeMadeInIt) {
  const Sandbox sandbox;
  const auto outside = sandbox.shell("unshare -Ur true");
  if (outside.status != 0) GTEST_SKIP() << "none can be made here at all: " << outside.text;
  sandbox.add_to_good(R"(, "readable": ["{build}"])");
  sandbox.write("nested", fmt::format("#!/bin/sh\nunshare -Ur true && exit 7\n"
                                      "exec {}/orbs-fake-renderer \"$@\"\n",
                                      ORBS_BINARY_WORD));
  ::chmod((sandbox.folder() / "nested").c_str(), 0755);
  const auto answer =
      sandbox.orbs({"run", "-r", "good", "-s", "grey", "-e", "./nested", "--sandbox", "-o", "out"});
  if (refuses_namespaces(answer)) GTEST_SKIP() << answer.text;
  EXPECT_EQ(answer.status, 0) << answer.text << sandbox.read("out/good/grey/log.txt");
}

TEST(Isolation, LimitsEndWhatRunsInIt) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "good,hang-with-child,ignore-term,leak,burn,segfault", "-s",
                                    "grey", "-c", "m1_grey", "--sandbox", "-o", "out"});
  if (refuses_namespaces(answer)) GTEST_SKIP() << answer.text;
  for (const char* reason :
       {"was ended after its time limit of 4 s", "was ended after its time limit of 0.3 s",
        "was ended because it took more than its 200 MB of memory",
        "was ended after 0.3 s of processor time, its limit", "ended with exit code 139, as after SIGSEGV"})
    EXPECT_TRUE(contains(sandbox.read("out/results.csv"), reason)) << reason << answer.text;
}

TEST(Isolation, WithoutBubblewrapTheRunIsRefused) {
  const Sandbox sandbox;
  const Answer answer = sandbox.shell(
      fmt::format("PATH=/nowhere {}/orbs run -r good -s grey --sandbox -o out", ORBS_BINARY_WORD));
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.text.find("install bubblewrap, or run without --sandbox"), std::string::npos)
      << answer.text;
  EXPECT_FALSE(sandbox.has("out"));
}
