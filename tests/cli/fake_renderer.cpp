// A renderer that fails on demand: what the harness is tested against. It reads no scene; its image is grey
// all over, or what --mode makes of it.
#include "base/error.h"
#include "image/image_io.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using orbs::image::Image;

using Arguments = std::map<std::string, std::string>;

Arguments parse(int argc, char** argv) {
  Arguments arguments;
  int images = 0;
  for (int i = 1; i + 1 < argc; i += 2) {
    arguments[argv[i]] = argv[i + 1];
    images += std::string(argv[i]) == "--image" ? 1 : 0;
  }
  arguments["--images"] = std::to_string(images);
  return arguments;
}

Image grey_image(const Arguments& arguments) {
  auto image = orbs::image::make_image(std::stoi(arguments.at("--width")),
                                       std::stoi(arguments.at("--height")), {"R", "G", "B"});
  for (auto& value : image.pixels) value = std::stof(arguments.at("--grey"));
  return image;
}

// As many samples as --spp says, each of them off by 0.2 up or down.
void add_noise(const Arguments& arguments, Image& image) {
  std::mt19937 random(static_cast<unsigned>(std::stoi(arguments.at("--seed"))));
  const int samples = std::stoi(arguments.at("--spp"));
  for (auto& value : image.pixels) {
    const auto up = std::binomial_distribution<int>(samples, 0.5)(random);
    value += 0.2F * static_cast<float>(2 * up - samples) / static_cast<float>(samples);
  }
}

// Waits for a signal, far beyond any time limit of the tests.
void hang() { std::this_thread::sleep_for(std::chrono::minutes(10)); }

// A child of its own, which must not outlive the run; its id is left in "child.txt".
void hang_with_child() {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGTERM, SIG_IGN);
    hang();
  }
  std::ofstream("child.txt") << child;
  std::signal(SIGTERM, SIG_IGN);
  hang();
}

// One that has left for a session of its own, as a daemon would.
void leave_child_in_own_session(void (*behave)()) {
  std::array<int, 2> ready{};  // the child has left its id, before we may end and it is ended with us
  if (::pipe(ready.data()) != 0) ::_exit(1);
  const pid_t child = ::fork();
  if (child == 0) {
    ::setsid();
    if (::fork() == 0) {
      std::ofstream("child.txt") << ::getpid() << '\n';
      if (::write(ready[1], "!", 1) != 1) ::_exit(1);
      behave();
    }
    char byte = 0;
    ::_exit(::read(ready[0], &byte, 1) == 1 ? 0 : 1);
  }
  ::waitpid(child, nullptr, 0);
}

// The kernel shows the process as a zombie from then on, although the thread goes on.
[[noreturn]] void end_main_thread(void (*in_another_thread)()) {
  std::thread(in_another_thread).detach();
  ::syscall(SYS_exit, 0);
  std::abort();
}

char state_of(pid_t pid) {
  std::ifstream stat(fmt::format("/proc/{}/stat", pid));
  std::string text;
  std::getline(stat, text);
  return text.empty() ? ' ' : text.at(text.rfind(')') + 2);
}

// A daemon that looks like a zombie when we end.
void leave_daemon_without_main_thread() {
  leave_child_in_own_session([] { end_main_thread(hang); });
  pid_t daemon = 0;
  while (!(std::ifstream("child.txt") >> daemon) || state_of(daemon) != 'Z') std::this_thread::yield();
}

void print_much() {
  for (int line = 0; line < 200000; ++line) fmt::print("line {} of much too much output\n", line);
}

// Bounded, should nobody stop it.
void leak_memory() {
  constexpr std::size_t kPart = 16 << 20;
  std::vector<std::string> parts;
  for (int part = 0; part < 64; ++part) parts.emplace_back(kPart, 'x');
  hang();
}

// Memory that no process has mapped.
void leak_to_memfd() {
  const std::string part(16 << 20, 'x');
  const int file = ::memfd_create("fake", 0);
  for (int written = 0; written < 32; ++written)
    if (::write(file, part.data(), part.size()) < 0) std::abort();
  hang();
}

int wait_a_while(void*) {
  std::this_thread::sleep_for(std::chrono::milliseconds(800));
  return 0;
}

// Each page is there once: a child has the same memory, as between vfork and exec, then others share it, as
// after fork. Long enough for the supervisor to look at both.
void share_pages() {
  const std::string pages(150 << 20, 'x');
  std::vector<char> stack(1 << 20);
  const pid_t same =
      ::clone(wait_a_while, stack.data() + stack.size(), CLONE_VM | CLONE_VFORK | SIGCHLD, nullptr);
  ::waitpid(same, nullptr, 0);
  for (int child = 0; child < 4; ++child)
    if (::fork() == 0) hang();
  wait_a_while(nullptr);
  if (pages.back() != 'x') std::abort();
}

void burn_processor_time() {
  while (std::clock() < 60 * CLOCKS_PER_SEC) {
  }
}

void work_for(double seconds) {
  const auto end = std::clock() + static_cast<std::clock_t>(seconds * CLOCKS_PER_SEC);
  while (std::clock() < end) {
  }
}

// A start of 0.05 s, and as many images as there is "--image", with 0.02 s for each sample of a pixel. Those
// of few pixels take no time. No seed: each image has the random numbers that follow those of the one before.
void render_sequence(Arguments arguments, const Image& grey, const std::string& output) {
  const int images = std::stoi(arguments.at("--images"));
  constexpr std::size_t kFewPixels = 4 * 4 * 3;
  work_for(0.05);
  for (int number = 1; number <= images; ++number) {
    if (grey.pixels.size() > kFewPixels) work_for(0.02 * std::stoi(arguments.at("--spp")));
    auto image = grey;
    arguments["--seed"] = std::to_string(number);
    add_noise(arguments, image);
    orbs::image::write_exr(image, images == 1 ? output : output.substr(0, output.size() - 4) + "_last.exr");
  }
}

void fill_disk(int files, std::size_t bytes_each) {
  for (int file = 0; file < files; ++file)
    std::ofstream(fmt::format("junk-{}", file)) << std::string(bytes_each, 'x');
}

// To our parent's parent: the harness, which talks to us through its supervisor.
void interrupt_harness() {
  std::ifstream stat(fmt::format("/proc/{}/stat", ::getppid()));
  std::string text;
  std::getline(stat, text);
  ::kill(std::stoi(text.substr(text.rfind(')') + 4)), SIGINT);
}

void write_half(const Image& image, const std::string& output) {
  orbs::image::write_exr(image, output);
  std::filesystem::resize_file(output, std::filesystem::file_size(output) / 2);
}

void write_elsewhere(const Image& image, const std::string& output) {
  const auto outside = std::filesystem::path(output).parent_path() / ".." / "outside.exr";
  orbs::image::write_exr(image, outside);
  std::filesystem::create_symlink(outside, output);
}

void write_old(const Image& image, const std::string& output) {
  orbs::image::write_exr(image, output);
  std::filesystem::last_write_time(output, std::filesystem::last_write_time(output) - std::chrono::hours(1));
}

// Folders under names that orbs is going to write itself; `output` is no such name.
void litter(const std::string& output) {
  for (const char* name : {"job.json", "result.png", "error-l1.exr", "log.txt", "result.exr"}) {
    if (std::filesystem::path(output).filename() == name) continue;
    std::filesystem::remove_all(name);
    std::filesystem::create_directories(std::filesystem::path(name) / "inside");
  }
}

// A file where the folder of the render was.
void replace_own_folder(const std::string& output) {
  const auto folder = std::filesystem::path(output).parent_path();
  std::filesystem::remove_all(folder);
  std::ofstream(folder) << "no folder";
}

// Ends the process, or returns when the mode is about the image.
void misbehave(const std::string& mode) {
  if (mode == "segfault") {
    std::signal(SIGSEGV, SIG_DFL);  // a sanitizer would make it an exit code
    std::raise(SIGSEGV);
  }
  if (mode == "abort") std::abort();
  if (mode == "exit3") {
    fmt::print(stderr, "fake: cannot find the sun\n");
    std::exit(3);
  }
  if (mode == "hang") hang();
  if (mode == "ignore-term") {
    std::signal(SIGTERM, SIG_IGN);
    hang();
  }
  if (mode == "hang-with-child") hang_with_child();
  if (mode == "leave-child") leave_child_in_own_session(hang);
  if (mode == "leak") leak_memory();
  if (mode == "leak-to-memfd") leak_to_memfd();
  if (mode == "shared-pages") share_pages();
  if (mode == "main-thread-ends") end_main_thread(hang);
  if (mode == "main-thread-ends-leak") end_main_thread(leak_memory);
  if (mode == "main-thread-ends-daemon") leave_daemon_without_main_thread();
  if (mode == "burn") burn_processor_time();
  if (mode == "fill-file") fill_disk(1, 8 << 20);
  if (mode == "fill-files") fill_disk(64, 1 << 17);
  if (mode == "interrupt") {
    interrupt_harness();
    hang();
  }
  if (mode == "much") print_much();
  if (mode == "coloured") {
    fmt::print(stderr, "loading\r\033[31mfake: \xff cannot read {}/sun.txt\n",
               std::filesystem::current_path().string());
    std::exit(3);
  }
  if (mode == "complain") fmt::print(stderr, "fake: something is odd\n");
  if (mode == "read-input")
    fmt::print("read {} characters\n", std::string(std::istreambuf_iterator(std::cin), {}).size());
  if (mode == "environment")
    for (char** entry = environ; *entry != nullptr; ++entry) fmt::print("{}\n", *entry);
}

// True when it has left what the mode wants in place of an image.
bool write_no_image(const std::string& mode, const Image& image, const std::string& output) {
  if (mode == "nothing") return true;
  if (mode == "garbage") return std::ofstream(output) << "this is no image", true;
  if (mode == "empty") return std::ofstream(output) << "", true;
  if (mode == "half") return write_half(image, output), true;
  if (mode == "elsewhere") return write_elsewhere(image, output), true;
  if (mode == "old") return write_old(image, output), true;
  if (mode == "replace-own-folder") return replace_own_folder(output), true;
  return false;
}

int behave(const std::string& mode, const Arguments& arguments) {
  const std::string output = arguments.at("--output");
  auto image = grey_image(arguments);
  misbehave(mode);
  if (mode == "sequence") return render_sequence(arguments, image, output), 0;
  if (mode.ends_with("litter")) litter(output);
  if (write_no_image(mode, image, output)) return 0;
  if (mode == "wrong-size") image = orbs::image::make_image(image.width / 2, image.height, {"R", "G", "B"});
  if (mode == "wrong-channels") image = orbs::image::make_image(image.width, image.height, {"Y"});
  if (mode.starts_with("noisy")) add_noise(arguments, image);
  if (mode == "nan" || (mode == "noisy-nan" && arguments.at("--seed") == "2"))
    image.at(3, 2, 1) = std::numeric_limits<float>::quiet_NaN();
  if (mode == "infinite") image.at(5, 1, 0) = std::numeric_limits<float>::infinity();
  if (mode == "negative") image.at(4, 3, 2) = image.at(6, 5, 0) = -0.001F;
  if (mode == "other-scene") image.attributes["orbs.scene_hash"] = "0123456789abcdef";
  if (mode == "other-job") image.attributes["orbs.job"] = "0123456789abcdef";
  if (mode == "exit3-after-image") return orbs::image::write_exr(image, output), 3;
  orbs::image::write_exr(image, output);
  fmt::print("fake: render_seconds 0.25\n");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::string(argv[1]) == "--version") {
    fmt::print("fake renderer 7.8\n");
    return 0;
  }
  const auto arguments = parse(argc, argv);
  return behave(arguments.at("--mode"), arguments);
}
