#include "importer/accessors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace orbs::importer {

namespace {

// More are a mistake, or meant to exhaust the machine: a scene of ours has no more triangles.
constexpr std::size_t kMostElements = std::size_t{1} << 26;
// Of numbers that the file does not hold, a few bytes of it ask for.
constexpr std::size_t kMostZeros = std::size_t{1} << 22;

template <typename Number>
double number_at(const unsigned char* bytes, bool is_normalised) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  if constexpr (std::is_integral_v<Number>) {
    // 3.11 of the specification: signed ones have two words for -1.
    if (is_normalised)
      return std::max(-1.0,
                      static_cast<double>(number) / static_cast<double>(std::numeric_limits<Number>::max()));
  }
  return static_cast<double>(number);
}

using Reader = double (*)(const unsigned char*, bool);

Reader reader_of(int component) {
  switch (component) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return number_at<std::int8_t>;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return number_at<std::uint8_t>;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return number_at<std::int16_t>;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return number_at<std::uint16_t>;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return number_at<std::uint32_t>;
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return number_at<float>;
    default:
      return nullptr;
  }
}

// Elements in a view of a buffer.
struct Run {
  int view = 0;
  std::size_t offset = 0;
  int component = TINYGLTF_COMPONENT_TYPE_FLOAT;
  std::size_t width = 1;
  std::size_t count = 0;
  bool is_normalised = false;
};

// Calls take(element, number within the element, value).
template <typename Take>
void read_run(const Source& source, const Run& run, const std::string& where, const Take& take) {
  const auto& view = item(source, source.model.bufferViews, run.view, "buffer view", where);
  const auto& buffer = item(source, source.model.buffers, view.buffer, "buffer", where);
  const Reader read = reader_of(run.component);
  if (read == nullptr)
    refuse(source, fmt::format("{} has the component type {}, which glTF has not", where, run.component));
  const auto size =
      static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(run.component)));
  const std::size_t stride = view.byteStride > 0 ? view.byteStride : size * run.width;
  // Of an offset that is negative in the file, the sum below would start again at 0.
  const std::size_t needed = run.offset > buffer.data.size() ? run.offset
                             : run.count == 0                ? 0
                                              : run.offset + (run.count - 1) * stride + size * run.width;
  const std::size_t there =
      std::min(view.byteLength, buffer.data.size() - std::min(view.byteOffset, buffer.data.size()));
  if (needed > there)
    refuse(source, fmt::format("{} has {} elements, which end at byte {} of a buffer view of {}: the file is "
                               "torn, or the program that wrote it counts wrongly",
                               where, run.count, needed, there));
  const unsigned char* start = buffer.data.data() + view.byteOffset + run.offset;
  for (std::size_t i = 0; i < run.count; ++i)
    for (std::size_t k = 0; k < run.width; ++k)
      take(i, k, read(start + i * stride + k * size, run.is_normalised));
}

std::size_t not_negative(const Source& source, long long value, const std::string& where) {
  if (value < 0) refuse(source, fmt::format("{} has an offset or count of {}", where, value));
  return static_cast<std::size_t>(value);
}

void read_sparse(const Source& source,
                 const tinygltf::Accessor& accessor,
                 const std::string& where,
                 Numbers& numbers) {
  const auto& sparse = accessor.sparse;
  const std::size_t count = not_negative(source, sparse.count, where);
  if (count > numbers.count)
    refuse(source, fmt::format("{} replaces {} of {} elements", where, count, numbers.count));
  std::vector<std::size_t> places(count);
  read_run(source,
           {sparse.indices.bufferView, not_negative(source, sparse.indices.byteOffset, where),
            sparse.indices.componentType, 1, count, false},
           where + " (sparse)", [&](std::size_t i, std::size_t, double value) {
             if (value < 0 || value >= static_cast<double>(numbers.count))
               refuse(source, fmt::format("{} replaces element {} of {}", where, value, numbers.count));
             places[i] = static_cast<std::size_t>(value);
           });
  read_run(source,
           {sparse.values.bufferView, not_negative(source, sparse.values.byteOffset, where),
            accessor.componentType, numbers.width, count, accessor.normalized},
           where + " (sparse)", [&](std::size_t i, std::size_t k, double value) {
             numbers.values[places[i] * numbers.width + k] = value;
           });
}

}  // namespace

Numbers read_numbers(const Source& source, int index, std::size_t width, const std::string& where) {
  const auto& accessor = item(source, source.model.accessors, index, "accessor", where);
  const int found = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  Numbers numbers{accessor.count, found < 0 ? 0 : static_cast<std::size_t>(found), {}};
  if (numbers.width == 0 || (width != 0 && numbers.width != width))
    refuse(source,
           fmt::format("{} has elements of {} numbers; {} were expected", where, numbers.width, width));
  const std::size_t most = accessor.bufferView < 0 ? kMostZeros : kMostElements;
  if (numbers.count > most)
    refuse(source, fmt::format("{} has {} elements; at most {} are read", where, numbers.count, most));
  if (accessor.bufferView >= 0) {
    const Run run{accessor.bufferView, accessor.byteOffset, accessor.componentType,
                  numbers.width,       numbers.count,       accessor.normalized};
    read_run(source, run, where,
             [&](std::size_t, std::size_t, double value) { numbers.values.push_back(value); });
  } else {  // 3.6.2.3 of the specification: all are 0
    numbers.values.assign(numbers.count * numbers.width, 0);
  }
  if (accessor.sparse.isSparse) read_sparse(source, accessor, where, numbers);
  return numbers;
}

std::vector<std::uint32_t> read_indices(const Source& source,
                                        int accessor,
                                        std::size_t end,
                                        const std::string& where) {
  const Numbers numbers = read_numbers(source, accessor, 1, where);
  std::vector<std::uint32_t> indices;
  indices.reserve(numbers.count);
  for (std::size_t i = 0; i < numbers.count; ++i) {
    const double value = numbers.values[i];
    if (!(value >= 0 && value < static_cast<double>(end)) || value != std::floor(value))
      refuse(source, fmt::format("{}: the one at place {} is {}, and there are {} vertices, counted from 0",
                                 where, i, value, end));
    indices.push_back(static_cast<std::uint32_t>(value));
  }
  return indices;
}

}  // namespace orbs::importer
