#include "server/serve.h"

#include "base/error.h"
#include "server/connection.h"
#include "server/refuse.h"
#include "server/run_names.h"
#include "server/site.h"

#include <chrono>
#include <exception>
#include <thread>

#include <arpa/inet.h>
#include <fmt/format.h>

namespace orbs::server {

namespace {

// Stops the server when the flag is set; ends when its own thread is told to.
class Watch {
 public:
  Watch(const std::atomic<bool>& stop, httplib::Server& server)
      : thread_([&](const std::stop_token& end) {
          constexpr std::chrono::milliseconds kPause{50};
          while (!stop.load() && !end.stop_requested()) std::this_thread::sleep_for(kPause);
          // Repeats, because a server that does not listen yet ignores it.
          do {
            server.stop();
            std::this_thread::sleep_for(kPause);
          } while (!end.stop_requested());
        }) {}

 private:
  std::jthread thread_;
};

}  // namespace

bool is_loopback_address(const std::string& address) {
  in_addr four{};
  in6_addr six{};
  constexpr std::uint32_t kFirstByte = 0xff000000U;
  constexpr std::uint32_t kLoopback = 127U << 24U;
  if (::inet_pton(AF_INET, address.c_str(), &four) == 1)
    return (ntohl(four.s_addr) & kFirstByte) == kLoopback;
  if (::inet_pton(AF_INET6, address.c_str(), &six) == 1) return IN6_IS_ADDR_LOOPBACK(&six);
  return address == "localhost";
}

void serve(const ServeSettings& settings,
           const std::atomic<bool>& stop,
           const std::function<void(const std::string& url)>& ready) {
  Site site;
  site.listeners.stop = &stop;
  site.bundle = load_bundle(settings.bundle);
  std::vector<std::filesystem::path> folders;
  for (const auto& folder : settings.runs) {
    site.runs.push_back(open_served(folder));
    folders.push_back(named(site.runs.back()));
  }
  site.names = run_names(folders);
  ConnectionLimits limits;
  limits.head_timeout = settings.head_timeout;
  GatedServer server({is_loopback_address(settings.address)}, limits);
  server.Get(".*", [&](const httplib::Request& request, httplib::Response& response) {
    answer(site, request, response);
  });
  server.set_exception_handler(
      [](const httplib::Request&, httplib::Response& response, const std::exception_ptr&) {
        refuse(response, 500, "the server failed; please report what was asked");
      });
  const int port = server.open(settings.address, settings.port);
  const bool is_six = settings.address.find(':') != std::string::npos;
  ready(fmt::format("http://{}:{}/", is_six ? "[" + settings.address + "]" : settings.address, port));
  const Watch watch(stop, server);
  server.listen_after_bind();
}

}  // namespace orbs::server
