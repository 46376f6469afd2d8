#include "server/events.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>

#include <fmt/format.h>

namespace orbs::server {

namespace {

constexpr int kMostListeners = 64;
constexpr std::chrono::milliseconds kPause{250};
constexpr std::chrono::seconds kSignOfLife{10};

// Counts a client as long as its answer lives.
class Listener {
 public:
  explicit Listener(std::atomic<int>& count) : count_(count) { ++count_; }
  ~Listener() { --count_; }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  std::uint64_t seen = 0;  // the version of the run that the client knows
  std::chrono::steady_clock::time_point last_word;

 private:
  std::atomic<int>& count_;
};

// Joins the JSON to one line of data; our writer breaks lines between members only.
std::string event_text(std::uint64_t version, const std::string& json) {
  std::string line;
  for (const char c : json)
    if (c != '\n') line += c;
  return fmt::format("id: {}\nevent: progress\ndata: {}\n\n", version, line);
}

// False when nothing more is to be sent.
bool send_next(const std::atomic<bool>* stop,
               ServedRun& run,
               Listener& listener,
               const Connection& connection) {
  const auto version = run.version();
  const auto now = std::chrono::steady_clock::now();
  std::string text;
  if (version != listener.seen) {
    listener.seen = version;
    text = event_text(version, run.progress());
  } else if (now - listener.last_word > kSignOfLife) {
    text = ":\n\n";  // a comment keeps the connection, and fails if the client is gone
  }
  if (!text.empty()) {
    listener.last_word = now;
    if (!connection.send(text)) return false;
  }
  if (!run.is_live() || (stop != nullptr && stop->load())) return false;
  std::this_thread::sleep_for(kPause);
  return connection.is_open();
}

}  // namespace

void send_events(EventClients& clients, ServedRun& run, Response& response) {
  if (!run.is_live()) {
    response.status = 204;
    return;
  }
  if (clients.count >= kMostListeners) return refuse(response, 503, "too many pages follow this run");
  const auto listener = std::make_shared<Listener>(clients.count);
  listener->last_word = std::chrono::steady_clock::now();
  response.type = "text/event-stream";
  response.content =
      Streamed{std::nullopt, [stop = clients.stop, &run, listener](const Connection& connection) {
                 while (send_next(stop, run, *listener, connection)) {
                 }
               }};
}

}  // namespace orbs::server
