#include "xml_writing.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace lacuna::robot_files {
namespace {

/// Identifies a comment of an earlier export, which is replaced.
constexpr const char* kMark = "Identified by Lacuna";

}  // namespace

std::string number_text(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string numbers_text(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + number_text(value);
  return text;
}

std::string vector_text(const Eigen::Vector3d& vector) { return numbers_text({vector.x(), vector.y(), vector.z()}); }

std::string comment_text(const std::string& text) {
  std::string safe;
  for (const char c : text)
    safe += c == '-' && !safe.empty() && safe.back() == '-' ? std::string(" -") : std::string(1, c);
  return safe;
}

tinyxml2::XMLElement& child_of(tinyxml2::XMLElement& parent, const char* name) {
  if (tinyxml2::XMLElement* child = parent.FirstChildElement(name)) return *child;
  return *parent.InsertNewChildElement(name);
}

std::string with_head_comment(std::string head, const std::string& comment) {
  constexpr std::string_view kBegin = "<!--", kEnd = "-->";
  for (std::size_t at = head.find(kBegin); at != head.npos; at = head.find(kBegin, at)) {
    std::size_t end = std::min(head.find(kEnd, at), head.size() - kEnd.size()) + kEnd.size();
    if (head.substr(at, end - at).find(kMark) == head.npos) {
      at = end;
      continue;
    }
    if (end < head.size() && head[end] == '\n') ++end;
    head.erase(at, end - at);
  }
  return comment.empty() ? head : head + "<!--" + comment_text("\n" + comment) + "-->\n";
}

std::string text_of(tinyxml2::XMLDocument& document, const std::string& comment) {
  tinyxml2::XMLElement* root = document.RootElement();
  for (tinyxml2::XMLNode* node = document.FirstChild(); node != nullptr;) {
    tinyxml2::XMLNode* next = node->NextSibling();
    if (node->ToComment() && std::string(node->Value()).find(kMark) != std::string::npos) document.DeleteNode(node);
    node = next;
  }
  if (!comment.empty()) {
    tinyxml2::XMLComment* head = document.NewComment(comment_text("\n" + comment).c_str());
    tinyxml2::XMLNode* before = root->PreviousSibling();
    if (before)
      document.InsertAfterChild(before, head);
    else
      document.InsertFirstChild(head);
  }
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace lacuna::robot_files
