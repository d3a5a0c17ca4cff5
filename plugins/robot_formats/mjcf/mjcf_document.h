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

/// An MJCF file with all that it includes. Elements are those of this document and live as long as it does.
class Document {
 public:
  /// Files are looked for from the folder of the main file on, then from that of the file that includes them. One that
  /// is included twice, which a cycle would be, is a problem, as MuJoCo has it.
  Document(const RobotText& file, std::vector<RobotFileProblem>& problems);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  /// What stands in an element, or of these what has the name; in place of an <include> what stands in its file.
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
