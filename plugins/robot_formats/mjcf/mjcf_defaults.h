#pragma once

#include "mjcf_document.h"

#include <map>
#include <string>
#include <vector>

namespace lacuna::mjcf {

/// An element with the defaults of its class: a missing attribute comes from the nearest class that has it.
class Attributes {
 public:
  Attributes(XmlElement element, std::vector<XmlElement> defaults)
      : element_(element), defaults_(std::move(defaults)) {}

  const XmlElement& element() const { return element_; }
  bool has(const char* attribute) const { return source_of(attribute).text_of(attribute).has_value(); }
  /// Whether the element has the attribute.
  bool says(const char* attribute) const { return element_.text_of(attribute).has_value(); }

  std::optional<std::string> text_of(const char* attribute) const { return source_of(attribute).text_of(attribute); }
  double number(const char* attribute, double otherwise) const {
    return source_of(attribute).number(attribute, otherwise);
  }
  Eigen::Vector3d vector(const char* attribute, const Eigen::Vector3d& otherwise) const {
    return source_of(attribute).vector(attribute, otherwise);
  }
  std::optional<std::vector<double>> numbers(const char* attribute, std::size_t fewest, std::size_t most) const {
    return source_of(attribute).numbers(attribute, fewest, most);
  }
  /// "true" or "false"; `otherwise` where it is missing, "auto", or neither, which is a problem.
  bool flag(const char* attribute, bool otherwise) const;

 private:
  const XmlElement& source_of(const char* attribute) const;

  XmlElement element_;
  std::vector<XmlElement> defaults_;  ///< the nearest class first
};

/// The <default> classes of a document. A class inherits from the enclosing one and overrides it.
class DefaultClasses {
 public:
  explicit DefaultClasses(const Document& document);

  /// The element with the defaults for its name or one of `also`: those of the class that it names, else of
  /// `childclass`, else of the main class. An unknown class is a problem.
  Attributes of(const XmlElement& element, const std::string& childclass,
                const std::vector<std::string_view>& also = {}) const;

  bool has(const std::string& name) const { return classes_.contains(name); }

 private:
  struct Class {
    std::string around;  ///< empty: none
    std::vector<XmlElement> elements;
  };
  void read(const Document& document, const XmlElement& element, const std::string& around);

  std::map<std::string, Class> classes_;
};

}  // namespace lacuna::mjcf
