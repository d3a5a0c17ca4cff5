#pragma once

#include <tinyxml2.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lacuna::robot_files {

/// The place of an element in a text.
struct ElementSpan {
  std::size_t start = 0;                   ///< of its start tag
  std::size_t content = 0;                 ///< after its start tag
  std::size_t content_end = 0, end = 0;    ///< of its end tag; without one both are `content`
  std::vector<std::size_t> children = {};  ///< indices, in the order of the text
};

/// The elements of a well-formed text, each before its children.
std::vector<ElementSpan> elements_of(const std::string& text);

/// A text whose elements are edited in a document, and the text again, in which everything else stays as it was:
/// blanks, order and quotes of attributes, comments.
class XmlEditing {
 public:
  /// The text must be well-formed.
  explicit XmlEditing(std::string text);
  XmlEditing(const XmlEditing&) = delete;
  XmlEditing& operator=(const XmlEditing&) = delete;

  /// Attributes may be set and deleted, elements inserted, deleted and renamed.
  tinyxml2::XMLDocument& document() { return edited_; }
  /// With `comment` before its root, replacing one of an earlier export. Where the text cannot be edited in this way it
  /// is printed anew, with the same elements.
  std::string text(const std::string& comment);

 private:
  /// For the span of an element that was there before; none: it is new.
  std::optional<std::size_t> index_of(const tinyxml2::XMLElement& element) const;
  std::string element_text(const tinyxml2::XMLElement& element) const;
  std::string start_tag(const tinyxml2::XMLElement& element, std::size_t index, bool has_content) const;
  std::string content_text(const tinyxml2::XMLElement& element, std::size_t index) const;
  std::string inserted(const tinyxml2::XMLElement& element, const ElementSpan& parent) const;
  /// The blanks before a place, back to the end of the line before; empty where other text precedes it.
  std::string indent_before(std::size_t place) const;

  std::string text_;
  std::vector<ElementSpan> spans_;
  tinyxml2::XMLDocument original_, edited_;
  std::vector<tinyxml2::XMLElement*> originals_;  ///< as `spans_`
};

}  // namespace lacuna::robot_files
