#pragma once

#include "config/schema/shape.h"

#include <string>

namespace lacuna {

/// What a reference says beside the keys.
struct ReferenceHead {
  std::string title;
  std::string introduction;  ///< paragraphs in Markdown
  std::string regenerate;    ///< the command that writes the page again
};

/// A page in Markdown with one section a table and one row a key.
std::string markdown_reference(const Shape& file, const ReferenceHead& head);

/// A JSON Schema (draft 2020-12) of the file, for editors. It accepts all that the reader accepts;
/// units, files and what concerns several keys at once are the reader's alone.
std::string json_schema(const Shape& file, const std::string& title);

}  // namespace lacuna
