#pragma once

#include "foundation/files/whole_file.h"

#include <filesystem>
#include <string>

namespace lacuna {

std::string read_text(const std::filesystem::path& file);

/// Called before work that ends with a `TextReplacement`: throws `BadInput` where the file or its folder may not be
/// written.
void check_replaceable(const std::filesystem::path& file);

/// Gives a user's file a new text at once: readers see the old text or the new one, also after a power cut. Permissions
/// stay; a symbolic link goes on pointing to its file.
class TextReplacement {
 public:
  /// Writes both texts to the disk beside the file, so that neither step below needs room. Throws `Error` where that
  /// fails.
  TextReplacement(const std::filesystem::path& file, std::string old_text, std::string new_text);

  /// Throws `Error` where the file does not have the old text any more (someone edited it meanwhile) or cannot be
  /// written; it is then as it was.
  void publish();
  /// Gives the file its old text back, if it was published and nobody has changed it since.
  void take_back();

 private:
  std::filesystem::path file_;
  std::string old_text_, new_text_;
  WholeFile new_, old_;
  bool published_ = false;
};

}  // namespace lacuna
