#pragma once

// Only what the reader needs of the library: images are decoded by our own module, and every file is opened
// by source.cpp, which looks where its path leads.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>
