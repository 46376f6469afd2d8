#pragma once

#include "json/object_reader.h"

#include <array>
#include <string>
#include <utility>
#include <variant>

/// Reading what the scene file names by a word under "type". A kind is a struct with `kType`, its word, or
/// with `kTypes` where several words mean it, and a free function load(entry, kind) that reads its members.
/// The list of words is that of the kinds of the variant, so that no place lists them again.
namespace orbs::scene {

template <typename Kind>
constexpr auto words_of() {
  if constexpr (requires { Kind::kTypes; })
    return Kind::kTypes;
  else
    return std::array{Kind::kType};
}

template <typename Variant>
struct KindLoader;

template <typename... Kinds>
struct KindLoader<std::variant<Kinds...>> {
  using Variant = std::variant<Kinds...>;
  static constexpr std::size_t kWordCount = (words_of<Kinds>().size() + ...);

  /// All words, in the order of the variant.
  static constexpr std::array<const char*, kWordCount> words() {
    std::array<const char*, kWordCount> all{};
    std::size_t count = 0;
    const auto add = [&](const auto& words) {
      for (const char* word : words) all[count++] = word;
    };
    (add(words_of<Kinds>()), ...);
    return all;
  }

  template <typename Kind, typename Entry>
  static bool load_if_named(const std::string& word, Entry& entry, Variant& loaded) {
    for (const char* own : words_of<Kind>())
      if (word == own) {
        load(entry, loaded.template emplace<Kind>());
        return true;
      }
    return false;
  }

  template <typename Entry, std::size_t... I>
  static Variant load_named(json::ObjectReader& in,
                            Entry& entry,
                            const char* fallback,
                            std::index_sequence<I...>) {
    const std::string word = fallback == nullptr ? in.one_of("type", {words()[I]...})
                                                 : in.one_of_or("type", fallback, {words()[I]...});
    Variant loaded;
    (load_if_named<Kinds>(word, entry, loaded) || ...);
    return loaded;
  }
};

/// The kind that "type" names, with its members; `entry` is what the load functions of the kinds take, and
/// `fallback` the word that an entry without a type means, if it may lack one. InputError at the key that is
/// wrong.
template <typename Variant, typename Entry>
Variant load_kind(json::ObjectReader& in, Entry& entry, const char* fallback = nullptr) {
  using Loader = KindLoader<Variant>;
  return Loader::load_named(in, entry, fallback, std::make_index_sequence<Loader::kWordCount>{});
}

}  // namespace orbs::scene
