// A renderer that fails on demand: what the harness is tested against. It reads no scene; its picture is grey
// all over, or what --mode makes of it.
#include "base/error.h"
#include "image/image_io.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

namespace {

using orbs::image::Image;

using Arguments = std::map<std::string, std::string>;

Arguments parse(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i + 1 < argc; i += 2) arguments[argv[i]] = argv[i + 1];
  return arguments;
}

Image grey_picture(const Arguments& arguments) {
  auto picture = orbs::image::make_image(std::stoi(arguments.at("--width")),
                                         std::stoi(arguments.at("--height")), {"R", "G", "B"});
  for (auto& value : picture.pixels) value = std::stof(arguments.at("--grey"));
  return picture;
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

void print_much() {
  for (int line = 0; line < 200000; ++line) fmt::print("line {} of much too much output\n", line);
}

int behave(const std::string& mode, const Arguments& arguments) {
  const std::string output = arguments.at("--output");
  auto picture = grey_picture(arguments);
  if (mode == "segfault") std::raise(SIGSEGV);
  if (mode == "exit3") return 3;
  if (mode == "hang") hang();
  if (mode == "hang-with-child") hang_with_child();
  if (mode == "interrupt") {
    ::kill(::getppid(),
           SIGINT);  // as Ctrl-C in the terminal of the harness, which is another session than ours
    hang();
  }
  if (mode == "nothing") return 0;
  if (mode == "garbage") return std::ofstream(output) << "this is no picture", 0;
  if (mode == "much") print_much();
  if (mode == "complain") fmt::print(stderr, "fake: something is odd\n");
  if (mode == "wrong-size")
    picture = orbs::image::make_image(picture.width / 2, picture.height, {"R", "G", "B"});
  if (mode == "wrong-channels") picture = orbs::image::make_image(picture.width, picture.height, {"Y"});
  if (mode == "nan") picture.at(3, 2, 1) = std::numeric_limits<float>::quiet_NaN();
  if (mode == "infinite") picture.at(5, 1, 0) = std::numeric_limits<float>::infinity();
  if (mode == "exit3-after-picture") return orbs::image::write_exr(picture, output), 3;
  if (mode == "environment")
    for (char** entry = environ; *entry != nullptr; ++entry) fmt::print("{}\n", *entry);
  orbs::image::write_exr(picture, output);
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
