#include "xml_element.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace lacuna::robot_files {
namespace {

constexpr const char* kSpaces = " \t\r\n";

}  // namespace

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(kSpaces); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSpaces, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(kSpaces, end);
  }
  return words;
}

std::string_view root_name(std::string_view text) {
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
    const std::string_view rest = text.substr(at);
    const std::string_view end = rest.starts_with("<!--") ? "-->" : rest.starts_with("<?") ? "?>" : ">";
    if (!rest.starts_with("<!") && !rest.starts_with("<?"))
      return rest.substr(1, std::min(rest.find_first_of(" \t\r\n/>"), rest.size()) - 1);
    at = text.find(end, at + 2);
    if (at == std::string_view::npos) break;
  }
  return {};
}

std::string without_late_declarations(std::string text) {
  constexpr std::string_view kBegin = "<?xml ", kEnd = "?>";
  for (std::size_t at = text.find(kBegin, 1); at != std::string::npos; at = text.find(kBegin, at)) {
    const std::size_t end = text.find(kEnd, at);
    if (end == std::string::npos) break;
    for (std::size_t i = at; i < end + kEnd.size(); ++i)
      if (text[i] != '\n') text[i] = ' ';
  }
  return text;
}

int line_behind_root(const tinyxml2::XMLDocument& document) {
  const tinyxml2::XMLNode* node = document.RootElement();
  while (node && !node->ToText()) node = node->NextSibling();
  return node ? node->GetLineNum() : 0;
}

std::optional<XmlElement> XmlElement::child(const char* name) const {
  const tinyxml2::XMLElement* found = element_->FirstChildElement(name);
  return found ? std::optional(XmlElement(*found, *problems_, file_)) : std::nullopt;
}

std::vector<XmlElement> XmlElement::children(const char* name) const {
  std::vector<XmlElement> all;
  for (const tinyxml2::XMLElement* one = element_->FirstChildElement(name); one; one = one->NextSiblingElement(name))
    all.emplace_back(*one, *problems_, file_);
  return all;
}

std::vector<XmlElement> XmlElement::children() const { return children(nullptr); }

std::string XmlElement::of(const char* attribute) const { return std::string(name()) + "'s " + attribute; }

std::optional<std::string> XmlElement::text_of(const char* attribute) const {
  const char* text = element_->Attribute(attribute);
  return text ? std::optional<std::string>(text) : std::nullopt;
}

std::string XmlElement::required_text(const char* attribute) const {
  const std::optional<std::string> text = text_of(attribute);
  if (!text || text->empty()) problem(of(attribute) + " is missing");
  return text.value_or("");
}

std::optional<double> XmlElement::read_number(std::string_view word, const char* attribute) const {
  const std::string_view written = word;
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc() && end == word.data() + word.size() && std::isfinite(value)) return value;
  problem(of(attribute) + " \"" + std::string(written) + "\" is not a number; write one such as 1.5");
  return std::nullopt;
}

double XmlElement::number(const char* attribute, double otherwise) const {
  const std::optional<std::string> text = text_of(attribute);
  if (!text) return otherwise;
  const std::vector<std::string_view> words = words_of(*text);
  if (words.size() == 1) return read_number(words.front(), attribute).value_or(otherwise);
  problem(of(attribute) + " \"" + *text + "\" must be one number");
  return otherwise;
}

std::optional<double> XmlElement::own_number() const {
  const char* text = element_->GetText();
  const std::vector<std::string_view> words = words_of(text ? text : "");
  if (words.empty()) return std::nullopt;
  return read_number(words.front(), "value");
}

double XmlElement::required_number(const char* attribute) const {
  if (!text_of(attribute)) problem(of(attribute) + " is missing");
  return number(attribute, 0.0);
}

Eigen::Vector3d XmlElement::vector(const char* attribute, const Eigen::Vector3d& otherwise) const {
  const std::optional<std::string> text = text_of(attribute);
  if (!text) return otherwise;
  const std::vector<std::string_view> words = words_of(*text);
  if (words.size() != 3) {
    problem(of(attribute) + " \"" + *text + "\" must be three numbers");
    return otherwise;
  }
  Eigen::Vector3d vector = otherwise;
  for (std::size_t i = 0; i < words.size(); ++i)
    vector(static_cast<Eigen::Index>(i)) =
        read_number(words[i], attribute).value_or(otherwise(static_cast<Eigen::Index>(i)));
  return vector;
}

std::optional<std::vector<double>> XmlElement::numbers(const char* attribute, std::size_t fewest,
                                                       std::size_t most) const {
  const std::optional<std::string> text = text_of(attribute);
  if (!text) return std::nullopt;
  const std::vector<std::string_view> words = words_of(*text);
  if (words.size() < fewest || words.size() > most) {
    const std::string wanted =
        fewest == most ? std::to_string(most) : std::to_string(fewest) + " to " + std::to_string(most);
    problem(of(attribute) + " has " + std::to_string(words.size()) + " numbers; it must have " + wanted);
    return std::nullopt;
  }
  std::vector<double> read;
  for (const std::string_view word : words) {
    const std::optional<double> number = read_number(word, attribute);
    if (!number) return std::nullopt;
    read.push_back(*number);
  }
  return read;
}

}  // namespace lacuna::robot_files
