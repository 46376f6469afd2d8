#pragma once

#include "tracer/render/rendering.h"

namespace orbs::tracer_cli {

/// Shows the progress of a render: a bar on a terminal, or lines of JSON on standard output. show() is called
/// after every tile and prints at most ten times a second.
class ProgressLine {
 public:
  explicit ProgressLine(bool as_json);

  void show(const tracer::Progress& progress);
  /// Clears the bar.
  void finish() const;

 private:
  bool as_json_;
  bool on_terminal_;
  double last_seconds_ = 0;
};

}  // namespace orbs::tracer_cli
