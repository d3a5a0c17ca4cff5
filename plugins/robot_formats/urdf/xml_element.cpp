#include "xml_element.h"

#include <charconv>
#include <cmath>

namespace lacuna::urdf {
namespace {

constexpr const char* kSpaces = " \t\r\n";

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(kSpaces); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSpaces, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(kSpaces, end);
  }
  return words;
}

}  // namespace

std::optional<XmlElement> XmlElement::child(const char* name) const {
  const tinyxml2::XMLElement* found = element_->FirstChildElement(name);
  return found ? std::optional(XmlElement(*found, *problems_)) : std::nullopt;
}

std::vector<XmlElement> XmlElement::children(const char* name) const {
  std::vector<XmlElement> all;
  for (const tinyxml2::XMLElement* one = element_->FirstChildElement(name); one; one = one->NextSiblingElement(name))
    all.emplace_back(*one, *problems_);
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
  problem(of(attribute) + " \"" + std::string(written) + "\" is no number; write one such as 1.5");
  return std::nullopt;
}

double XmlElement::number(const char* attribute, double otherwise) const {
  const std::optional<std::string> text = text_of(attribute);
  if (!text) return otherwise;
  const std::vector<std::string_view> words = words_of(*text);
  if (words.size() == 1) return read_number(words.front(), attribute).value_or(otherwise);
  problem(of(attribute) + " \"" + *text + "\" is to be one number");
  return otherwise;
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
    problem(of(attribute) + " \"" + *text + "\" is to be three numbers");
    return otherwise;
  }
  Eigen::Vector3d vector = otherwise;
  for (std::size_t i = 0; i < words.size(); ++i)
    vector(static_cast<Eigen::Index>(i)) =
        read_number(words[i], attribute).value_or(otherwise(static_cast<Eigen::Index>(i)));
  return vector;
}

}  // namespace lacuna::urdf
