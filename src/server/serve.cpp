#include "server/serve.h"

#include "base/error.h"
#include "server/edit.h"
#include "server/edit_gate.h"
#include "server/http.h"
#include "server/reception.h"
#include "server/request_gate.h"
#include "server/served.h"
#include "server/site.h"
#include "server/workers.h"

#include <exception>
#include <utility>

#include <fmt/format.h>

namespace orbs::server {

namespace {

Response response_to(Site& site, const Request& request) {
  try {
    Response response;
    // The gate lets POST pass only where there is an editor.
    if (request.method == "POST")
      answer_edit(site, request, response);
    else
      answer(site, request, response);
    return response;
  } catch (const std::exception&) {
    Response failed;
    set_safe_headers(failed);
    refuse(failed, 500, "the server failed; please report what was asked");
    return failed;
  }
}

void send_answer(const Connection& connection, Site& site, const Request& request) {
  const auto response = response_to(site, request);
  try {
    send_response(connection, request.method, response);
  } catch (const std::exception&) {
    // The head has been sent. The client sees less than the length that it names.
  }
}

void receive(Site& site,
             Descriptor listener,
             const GateSettings& gate,
             std::chrono::milliseconds request_timeout,
             const std::atomic<bool>& stop) {
  ConnectionLimits limits;
  limits.request_timeout = request_timeout;
  Reception reception(std::move(listener), gate, limits);
  Workers workers(limits.threads, [&](Visitor visitor) {
    send_answer({visitor.sock.number(), limits.write_timeout}, site, visitor.request);
    reception.give_back(std::move(visitor.sock));
  });
  reception.run(stop, [&](Visitor visitor) { workers.add(std::move(visitor)); });
}

}  // namespace

void serve(const ServeSettings& settings,
           const std::atomic<bool>& stop,
           const std::function<void(const std::string& url)>& ready) {
  if (settings.editor && !is_loopback_address(settings.address))
    throw InputError(
        fmt::format("{} is not this machine's loopback address: a page that writes files is "
                    "served there alone",
                    settings.address));
  Site site;
  if (settings.editor) site.editor = &*settings.editor;
  site.listeners.stop = &stop;
  std::vector<std::filesystem::path> folders;
  for (const auto& folder : settings.runs) {
    site.runs.push_back(open_served(folder));
    folders.push_back(named(site.runs.back()));
  }
  site.names = run_names(folders);
  site.bundle = load_bundle(settings.bundle);
  auto listener = listen_on(settings.address, settings.port, ConnectionLimits{}.backlog);
  GateSettings gate{is_loopback_address(settings.address)};
  if (settings.editor) gate.edit = EditGate{new_token(), listener.port};
  const auto& address = settings.address;
  const bool is_six = address.find(':') != std::string::npos;
  // Behind '#', where no browser sends it to anybody, no log notes it, and no link passes it on.
  ready(fmt::format("http://{}:{}/{}", is_six ? "[" + address + "]" : address, listener.port,
                    gate.edit ? "#edit=" + gate.edit->token : ""));
  receive(site, std::move(listener.sock), gate, settings.request_timeout, stop);
}

}  // namespace orbs::server
