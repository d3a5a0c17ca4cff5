#include "xml_editing.h"

#include "xml_element.h"
#include "xml_writing.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>

namespace lacuna::robot_files {
namespace {

using tinyxml2::XMLAttribute;
using tinyxml2::XMLElement;
using tinyxml2::XMLNode;

constexpr const char* kBlanks = " \t\r\n";

/// End of the comment, instruction or declaration that begins at a place; nothing for an element.
std::optional<std::size_t> behind_no_element(std::string_view text, std::size_t at) {
  constexpr std::pair<std::string_view, std::string_view> kOthers[] = {
      {"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}};
  for (const auto& [begin, end] : kOthers)
    if (text.substr(at).starts_with(begin)) {
      const std::size_t found = text.find(end, at + begin.size());
      return found == text.npos ? text.size() : found + end.size();
    }
  return std::nullopt;
}

/// End of the tag that begins at a place; a text in quotes may contain its last character.
std::size_t behind_tag(std::string_view text, std::size_t at) {
  char quote = '\0';
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != '\0')
      quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == '>')
      return at + 1;
  }
  return text.size();
}

/// The place of an attribute in a start tag.
struct AttributeSpan {
  std::string name;
  std::size_t start = 0, value = 0, value_end = 0;
};

std::vector<AttributeSpan> attributes_of(const std::string& tag) {
  std::vector<AttributeSpan> spans;
  std::size_t at = tag.find_first_of(kBlanks);
  while (at != tag.npos && (at = tag.find_first_not_of(kBlanks, at)) != tag.npos) {
    const std::size_t equals = tag.find('=', at), quote = tag.find_first_of("\"'", at);
    if (equals == tag.npos || quote == tag.npos || equals > quote) break;
    const std::size_t name_end = tag.find_last_not_of(kBlanks, equals - 1) + 1, end = tag.find(tag[quote], quote + 1);
    if (end == tag.npos) break;
    spans.push_back({tag.substr(at, name_end - at), at, quote + 1, end});
    at = end + 1;
  }
  return spans;
}

std::string escaped(std::string_view value) {
  std::string text;
  for (const char c : value)
    text += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : c == '\'' ? "&apos;" : std::string(1, c);
  return text;
}

std::optional<double> number_of(std::string_view word) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() ? std::optional(value) : std::nullopt;
}

/// Whether two values are equal texts, or equal numbers, such as "1.50" and "1.5".
bool same_value(std::string_view a, std::string_view b) {
  if (a == b) return true;
  const std::vector<std::string_view> of_a = words_of(a), of_b = words_of(b);
  const auto same = [](std::string_view x, std::string_view y) { return number_of(x) && number_of(x) == number_of(y); };
  return std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), same);
}

bool same_elements(const XMLElement& a, const XMLElement& b) {
  if (std::string_view(a.Name()) != b.Name()) return false;
  std::size_t of_a = 0, of_b = 0;
  for (const XMLAttribute* one = a.FirstAttribute(); one; one = one->Next(), ++of_a)
    if (const char* other = b.Attribute(one->Name()); !other || !same_value(one->Value(), other)) return false;
  for (const XMLAttribute* one = b.FirstAttribute(); one; one = one->Next()) ++of_b;
  const XMLElement *child = a.FirstChildElement(), *other = b.FirstChildElement();
  for (; child && other; child = child->NextSiblingElement(), other = other->NextSiblingElement())
    if (!same_elements(*child, *other)) return false;
  return of_a == of_b && !child && !other;
}

/// Elements in the order of their start tags.
void collect(XMLElement* element, std::vector<XMLElement*>& all) {
  for (; element; element = element->NextSiblingElement()) {
    all.push_back(element);
    collect(element->FirstChildElement(), all);
  }
}

}  // namespace

std::vector<ElementSpan> elements_of(const std::string& text) {
  std::vector<ElementSpan> spans;
  std::vector<std::size_t> open;
  for (std::size_t at = text.find('<'); at != text.npos; at = text.find('<', at)) {
    if (const std::optional<std::size_t> behind = behind_no_element(text, at)) {
      at = *behind;
      continue;
    }
    const std::size_t end = behind_tag(text, at);
    if (text[at + 1] == '/') {
      if (open.empty()) return {};
      spans[open.back()].content_end = at;
      spans[open.back()].end = end;
      open.pop_back();
    } else {
      if (!open.empty()) spans[open.back()].children.push_back(spans.size());
      spans.push_back({at, end, end, end});
      if (text[end - 2] != '/') open.push_back(spans.size() - 1);
    }
    at = end;
  }
  return spans;
}

XmlEditing::XmlEditing(std::string text) : text_(std::move(text)), spans_(elements_of(text_)) {
  original_.Parse(text_.data(), text_.size());
  edited_.Parse(text_.data(), text_.size());
  collect(original_.RootElement(), originals_);
  std::vector<XMLElement*> now;
  collect(edited_.RootElement(), now);
  for (std::size_t i = 0; i < std::min(now.size(), spans_.size()); ++i) now[i]->SetUserData(&spans_[i]);
}

std::optional<std::size_t> XmlEditing::index_of(const XMLElement& element) const {
  const auto* span = static_cast<const ElementSpan*>(element.GetUserData());
  return span ? std::optional(static_cast<std::size_t>(span - spans_.data())) : std::nullopt;
}

std::string XmlEditing::indent_before(std::size_t place) const {
  const std::size_t line = place == 0 ? text_.npos : text_.rfind('\n', place - 1);
  if (line == text_.npos) return {};
  std::string blanks = text_.substr(line + 1, place - line - 1);
  return blanks.find_first_not_of(" \t") == blanks.npos ? blanks : std::string();
}

std::string XmlEditing::start_tag(const XMLElement& element, std::size_t index, bool has_content) const {
  const ElementSpan& span = spans_[index];
  const XMLElement& before = *originals_[index];
  std::string tag = text_.substr(span.start, span.content - span.start);
  const std::vector<AttributeSpan> written = attributes_of(tag);
  const std::size_t end = written.empty() ? 1 + std::string_view(before.Name()).size() : written.back().value_end + 1;
  std::string added;
  for (const XMLAttribute* one = element.FirstAttribute(); one; one = one->Next())
    if (!before.Attribute(one->Name())) added += std::string(" ") + one->Name() + "=\"" + escaped(one->Value()) + "\"";
  tag.insert(end, added);
  for (std::size_t i = written.size(); i-- > 0;) {
    const AttributeSpan& one = written[i];
    const char *now = element.Attribute(one.name.c_str()), *then = before.Attribute(one.name.c_str());
    const std::size_t blank = i == 0 ? 1 + std::string_view(before.Name()).size() : written[i - 1].value_end + 1;
    if (!now)
      tag.erase(blank, one.value_end + 1 - blank);
    else if (!then || !same_value(now, then))
      tag.replace(one.value, one.value_end - one.value, escaped(now));
  }
  tag.replace(1, std::string_view(before.Name()).size(), element.Name());
  if (has_content && tag.ends_with("/>")) {
    tag.erase(tag.find_last_not_of(kBlanks, tag.size() - 3) + 1);
    tag += '>';
  }
  return tag;
}

/// A new element on separate lines, indented one step further than its parent.
std::string XmlEditing::inserted(const XMLElement& element, const ElementSpan& parent) const {
  const std::string outer = indent_before(parent.start);
  const std::string indent = parent.children.empty() ? outer + "  " : indent_before(spans_[parent.children[0]].start);
  tinyxml2::XMLPrinter printer;
  element.Accept(&printer);
  std::string text = "\n" + std::string(printer.CStr());
  text.erase(text.find_last_not_of(kBlanks) + 1);
  for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1)) text.insert(at + 1, indent);
  return text;
}

std::string XmlEditing::content_text(const XMLElement& element, std::size_t index) const {
  const ElementSpan& span = spans_[index];
  std::map<std::size_t, const XMLElement*> kept;
  std::map<std::size_t, std::string> new_before;  // by the child that follows
  std::string waiting;
  for (const XMLElement* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) {
    const std::optional<std::size_t> known = index_of(*child);
    if (!known) {
      waiting += inserted(*child, span);
      continue;
    }
    kept[*known] = child;
    new_before[*known] = std::move(waiting);
    waiting.clear();
  }
  std::string text;
  std::size_t at = span.content;
  for (const std::size_t child : span.children) {
    std::string between = text_.substr(at, spans_[child].start - at);
    at = spans_[child].end;
    const auto found = kept.find(child);
    if (found == kept.end()) between.erase(between.find_last_not_of(kBlanks) + 1);
    text += found == kept.end() ? between : new_before[child] + between + element_text(*found->second);
  }
  text += waiting + text_.substr(at, span.content_end - at);
  if (span.end == span.content && !text.empty()) text += "\n" + indent_before(span.start);
  return text;
}

std::string XmlEditing::element_text(const XMLElement& element) const {
  const std::size_t index = *index_of(element);
  const ElementSpan& span = spans_[index];
  const std::string content = content_text(element, index);
  const bool has_end = span.end != span.content || !content.empty();
  return start_tag(element, index, has_end) + content +
         (has_end ? std::string("</") + element.Name() + ">" : std::string());
}

std::string XmlEditing::text(const std::string& comment) {
  const XMLElement* root = edited_.RootElement();
  if (root && spans_.size() == originals_.size() && index_of(*root)) {
    const ElementSpan& span = spans_.front();
    const std::string text =
        with_head_comment(text_.substr(0, span.start), comment) + element_text(*root) + text_.substr(span.end);
    tinyxml2::XMLDocument read;
    if (read.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS && same_elements(*read.RootElement(), *root))
      return text;
  }
  return text_of(edited_, comment);
}

}  // namespace lacuna::robot_files
