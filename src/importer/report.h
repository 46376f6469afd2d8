#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

/// Makes a case of a scene that another program wrote as glTF 2.0.
namespace orbs::importer {

/// What a file holds that the scene format cannot say, or not in the same way, by what it is and what is
/// drawn in its place. Nothing of a file is left out without a word here.
class Report {
 public:
  /// `what` in the plural, "normal maps"; `instead`: what is drawn, "the normals of the mesh alone"; `where`:
  /// "material 'skin'", counted once however often it is told.
  void not_understood(const std::string& what, const std::string& instead, const std::string& where);
  /// What the importer chose, as the file says nothing: a sentence.
  void chosen(const std::string& sentence) { choices_.push_back(sentence); }

  struct Remark {
    std::string what;
    std::string instead;
    std::vector<std::string> where;
  };
  /// In the order of the alphabet.
  std::vector<Remark> remarks() const;
  const std::vector<std::string>& choices() const { return choices_; }

 private:
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> remarks_;
  std::vector<std::string> choices_;
};

/// "normal maps: 2 (material 'a', material 'b'): the normals of the mesh alone". Of many places the first.
std::string text_of(const Report::Remark& remark);

}  // namespace orbs::importer
