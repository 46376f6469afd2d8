#pragma once

#include "image/image.h"
#include "scene/scene.h"

#include <string>
#include <utility>
#include <vector>

/// What orbs-faulty-tracer, a program of the tests, does beside the faults of tracer/numeric_fault.h. In
/// orbs-tracer there is nothing of it.
namespace orbs::tracer_cli {

#ifdef ORBS_FAULTS

/// What --fault takes beside the names of scene::RenderFault.
std::vector<std::string> numeric_fault_names();
/// Makes the numeric fault of this name from now on; none for another name.
void begin_numeric_fault(const std::string& name);
/// The scene as a renderer with the fault keeps it.
scene::Scene as_kept(scene::Scene scene);
/// The image as a renderer with the fault writes it.
image::Image as_written(image::Image image);

#else

inline std::vector<std::string> numeric_fault_names() { return {}; }
inline void begin_numeric_fault(const std::string&) {}
inline scene::Scene as_kept(scene::Scene scene) { return scene; }
inline image::Image as_written(image::Image image) { return image; }

#endif

}  // namespace orbs::tracer_cli
