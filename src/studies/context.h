#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

namespace orbs::studies {

/// The surroundings of a study: what every study gets from the program that starts it.
struct StudyContext {
  std::filesystem::path build;                  // {build} of the renderers' commands
  std::string orbs_version;                     // for the record of the study
  const std::atomic<bool>* stop = nullptr;      // set when the user interrupts; may be null
  std::function<void(const std::string&)> say;  // takes one line of progress
  bool sandbox = false;                         // of studies that make no plan of a suite
};

inline bool is_stopped(const StudyContext& context) {
  return context.stop != nullptr && context.stop->load();
}

}  // namespace orbs::studies
