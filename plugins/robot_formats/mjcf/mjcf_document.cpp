#include "mjcf_document.h"

namespace lacuna::mjcf {
namespace {

constexpr std::size_t kDeepestInclude = 10;

std::string folder_of(const std::string& file) {
  const std::size_t slash = file.rfind('/');
  return slash == std::string::npos ? "" : file.substr(0, slash + 1);
}

}  // namespace

Document::Document(const RobotText& file, std::vector<RobotFileProblem>& problems) : file_(file), problems_(problems) {
  const tinyxml2::XMLElement* root = parse(file.text, "");
  if (root == nullptr) return;
  if (std::string_view(root->Name()) != "mujoco") {
    problems_.push_back({root->GetLineNum(), "is not MJCF: its root is not <mujoco>", {}});
    return;
  }
  root_.emplace(*root, problems_);
  read_includes(*root_, 0);
}

const tinyxml2::XMLElement* Document::parse(const std::string& text, const std::string& name) {
  Part& part = parts_.emplace_back();
  part.name = name;
  const std::string readable = robot_files::without_late_declarations(text);
  part.xml.Parse(readable.data(), readable.size());
  if (const int line = robot_files::line_behind_root(part.xml); !part.xml.Error() && line > 0) {
    problems_.push_back({line, "text follows the outermost element; remove it", name});
    return nullptr;
  }
  if (!part.xml.Error() && part.xml.RootElement() != nullptr) return part.xml.RootElement();
  problems_.push_back({part.xml.ErrorLineNum(),
                       std::string("is not a complete XML document (") + part.xml.ErrorName() +
                           "); is it incomplete, nested deeper than 100 elements, or in another format?",
                       name});
  return nullptr;
}

void Document::read_includes(const XmlElement& element, std::size_t depth) {
  for (const XmlElement& child : element.children())
    if (child.name() == "include")
      include(child, depth + 1);
    else
      read_includes(child, depth);
}

void Document::include(const XmlElement& element, std::size_t depth) {
  const std::string path = element.required_text("file");
  if (path.empty()) return;
  if (depth > kDeepestInclude) return element.problem("files include each other deeper than 10 levels");
  for (const std::string& name : {path, folder_of(element.file()) + path}) {
    const std::optional<std::string> text = file_.beside ? file_.beside->text_of(name) : std::nullopt;
    if (!text) continue;
    if (name == file_.name || !names_.insert(name).second)
      return element.problem("include's file \"" + path +
                             "\" is already a part of this model; a file can be included only once");
    const tinyxml2::XMLElement* root = parse(*text, name);
    if (root == nullptr) return;
    const XmlElement part(*root, problems_, &parts_.back().name);
    root_of_include_.emplace(&element.xml(), part);
    return read_includes(part, depth);
  }
  element.problem("include's file \"" + path +
                  "\" is not in the folder of the robot file or below it; files elsewhere are not read; put it there");
}

void Document::add_children(const XmlElement& element, std::string_view name, std::vector<XmlElement>& all) const {
  for (const XmlElement& child : element.children())
    if (const auto included = root_of_include_.find(&child.xml()); included != root_of_include_.end())
      add_children(included->second, name, all);
    else if (child.name() != "include" && (name.empty() || child.name() == name))
      all.push_back(child);
}

std::vector<XmlElement> Document::children(const XmlElement& element, std::string_view name) const {
  std::vector<XmlElement> all;
  add_children(element, name, all);
  return all;
}

std::vector<XmlElement> Document::sections() const { return is_whole() ? children(root()) : std::vector<XmlElement>(); }

std::vector<XmlElement> Document::sections(std::string_view name) const {
  std::vector<XmlElement> all;
  for (const XmlElement& section : sections())
    if (section.name() == name) add_children(section, {}, all);
  return all;
}

}  // namespace lacuna::mjcf
