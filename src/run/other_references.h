#pragma once

#include "image/image.h"
#include "judge/reference.h"
#include "run/plan/plan.h"

#include <map>
#include <string>

namespace orbs::run {

/// By name the references of the other targets that the case has in its file, whether the run has them or
/// not: what is said of an image does not depend on the filters of its run. Those without a usable reference
/// are left out. Copies are read where the run has made some, else the originals.
std::map<std::string, image::Image> other_references(const Plan& plan,
                                                     const registry::Case& one_case,
                                                     const std::string& target,
                                                     const judge::ReferenceCopies& copies);

}  // namespace orbs::run
