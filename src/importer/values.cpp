#include "importer/values.h"

namespace orbs::importer {

std::optional<double> number_in(const tinygltf::Value& object, const std::string& key) {
  if (!object.IsObject() || !object.Has(key) || !object.Get(key).IsNumber()) return std::nullopt;
  return object.Get(key).GetNumberAsDouble();
}

std::vector<double> numbers_in(const tinygltf::Value& object,
                               const std::string& key,
                               const std::vector<double>& otherwise) {
  if (!object.IsObject() || !object.Has(key)) return otherwise;
  const auto& list = object.Get(key);
  if (!list.IsArray() || list.ArrayLen() != otherwise.size()) return otherwise;
  std::vector<double> numbers;
  for (int i = 0; i < static_cast<int>(list.ArrayLen()); ++i) {
    if (!list.Get(i).IsNumber()) return otherwise;
    numbers.push_back(list.Get(i).GetNumberAsDouble());
  }
  return numbers;
}

}  // namespace orbs::importer
