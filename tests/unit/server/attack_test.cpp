// What a hostile page, program or run folder might try on the server.
#include "page/fixture_runs.h"
#include "structure/source_files.h"
#include "unit/server/client.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;
using namespace orbs::server_tests;

namespace {

constexpr const char* kSecret = "nobody may read this";

// A run with a secret beside its folder, and ways to it inside.
struct Target {
  orbs::structure::TestFolder scratch{"server-attack"};
  fs::path run = scratch.path() / "run";

  Target() {
    fs::create_directories(run);
    orbs::page_tests::write_small_run(run);
    scratch.write("secret.txt", kSecret);
    scratch.write("run-other/secret.txt", kSecret);
    fs::create_symlink("../secret.txt", run / "link.txt");
    fs::create_symlink("/etc/passwd", run / "passwd");
    fs::create_directory_symlink("..", run / "up");
    fs::create_symlink("one/values/result.exr", run / "inner.exr");
    ::mkfifo((run / "pipe").c_str(), 0600);
    scratch.write("run/page.html", "<script>alert(1)</script>");
  }
};

// One run and one server for all tests of this file: they change nothing.
const Target& target() {
  static const Target made;
  return made;
}

const RunningServer& server() {
  static const RunningServer running(target().run);
  return running;
}

std::string request(const std::string& line, const std::string& headers = "Host: localhost\r\n") {
  return line + "\r\n" + headers + "\r\n";
}

std::string get_of(const std::string& target) { return request("GET " + target + " HTTP/1.1"); }

std::vector<std::string> attacks_by_path() {
  std::vector<std::string> targets;
  const std::string file = "/data/0/file/";
  for (const char* path : {"../secret.txt",
                           "..",
                           ".",
                           "",
                           "a/../../secret.txt",
                           "./link.txt",
                           "one/./values/result.exr",
                           "%2e%2e/secret.txt",
                           "%2E%2E%2Fsecret.txt",
                           "..%2fsecret.txt",
                           "..%5csecret.txt",
                           "..\\secret.txt",
                           "%252e%252e/secret.txt",
                           "%c0%ae%c0%ae/secret.txt",
                           "..%c0%afsecret.txt",
                           "%u002e%u002e/secret.txt",
                           "..;/secret.txt",
                           "....//secret.txt",
                           "/etc/passwd",
                           "//etc/passwd",
                           "%2fetc%2fpasswd",
                           "link.txt",
                           "passwd",
                           "up/secret.txt",
                           "up/run/results.json",
                           "inner.exr",
                           "pipe",
                           "one",
                           "one/",
                           "results.json/",
                           "results.json%00.png",
                           "results.json%0d%0aX: y",
                           "results%",
                           "results%4",
                           "results%zz",
                           "results.json\x01",
                           "\xc3\xa9",
                           "%ff%fe",
                           "../run-other/secret.txt",
                           "~/secret.txt",
                           "file:///etc/passwd",
                           "C:%5cwindows"})
    targets.push_back(file + path);
  for (const char* target : {"/data/1/overview.json",
                             "/data/-1/overview.json",
                             "/data/99999999999999999999/overview.json",
                             "/data/0x0/overview.json",
                             "/data/00/../0/overview.json",
                             "/data/0",
                             "/data/",
                             "/data",
                             "/data/0/target/-1.json",
                             "/data/0/target/999999.json",
                             "/data/0/target/1e3.json",
                             "/data/0/target/.json",
                             "/data/0/image/passwd",
                             "/data/0/image/link.txt",
                             "/data/0/image/inner.exr",
                             "/data/0/image/results.json",
                             "/data/0/image/../secret.txt",
                             "/data/0/image/one/values/result.exr?layer=none",
                             "/data/0/image/one/values/result.png",
                             "/../page.js",
                             "/index.html/",
                             "/page.js%00",
                             "*",
                             "http://localhost/",
                             "//localhost/page.js",
                             "?",
                             "/\\",
                             "/a b"})
    targets.push_back(target);
  return targets;
}

}  // namespace

TEST(ServerAttack, NoPathLeadsOutOfTheRunOrToWhatIsNoFile) {
  const auto targets = attacks_by_path();
  ASSERT_GE(targets.size(), 40U);
  for (const auto& target : targets) {
    const auto answer = server().talk(get_of(target));
    EXPECT_GE(status_of(answer), 400) << target << "\n" << answer.substr(0, 200);
    EXPECT_LT(status_of(answer), 500) << target;
    EXPECT_EQ(answer.find(kSecret), std::string::npos) << target;
    EXPECT_EQ(answer.find("root:"), std::string::npos) << target;
  }
}

TEST(ServerAttack, OnlyGetAndHeadAreAnswered) {
  for (const char* method :
       {"POST", "PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "CONNECT", "PROPFIND", "get", "GETT"})
    EXPECT_EQ(status_of(server().talk(request(std::string(method) + " / HTTP/1.1"))), 405) << method;
  const auto head = server().talk(request("HEAD /data/runs.json HTTP/1.1"));
  EXPECT_EQ(status_of(head), 200);
  EXPECT_EQ(body_of(head), "");
}

TEST(ServerAttack, BrokenRequestsAreRefused) {
  struct Broken {
    std::string bytes;
    int status;
  };
  const std::vector<Broken> all{
      {"GET / HTTP/1.1\n Host: localhost\n\r\n\r\n", 400},
      {request("GET /  HTTP/1.1"), 400},
      {request("GET / HTTP/2.0"), 505},
      {request("GET / FTP/1.1"), 400},
      {request("GET /"), 400},
      {request("\x16\x03\x01\x02"), 400},
      {request("GET / HTTP/1.1", ""), 400},
      {request("GET / HTTP/1.1", "Host: a\r\nHost: localhost\r\n"), 421},
      {request("GET / HTTP/1.1", "Host: localhost\r\nHost: localhost\r\n"), 400},
      {request("GET / HTTP/1.1", "Host : localhost\r\n"), 400},
      {request("GET / HTTP/1.1", "Host: localhost\r\n folded: yes\r\n"), 400},
      {request("GET / HTTP/1.1", std::string("Host: localhost\r\nX: a\0b\r\n", 25)), 400},
      {request("GET / HTTP/1.1", "Host: evil.example\r\n"), 421},
      {request("GET / HTTP/1.1", "Host: localhost.evil.example\r\n"), 421},
      {request("GET / HTTP/1.1", "Host: 127.0.0.1.evil.example:80\r\n"), 421},
      {request("GET / HTTP/1.1", "Host: localhost:80:80\r\n"), 421},
  };
  for (const auto& [bytes, status] : all) EXPECT_EQ(status_of(server().talk(bytes)), status) << bytes;
}

TEST(ServerAttack, BodiesAreRefused) {
  for (const char* header :
       {"Content-Length: 5", "Content-Length: -1", "Content-Length: 99999999999999999999",
        "Transfer-Encoding: chunked", "Transfer-Encoding: \tidentity", "Expect: 100-continue"})
    EXPECT_EQ(
        status_of(server().talk(
            request("GET / HTTP/1.1", std::string("Host: localhost\r\n") + header + "\r\n") + "GET /x")),
        413)
        << header;
}

TEST(ServerAttack, HugeHeadsAreRefused) {
  const std::string long_text(20000, 'a');
  EXPECT_EQ(status_of(server().talk(get_of("/" + long_text.substr(0, 3000)))), 414);
  EXPECT_EQ(status_of(server().talk(get_of("/" + long_text))), 431);
  EXPECT_EQ(
      status_of(server().talk(request("GET / HTTP/1.1", "Host: localhost\r\nX: " + long_text + "\r\n"))),
      431);
  EXPECT_EQ(status_of(server().talk(long_text)), 431);
  std::string many = "Host: localhost\r\n";
  for (int i = 0; i < 100; ++i) many += "X" + std::to_string(i) + ": 1\r\n";
  EXPECT_EQ(status_of(server().talk(request("GET / HTTP/1.1", many))), 431);
}

TEST(ServerAttack, OneConnectionCarriesOneRequest) {
  const auto answer = server().talk(get_of("/data/runs.json") + get_of("/data/0/file/results.json"));
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_EQ(answer.find("HTTP/1.1", 8), std::string::npos);
}

// Clients that say nothing, or too little, keep nobody else waiting: the answer comes while all of them are
// still there, and their time is not up for as long as any test may take.
TEST(ServerAttack, HalfRequestsHoldNoAnswer) {
  const RunningServer patient(target().run, std::chrono::hours(1));
  std::vector<int> halves;
  for (int i = 0; i < 300; ++i) {
    halves.push_back(connect_to(patient.port()));
    ::send(halves.back(), "GET /page.js HTT", i % 2 == 0 ? 16 : 1, MSG_NOSIGNAL);
  }
  EXPECT_EQ(status_of(patient.get("/data/runs.json")), 200);
  const std::string rest = "P/1.1\r\nHost: localhost\r\n\r\n";
  EXPECT_EQ(body_of(answer_to(halves[0], rest)), "page.js") << "the first half request was still open";
  EXPECT_EQ(body_of(answer_to(halves[298], rest)), "page.js");
  for (const int sock : halves) ::close(sock);
}

// A process has only so many files: whoever has sent half a request for longest makes room for the next.
TEST(ServerAttack, WhenAllPlacesAreTakenTheOldestHalfRequestGoes) {
  const RunningServer patient(target().run, std::chrono::hours(1));
  std::vector<int> halves;
  for (int i = 0; i < 330; ++i) {
    halves.push_back(connect_to(patient.port()));
    ::send(halves.back(), "GET /page.js HTT", 16, MSG_NOSIGNAL);
  }
  EXPECT_EQ(status_of(patient.get("/data/runs.json")), 200);
  EXPECT_EQ(status_of(answer_to(halves.front(), "")), 503);
  EXPECT_EQ(body_of(answer_to(halves.back(), "P/1.1\r\nHost: localhost\r\n\r\n")), "page.js");
  for (const int sock : halves) ::close(sock);
}

TEST(ServerAttack, ARequestThatTakesTooLongIsEnded) {
  const RunningServer impatient(target().run, std::chrono::milliseconds(50));
  EXPECT_EQ(status_of(impatient.talk("GET / HTT")), 408);
  EXPECT_EQ(status_of(impatient.talk("")), 408);
}

TEST(ServerAttack, TextsOfTheRunAreNeverMarkup) {
  const auto answer = server().get("/data/0/file/page.html");
  EXPECT_NE(answer.find("Content-Type: text/plain"), std::string::npos) << answer;
  EXPECT_NE(answer.find("X-Content-Type-Options: nosniff"), std::string::npos);
  EXPECT_NE(answer.find("Content-Security-Policy: default-src 'none'; sandbox"), std::string::npos);
  EXPECT_NE(server().get("/").find("script-src 'self'; worker-src blob:; style-src 'self'"),
            std::string::npos);
}

TEST(Server, ServesTheRunAndTheBundle) {
  EXPECT_EQ(body_of(server().get("/")), "index.html");
  EXPECT_EQ(body_of(server().get("/page.js")), "page.js");
  EXPECT_NE(body_of(server().get("/data/0/overview.json")).find("\"format\": \"orbs-page/2\""),
            std::string::npos);
  EXPECT_NE(body_of(server().get("/data/0/target/0.json")).find("a map that nobody knows"),
            std::string::npos);
  EXPECT_EQ(body_of(server().get("/data/0/image/one/values/result.exr")).substr(0, 2), "\x1f\x8b");
  EXPECT_EQ(status_of(server().get("/data/0/image/one/stokes/result.exr?layer=S3")), 200);
  EXPECT_EQ(status_of(server().get("/data/0/events")), 204) << "the run has ended";
}

TEST(Server, KnowsLoopbackAddresses) {
  for (const char* address : {"127.0.0.1", "127.1.2.3", "::1", "localhost"})
    EXPECT_TRUE(orbs::server::is_loopback_address(address)) << address;
  for (const char* address :
       {"0.0.0.0", "192.168.0.1", "::", "::ffff:127.0.0.1", "127.0.0.1.evil.example", ""})
    EXPECT_FALSE(orbs::server::is_loopback_address(address)) << address;
}
