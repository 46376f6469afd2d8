#include "server/request_gate.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

using namespace orbs::server;

namespace {

int status_for(const std::string& head, bool only_loopback_names = true) {
  const auto answer = check_request(head, {only_loopback_names});
  if (const auto* refusal = std::get_if<Refusal>(&answer)) return refusal->status;
  return 200;
}

std::string get(const std::string& target, const std::string& headers = "Host: localhost\r\n") {
  return "GET " + target + " HTTP/1.1\r\n" + headers + "\r\n";
}

}  // namespace

TEST(RequestGate, LetsThePageAndItsDataPass) {
  for (const char* target :
       {"/", "/page.js", "/data/runs.json", "/data/0/image/a%20b/r%C3%A9sult.exr?layer=S1"})
    EXPECT_EQ(status_for(get(target)), 200) << target;
  for (const char* host : {"localhost", "LOCALHOST:80", "127.0.0.1:8080", "[::1]:8080"})
    EXPECT_EQ(status_for(get("/", std::string("Host: ") + host + "\r\n")), 200) << host;
}

TEST(RequestGate, PassesOnNothingOfTheClientsHeaders) {
  const auto answer = check_request(get("/x", "Host: localhost\r\nRange: bytes=0-\r\nCookie: a\r\n"), {});
  const auto& admitted = std::get<Admitted>(answer);
  EXPECT_EQ(admitted.request.method, "GET");
  EXPECT_EQ(admitted.request.target, "/x");
  EXPECT_FALSE(admitted.request.reads_gzip);
  EXPECT_EQ(admitted.body_bytes, 0U);
}

TEST(RequestGate, ReadsWhetherTheClientReadsGzip) {
  const auto reads_gzip = [](const std::string& encodings) {
    const auto head = get("/", "Host: localhost\r\nAccept-Encoding: " + encodings + "\r\n");
    return std::get<Admitted>(check_request(head, {})).request.reads_gzip;
  };
  EXPECT_TRUE(reads_gzip("deflate, GZIP, br"));
  for (const char* without : {"identity", "gzip;q=0", "xgzip", ""})
    EXPECT_FALSE(reads_gzip(without)) << without;
}

TEST(RequestGate, AnotherAddressHasNamesThatWeDoNotKnow) {
  EXPECT_EQ(status_for(get("/", "Host: render-box\r\n"), true), 421);
  EXPECT_EQ(status_for(get("/", "Host: render-box\r\n"), false), 200);
}

TEST(RequestGate, DecodesPercentCodesOnce) {
  EXPECT_EQ(decoded("/a%2520b"), "/a%20b");
  EXPECT_EQ(decoded("%41%zz%4"), "A%zz%4");
}

TEST(RequestGate, RefusesOverlongAndBrokenUtf8) {
  for (const char* code : {"%C0%AF", "%E0%80%AF", "%ED%A0%80", "%FF", "%F5%80%80%80", "%C3"})
    EXPECT_EQ(status_for(get(std::string("/") + code)), 400) << code;
}
