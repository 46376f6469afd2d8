#include "golden/xml.h"

#include "base/text.h"

#include <stdexcept>
#include <utility>

namespace orbs::tests {

const Element* Element::named(const std::string& called) const {
  for (const Element& child : children)
    if (child.attributes.contains("name") && child.at("name") == called) return &child;
  return nullptr;
}

const Element* Element::kind(const std::string& tag) const {
  for (const Element& child : children)
    if (child.name == tag) return &child;
  return nullptr;
}

const std::string& Element::value(const std::string& called) const {
  if (named(called) == nullptr) throw std::runtime_error(name + " has no " + called);
  return named(called)->at("value");
}

double Element::number(const std::string& called) const { return to_number(value(called)).value(); }

namespace {

class XmlReader {
 public:
  explicit XmlReader(std::string text) : text_(std::move(text)) {}

  Element read() {
    skip();
    Element root = element();
    skip();
    if (at_ != text_.size()) throw std::runtime_error("text after the root element");
    return root;
  }

 private:
  bool comes(const std::string& word) const { return text_.compare(at_, word.size(), word) == 0; }
  void expect(const std::string& word) {
    if (!comes(word)) throw std::runtime_error("expected " + word + " before " + text_.substr(at_, 40));
    at_ += word.size();
  }
  void to_end_of(const std::string& word) {
    at_ = text_.find(word, at_);
    if (at_ == std::string::npos) throw std::runtime_error("no " + word);
    at_ += word.size();
  }
  void skip() {
    for (;;) {
      while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
      if (comes("<?")) {
        to_end_of("?>");
      } else if (comes("<!--")) {
        at_ += 4;
        to_end_of("--");
        expect(">");  // "--" may not stand inside of a comment
      } else {
        return;
      }
    }
  }
  std::string until(const std::string& ends) {
    const auto end = text_.find_first_of(ends, at_);
    if (end == std::string::npos) throw std::runtime_error("unfinished markup");
    std::string word = text_.substr(at_, end - at_);
    at_ = end;
    return word;
  }
  Element element() {
    Element e;
    expect("<");
    e.name = until(" />");
    for (skip(); !comes("/>") && !comes(">"); skip()) {
      const std::string key = until("=");
      expect("=\"");
      e.attributes[key] = until("\"<&");
      expect("\"");
    }
    if (comes("/>")) {
      at_ += 2;
      return e;
    }
    expect(">");
    for (skip(); !comes("</"); skip()) e.children.push_back(element());
    expect("</" + e.name + ">");
    return e;
  }

  std::string text_;
  std::size_t at_ = 0;
};

}  // namespace

Element read_xml(const std::string& text) { return XmlReader(text).read(); }

}  // namespace orbs::tests
