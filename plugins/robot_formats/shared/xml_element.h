#pragma once

#include <lacuna/robot_format.h>

#include <tinyxml2.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna::robot_files {

/// Words between spaces.
std::vector<std::string_view> words_of(std::string_view text);

/// Name of the outermost element of a text, found without reading the rest; empty: there is none.
std::string_view root_name(std::string_view text);

/// The text without XML declarations that are not at its beginning, as after a comment, where they are not allowed;
/// blanks keep the lines.
std::string without_late_declarations(std::string text);

/// The line of text after the outermost element of a document, where none is allowed; 0: there is none.
int line_behind_root(const tinyxml2::XMLDocument& document);

/// An element of a document, whose attributes are read strictly: text that is not a number is a problem, not 0.
class XmlElement {
 public:
  /// `file` is the included file that contains it, null: the main file; it and `problems` outlive the element.
  XmlElement(const tinyxml2::XMLElement& element, std::vector<RobotFileProblem>& problems,
             const std::string* file = nullptr)
      : element_(&element), problems_(&problems), file_(file) {}

  int line() const { return element_->GetLineNum(); }
  std::string file() const { return file_ ? *file_ : std::string(); }
  std::string_view name() const { return element_->Name(); }
  const tinyxml2::XMLElement& xml() const { return *element_; }

  /// The first child of that name; null: there is none.
  std::optional<XmlElement> child(const char* name) const;
  std::vector<XmlElement> children(const char* name) const;
  std::vector<XmlElement> children() const;

  /// Nothing where it is missing.
  std::optional<std::string> text_of(const char* attribute) const;
  std::string required_text(const char* attribute) const;
  /// Finite; `otherwise` where it is missing, or is not a number, which is a problem.
  double number(const char* attribute, double otherwise) const;
  /// A problem where it is missing.
  double required_number(const char* attribute) const;
  /// Three numbers between spaces.
  Eigen::Vector3d vector(const char* attribute, const Eigen::Vector3d& otherwise) const;
  /// `fewest` to `most` numbers between spaces; nothing where it is missing or wrong, which is a problem.
  std::optional<std::vector<double>> numbers(const char* attribute, std::size_t fewest, std::size_t most) const;

  /// The number between its tags; nothing where there is no text, or no number, which is a problem.
  std::optional<double> own_number() const;

  void problem(std::string text) const { problems_->push_back({line(), std::move(text), file()}); }

 private:
  std::string of(const char* attribute) const;
  std::optional<double> read_number(std::string_view word, const char* attribute) const;

  const tinyxml2::XMLElement* element_;
  std::vector<RobotFileProblem>* problems_;
  const std::string* file_;
};

}  // namespace lacuna::robot_files
