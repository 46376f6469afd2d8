#include "server/served.h"

#include "base/error.h"
#include "base/files.h"
#include "report/overview.h"
#include "report/progress.h"
#include "report/target_data.h"

#include <algorithm>
#include <iterator>

namespace orbs::server {

namespace {

// The last `count` parts, or the whole path if it has fewer.
std::string tail(const std::filesystem::path& folder, std::ptrdiff_t count) {
  const auto parts = std::distance(folder.begin(), folder.end());
  std::filesystem::path out;
  for (auto part = std::next(folder.begin(), std::max<std::ptrdiff_t>(0, parts - count));
       part != folder.end(); ++part)
    out /= *part;
  return out.string();
}

}  // namespace

std::vector<std::string> run_names(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::string> names;
  for (const auto& folder : folders) {
    const auto is_shared = [&](std::ptrdiff_t count) {
      return std::any_of(folders.begin(), folders.end(), [&](const auto& other) {
        return other != folder && tail(other, count) == tail(folder, count);
      });
    };
    std::ptrdiff_t count = 1;
    while (is_shared(count)) ++count;
    names.push_back(tail(folder, count));
  }
  return names;
}

// The first view is only for the messages: they name the folder as the user did.
ServedRun::ServedRun(const std::filesystem::path& folder)
    : named_(std::filesystem::weakly_canonical(folder)),
      view_(results::read_run_folder(named_)),
      opened_(named_),
      last_look_(std::chrono::steady_clock::now()) {
  read();
  view_.run.name = named_.filename().string();
}

void ServedRun::read() {
  // Its state first: a file that is written in between is read once more.
  results_state_ = file_state(folder() / "results.json");
  view_ = results::read_run_folder(folder());
}

std::string ServedRun::started() {
  const std::lock_guard lock(mutex_);
  look();
  return view_.run.started;
}

void ServedRun::look() {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_look_ < kPollInterval) return;
  last_look_ = now;
  try {
    if (file_state(folder() / "results.json") != results_state_) {
      read();
    } else if (!results::refresh(view_)) {
      return;
    }
  } catch (const InputError&) {
    // The folder is gone, or holds no run any more: what was read before stays.
    view_.is_live = false;
  }
  view_.run.name = named_.filename().string();
  ++version_;
  overview_.reset();
}

std::shared_ptr<const PackedText> ServedRun::overview() {
  const std::lock_guard lock(mutex_);
  look();
  if (!overview_) overview_ = std::make_shared<const PackedText>(packed_text(report::overview_json(view_)));
  return overview_;
}

std::optional<std::string> ServedRun::target(std::size_t index) {
  const std::lock_guard lock(mutex_);
  look();
  if (index >= view_.run.targets.size()) return std::nullopt;
  return report::target_json(view_, index);
}

std::string ServedRun::progress() {
  const std::lock_guard lock(mutex_);
  return report::progress_json(view_);
}

results::RunRecord ServedRun::record() {
  const std::lock_guard lock(mutex_);
  look();
  auto run = view_.run;
  run.folder = named_.string();  // for messages
  return run;
}

std::string ServedRun::suite_and_size() {
  const std::lock_guard lock(mutex_);
  return view_.run.suite + " " + view_.run.size;
}

results::RunRecord ServedRun::record_of(const std::string& target, const std::string& renderer) {
  const std::lock_guard lock(mutex_);
  look();
  auto record = view_.run;
  std::erase_if(record.targets,
                [&](const auto& one) { return one.target != target || one.renderer != renderer; });
  return record;
}

std::uint64_t ServedRun::version() {
  const std::lock_guard lock(mutex_);
  look();
  return version_;
}

bool ServedRun::is_live() {
  const std::lock_guard lock(mutex_);
  look();
  return view_.is_live;
}

ServedStudy::ServedStudy(const std::filesystem::path& folder)
    : named_(std::filesystem::weakly_canonical(folder)),
      study_(results::read_study_folder(named_)),
      opened_(named_) {}

}  // namespace orbs::server
