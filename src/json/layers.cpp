#include "json/layers.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace orbs::json {

namespace {

using Json = nlohmann::json;

std::string below(const std::string& pointer, const std::string& key) {
  return (Json::json_pointer(pointer) / key).to_string();
}

// Puts one document after the other over the whole.
class Merge {
 public:
  Merge(const LayeredArrays& arrays, const TextOf& text_of, Layers& layers)
      : arrays_(arrays), text_of_(text_of), layers_(layers) {}

  void add(std::size_t layer) {
    layer_ = layer;
    const auto& from = *layers_.documents[layer].root;
    for (const auto& [key, value] : from.items()) {
      const auto pointer = below("", key);
      const bool is_there = whole_.contains(key) && whole_[key].is_array() && value.is_array();
      if (arrays_.by_name.contains(key) && value.is_array())
        add_by_name(key, value);
      else if (arrays_.appended.contains(key) && is_there)
        for (std::size_t i = 0; i < value.size(); ++i)
          append(whole_[key], pointer, value[i], below(pointer, std::to_string(i)));
      else
        put(whole_, key, pointer, value, pointer);
    }
  }

  Json take() { return std::move(whole_); }

 private:
  // Several elements of one name in one document are for its reader to refuse.
  void add_by_name(const std::string& key, const Json& elements) {
    const auto pointer = below("", key);
    if (!whole_.contains(key) || !whole_[key].is_array()) {
      whole_[key] = Json::array();
      set_origin(pointer, pointer);
    }
    auto& all = whole_[key];
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const auto from = below(pointer, std::to_string(i));
      const auto name = name_of(elements[i]);
      const auto known = numbers_.find(key + "/" + name);
      if (!name.empty() && known != numbers_.end()) {
        const auto at = below(pointer, std::to_string(known->second));
        for (const auto& [member, value] : elements[i].items())
          if (member != "name")
            put(all[known->second], member, below(at, member), value, below(from, member));
      } else {
        if (!name.empty()) numbers_[key + "/" + name] = all.size();
        append(all, pointer, elements[i], from);
      }
    }
  }

  static std::string name_of(const Json& element) {
    if (!element.is_object()) return "";
    const auto name = element.find("name");
    return name != element.end() && name->is_string() ? name->get<std::string>() : "";
  }

  void append(Json& array, const std::string& pointer, const Json& value, const std::string& from) {
    set_origin(below(pointer, std::to_string(array.size())), from);
    array.push_back(filled(value, from));
  }

  // `at` and `from`: where the value is to stand in the whole, and where it stands in its document.
  void put(Json& object,
           const std::string& key,
           const std::string& at,
           const Json& value,
           const std::string& from) {
    const auto found = object.find(key);
    if (found != object.end() && value.is_null()) {
      object.erase(found);
    } else if (found != object.end() && found->is_object() && value.is_object()) {
      for (const auto& [member, inner] : value.items())
        put(*found, member, below(at, member), inner, below(from, member));
    } else {
      object[key] = filled(value, from);
      set_origin(at, from);
    }
  }

  Json filled(const Json& value, const std::string& from) const {
    if (value.is_string()) return text_of_(layer_, from, value.get<std::string>());
    if (!value.is_structured()) return value;
    auto out = value;
    for (auto& [key, inner] : out.items()) inner = filled(inner, below(from, key));
    return out;
  }

  // What stood below that value before comes from elsewhere now.
  void set_origin(const std::string& at, const std::string& from) {
    auto& origins = layers_.origins;
    for (auto inner = origins.lower_bound(at + "/");
         inner != origins.end() && inner->first.starts_with(at + "/");)
      inner = origins.erase(inner);
    origins[at] = {layer_, from};
  }

  const LayeredArrays& arrays_;
  const TextOf& text_of_;
  Layers& layers_;
  std::size_t layer_ = 0;
  Json whole_ = Json::object();
  std::map<std::string, std::size_t> numbers_;  // of named elements, by "array/name"
};

}  // namespace

Document layered(std::vector<Document> documents, const LayeredArrays& arrays, const TextOf& text_of) {
  auto layers = std::make_shared<Layers>();
  layers->documents = std::move(documents);
  Merge merge(arrays, text_of, *layers);
  for (std::size_t i = 0; i < layers->documents.size(); ++i) merge.add(i);
  Document whole = layers->documents.front();
  whole.root = std::make_shared<const Json>(merge.take());
  whole.layers = std::move(layers);
  return whole;
}

Standing standing_of(const Document& document, const std::string& pointer) {
  if (!document.layers) return {&document, pointer};
  const auto& origins = document.layers->origins;
  auto known = pointer;
  for (;;) {
    if (const auto found = origins.find(known); found != origins.end())
      return {&document.layers->documents[found->second.layer],
              found->second.pointer + pointer.substr(known.size())};
    if (known.empty()) return {&document.layers->documents.front(), pointer};
    known.resize(known.rfind('/'));
  }
}

}  // namespace orbs::json
