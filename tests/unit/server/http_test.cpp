#include "server/http.h"

#include <string>

#include <gtest/gtest.h>

using namespace orbs::server;

TEST(Http, ReadsPathsAndParameters) {
  const Request request{"GET", "/data/0/image/a%20b.exr?layer=S1+%2B%26&empty&x=1=2&layer=other"};
  EXPECT_EQ(path_of(request), "/data/0/image/a b.exr");
  EXPECT_EQ(parameter(request, "layer"), "S1 +&");
  EXPECT_EQ(parameter(request, "empty"), "");
  EXPECT_EQ(parameter(request, "x"), "1=2");
  EXPECT_EQ(parameter(request, "lay"), "");
  EXPECT_EQ(parameter({"GET", "/layer=1"}, "layer"), "");
  EXPECT_EQ(parameter({"GET", "/?"}, "layer"), "");
}

TEST(Http, AHeadNamesTheLengthThatIsKnown) {
  Response response;
  response.headers.emplace_back("Vary", "Accept-Encoding");
  set_content(response, "abc", "text/plain");
  EXPECT_EQ(head_text(response),
            "HTTP/1.1 200 OK\r\nConnection: close\r\nVary: Accept-Encoding\r\n"
            "Content-Length: 3\r\nContent-Type: text/plain\r\n\r\n");
  response.content = Streamed{std::nullopt, [](const Connection&) {}};
  EXPECT_EQ(head_text(response).find("Content-Length"), std::string::npos);
  response.content = Streamed{7, [](const Connection&) {}};
  EXPECT_NE(head_text(response).find("Content-Length: 7\r\n"), std::string::npos);
  EXPECT_EQ(head_text({204}), "HTTP/1.1 204 No Content\r\nConnection: close\r\n\r\n");
}
