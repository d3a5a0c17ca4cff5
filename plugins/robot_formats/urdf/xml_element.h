#pragma once

#include <lacuna/robot_format.h>

#include <tinyxml2.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna::urdf {

/// An element of a document, whose attributes are read strictly: what is no number is a problem, not 0.
class XmlElement {
 public:
  XmlElement(const tinyxml2::XMLElement& element, std::vector<RobotFileProblem>& problems)
      : element_(&element), problems_(&problems) {}

  int line() const { return element_->GetLineNum(); }
  std::string_view name() const { return element_->Name(); }

  /// The first child of that name; null: there is none.
  std::optional<XmlElement> child(const char* name) const;
  std::vector<XmlElement> children(const char* name) const;
  std::vector<XmlElement> children() const;

  /// Nothing where it is not written.
  std::optional<std::string> text_of(const char* attribute) const;
  std::string required_text(const char* attribute) const;
  /// Finite; `otherwise` where it is not written, or is no number, which is a problem.
  double number(const char* attribute, double otherwise) const;
  /// A problem where it is not written.
  double required_number(const char* attribute) const;
  /// Three numbers between spaces.
  Eigen::Vector3d vector(const char* attribute, const Eigen::Vector3d& otherwise) const;

  void problem(std::string text) const { problems_->push_back({line(), std::move(text)}); }

 private:
  std::string of(const char* attribute) const;
  std::optional<double> read_number(std::string_view word, const char* attribute) const;

  const tinyxml2::XMLElement* element_;
  std::vector<RobotFileProblem>* problems_;
};

}  // namespace lacuna::urdf
