// The one source that compiles the library, which is of headers alone. Its warnings are not ours, and what it
// needs must stand before it.
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#define TINYGLTF_IMPLEMENTATION
// clang-format off
#include <fstream>
#include <sstream>

#include "importer/library.h"
