// Who may change a file through the server, and what must be said before one is written.
#include "base/error.h"
#include "base/files.h"
#include "page/fixture_runs.h"
#include "server/edit_gate.h"
#include "structure/source_files.h"
#include "unit/server/client.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace fs = std::filesystem;
using namespace orbs::server_tests;

namespace {

constexpr std::chrono::milliseconds kHeadTimeout{2000};

// A server of the small run whose editor adds a line to a file.
class ServerEdit : public ::testing::Test {
 protected:
  orbs::server::Editor editor() const {
    const auto file = scratch_.path() / "file.txt";
    return {[file](const auto& record, const std::string& reason, const std::string& until) {
              if (reason == "bad") throw orbs::InputError("a bad reason");
              const auto before = orbs::read_file(file);
              return orbs::server::EditedText{
                  file, before,
                  before + fmt::format("{} {} {} {}\n", record.targets.at(0).target, record.targets.size(),
                                       reason, until),
                  2};
            },
            [](const fs::path& path, const std::string& text) { orbs::write_file(path, text); }};
  }

  fs::path made_run() const {
    scratch_.write("file.txt", "first\n");
    auto run = scratch_.path() / "run";
    fs::create_directories(run);
    orbs::page_tests::write_small_run(run);
    return run;
  }

  std::string text() const { return orbs::read_file(scratch_.path() / "file.txt"); }
  std::string host() const { return fmt::format("localhost:{}", server_.port()); }
  std::string origin() const { return "Origin: http://" + host() + "\r\n"; }
  std::string token() const { return fmt::format("Orbs-Token: {}\r\n", server_.token()); }
  static std::string json() { return "Content-Type: application/json\r\n"; }

  static std::string body(const std::string& more = "", const std::string& reason = "why") {
    return R"({"run": 0, "target": "values", "renderer": "one", "reason": ")" + reason + "\"" + more + "}";
  }

  std::string post(const std::string& headers,
                   const std::string& content,
                   const std::string& line = "POST /edit/known-failure HTTP/1.1") const {
    return server_.talk(fmt::format("{}\r\nHost: {}\r\n{}Content-Length: {}\r\n\r\n{}", line, host(), headers,
                                    content.size(), content));
  }
  std::string talk(const std::string& bytes) const { return server_.talk(bytes); }
  std::string post(const std::string& content) const { return post(origin() + token() + json(), content); }

  static std::string hash_in(const std::string& answer) {
    const std::string before = "\"hash\": \"";
    const auto at = answer.find(before);
    return at == std::string::npos ? "" : answer.substr(at + before.size(), 16);
  }

 private:
  orbs::structure::TestFolder scratch_{"server-edit"};
  RunningServer server_{made_run(), kHeadTimeout, editor()};
};

}  // namespace

TEST_F(ServerEdit, ShowsTheDifferenceFirstAndWritesWhatIsConfirmed) {
  const auto shown = post(body(R"(, "until": "2999-01-01")"));
  ASSERT_EQ(status_of(shown), 200) << shown;
  EXPECT_NE(shown.find(R"(@@ -1 +1,2 @@\n first\n+values 1 why 2999-01-01\n)"), std::string::npos) << shown;
  EXPECT_NE(shown.find("\"written\": false"), std::string::npos) << shown;
  EXPECT_EQ(text(), "first\n");
  const auto written = post(body(R"(, "hash": ")" + hash_in(shown) + "\""));
  ASSERT_EQ(status_of(written), 200) << written;
  EXPECT_NE(written.find("\"written\": true"), std::string::npos) << written;
  EXPECT_EQ(text(), "first\nvalues 1 why \n");
}

TEST_F(ServerEdit, AChangeOfAnotherFileThanTheOneThatWasSeenIsRefused) {
  const auto hash = hash_in(post(body()));
  ASSERT_EQ(hash.size(), 16U);
  ASSERT_EQ(status_of(post(body(R"(, "hash": ")" + hash + "\""))), 200);
  const auto now = text();
  const auto stale = post(body(R"(, "hash": ")" + hash + "\""));
  EXPECT_EQ(status_of(stale), 409) << stale;
  EXPECT_NE(stale.find("has changed since its difference was shown"), std::string::npos) << stale;
  EXPECT_EQ(status_of(post(body(R"(, "hash": "")"))), 409) << "an empty hash confirms nothing";
  EXPECT_EQ(text(), now);
}

TEST_F(ServerEdit, OnlyThePageOfThisServerWithItsTokenMayAsk) {
  const auto almost =
      token().replace(token().size() - 3, 1, token().at(token().size() - 3) == '0' ? "1" : "0");
  struct Refused {
    std::string headers;
    int status;
  };
  const std::vector<Refused> all{
      {origin() + json(), 403},
      {origin() + json() + almost, 403},
      {origin() + json() + "Orbs-Token: \r\n", 403},
      {origin() + json() + token().substr(0, 20) + "\r\n", 403},
      {token() + json(), 403},
      {token() + json() + "Origin: null\r\n", 403},
      {token() + json() + "Origin: http://evil.example\r\n", 403},
      {token() + json() + "Origin: https://" + host() + "\r\n", 403},
      {token() + json() + "Origin: http://localhost:1\r\n", 403},
      {token() + json() + origin() + "Sec-Fetch-Site: cross-site\r\n", 403},
      {token() + json() + origin() + "Sec-Fetch-Site: same-site\r\n", 403},
      {token() + json() + origin() + origin(), 400},
      {token() + token() + json() + origin(), 400},
      {token() + origin(), 415},
      {token() + origin() + "Content-Type: text/plain\r\n", 415},
      {token() + origin() + "Content-Type: application/x-www-form-urlencoded\r\n", 415},
      {token() + origin() + json() + "Transfer-Encoding: chunked\r\n", 413},
  };
  for (const auto& [headers, status] : all) EXPECT_EQ(status_of(post(headers, body())), status) << headers;
  EXPECT_EQ(status_of(post(token() + origin() + "Content-Type: application/json; charset=utf-8\r\n", body())),
            200);
  EXPECT_EQ(text(), "first\n");
}

TEST_F(ServerEdit, OtherNamesOfTheServerAreRefused) {
  for (const std::string name : {"evil.example", "localhost", "localhost:1", "127.0.0.1.evil.example"}) {
    const auto request = fmt::format(
        "POST /edit/known-failure HTTP/1.1\r\nHost: {0}\r\nOrigin: http://{0}\r\n{1}{2}Content-Length: {3}\r\n\r\n"
        "{4}",
        name, token(), json(), body().size(), body());
    EXPECT_EQ(status_of(talk(request)), 421) << name;
  }
}

TEST_F(ServerEdit, OtherMethodsAndPathsChangeNothing) {
  const auto headers = origin() + token() + json();
  for (const char* method : {"GET", "HEAD", "PUT", "DELETE", "OPTIONS", "PATCH"}) {
    const auto line = std::string(method) + " /edit/known-failure HTTP/1.1";
    EXPECT_EQ(status_of(talk(fmt::format("{}\r\nHost: {}\r\n{}\r\n", line, host(), headers))), 405) << method;
  }
  EXPECT_EQ(status_of(post(headers, body(), "POST /data/runs.json HTTP/1.1")), 405);
  EXPECT_EQ(status_of(post(headers, body(), "POST /edit/other HTTP/1.1")), 404);
  EXPECT_EQ(status_of(post(headers, body(), "POST /edit/../known-failure HTTP/1.1")), 400);
  EXPECT_EQ(text(), "first\n");
}

TEST_F(ServerEdit, BrokenBodiesAreRefused) {
  const std::vector<std::string> bodies{
      std::string(),
      std::string("{"),
      std::string("[]"),
      std::string("{\"run\": 0}"),
      body(R"(, "more": 1)"),
      body(R"(, "until": 5)"),
      body(R"(, "run": 7)"),
      body("", "bad"),
      body("", "\xff"),
      R"({"run": 7, "target": "values", "renderer": "one", "reason": "why"})",
      R"({"run": 0, "target": "none", "renderer": "one", "reason": "why"})"};
  for (const auto& content : bodies) EXPECT_EQ(status_of(post(content)), 422) << content;
  EXPECT_EQ(status_of(post(std::string(orbs::server::kMostBodyBytes + 1, ' '))), 413);
  const auto headers = origin() + token() + json();
  for (const char* length : {"-1", "x", ""})
    EXPECT_EQ(
        status_of(talk(fmt::format("POST /edit/known-failure HTTP/1.1\r\nHost: {}\r\n{}Content-Length: {}\r\n"
                                   "\r\n",
                                   host(), headers, length))),
        411)
        << length;
  EXPECT_EQ(text(), "first\n");
}

TEST_F(ServerEdit, SaysThatItEdits) {
  EXPECT_NE(
      talk(fmt::format("GET /data/runs.json HTTP/1.1\r\nHost: {}\r\n\r\n", host())).find("\"edit\": true"),
      std::string::npos);
}

TEST(Server, WithoutAnEditorNothingIsPosted) {
  const orbs::structure::TestFolder scratch{"server-read-only"};
  const auto run = scratch.path() / "run";
  fs::create_directories(run);
  orbs::page_tests::write_small_run(run);
  const RunningServer server(run);
  EXPECT_EQ(server.token(), "");
  EXPECT_EQ(
      status_of(server.talk(fmt::format("POST /edit/known-failure HTTP/1.1\r\nHost: localhost:{0}\r\nOrigin: "
                                        "http://localhost:{0}\r\nOrbs-Token: \r\nContent-Type: "
                                        "application/json\r\nContent-Length: 2\r\n\r\n{{}}",
                                        server.port()))),
      405);
  EXPECT_NE(server.get("/data/runs.json").find("\"edit\": false"), std::string::npos);
}

TEST(Server, EditsOnALoopbackAddressAlone) {
  const std::atomic<bool> stop = true;
  orbs::server::ServeSettings settings;
  settings.address = "0.0.0.0";
  settings.editor = orbs::server::Editor{};
  EXPECT_THROW(orbs::server::serve(settings, stop, [](const std::string&) {}), orbs::InputError);
}

TEST(Server, TokensAreLongAndNeverTheSame) {
  const auto one = orbs::server::new_token();
  EXPECT_EQ(one.size(), 64U);
  EXPECT_NE(one, orbs::server::new_token());
  EXPECT_TRUE(orbs::server::is_token_equal(one, one));
  EXPECT_FALSE(orbs::server::is_token_equal(one.substr(1), one));
  EXPECT_FALSE(orbs::server::is_token_equal("", one));
}
