#pragma once

#include "xml_element.h"

#include <lacuna/robot_format.h>

#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace lacuna::mjcf {

using robot_files::XmlElement;

/// An MJCF file with all of its included files. Elements belong to this document and live as long as it does.
class Document {
 public:
  /// Files are searched in the folder of the main file, then in that of the file that includes them. A file that is
  /// included twice, including a cycle, is a problem, as in MuJoCo.
  Document(const RobotText& file, std::vector<RobotFileProblem>& problems);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  /// The children of an element, or those with the name; an <include> is replaced by the content of its file.
  std::vector<XmlElement> children(const XmlElement& element, std::string_view name = {}) const;

  /// What stands in all sections of that name below <mujoco>. None in a document with problems.
  std::vector<XmlElement> sections(std::string_view name) const;
  std::vector<XmlElement> sections() const;

  const XmlElement& root() const { return root_.value(); }
  bool is_whole() const { return root_.has_value(); }

 private:
  struct Part {
    tinyxml2::XMLDocument xml;
    std::string name;  ///< empty: the main file
  };

  const tinyxml2::XMLElement* parse(const std::string& text, const std::string& name);
  void read_includes(const XmlElement& element, std::size_t depth);
  void include(const XmlElement& element, std::size_t depth);
  void add_children(const XmlElement& element, std::string_view name, std::vector<XmlElement>& all) const;

  const RobotText& file_;
  std::vector<RobotFileProblem>& problems_;
  std::deque<Part> parts_;
  std::optional<XmlElement> root_;
  std::set<std::string> names_;                                        ///< of included files
  std::map<const tinyxml2::XMLElement*, XmlElement> root_of_include_;  ///< by the <include>
};

}  // namespace lacuna::mjcf
