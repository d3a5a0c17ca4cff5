#pragma once

#include "mat_element.h"

#include <cstdint>
#include <string>

namespace lacuna::mat {

/// An array of numbers in a file: a variable or a field of one.
struct MatArray {
  std::string path;  ///< "q", "log.q"
  std::uint64_t rows = 0, columns = 0;
};

/// Receives the arrays of a file.
class MatVisitor {
 public:
  virtual ~MatVisitor() = default;
  /// Whether the numbers of this array are requested; they follow, column by column.
  virtual bool begin_array(const MatArray& array) = 0;
  virtual void take_number(std::uint64_t index, LongNumber number) = 0;
  /// A variable that is not an array of numbers: "log.label", "is text".
  virtual void leave_out(const std::string& path, const std::string& reason) = 0;
};

/// Visits all variables of a file of version 5 (MATLAB 5 to 7.2 and `save -v7`). Throws `BadFile`.
void visit_variables(const std::string& path, MatVisitor& visitor);

}  // namespace lacuna::mat
