#pragma once

#include <lacuna/robot_spec.h>

#include <tinyxml2.h>

#include <initializer_list>
#include <string>

namespace lacuna::robot_files {

/// The shortest text that reads back as the same number; numbers with spaces between them.
std::string number_text(double value);
std::string numbers_text(std::initializer_list<double> values);
std::string vector_text(const Eigen::Vector3d& vector);

/// `text` without the characters that end an XML comment.
std::string comment_text(const std::string& text);

/// The child of that name, made where there is none.
tinyxml2::XMLElement& child_of(tinyxml2::XMLElement& parent, const char* name);

/// The part before the root of a document, with `comment` at its end, replacing one of an earlier export.
std::string with_head_comment(std::string head, const std::string& comment);

/// The document as text, with `comment` before its root.
std::string text_of(tinyxml2::XMLDocument& document, const std::string& comment);

}  // namespace lacuna::robot_files
