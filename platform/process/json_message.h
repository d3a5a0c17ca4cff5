#pragma once

#include <lacuna/error.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// Thrown where a test is not carried out and nothing is wrong with the program: it says that it cannot, or the test is
/// none for it.
class RefusedTest : public Error {
 public:
  using Error::Error;
};

/// A message of the protocol "lacuna-process/2" (docs/reference/process-target.md) as it came: an object a line. Faults
/// are collected while its members are read, so that all of them are told at once. What is thrown continues "the
/// program ...".
class JsonMessage {
 public:
  /// Throws `Error` where the line is no JSON object or no message of this type, `RefusedTest` where it is one of
  /// type "error".
  JsonMessage(const std::string& line, const std::string& type);
  /// The same for the answer to a test, whose `id` it must repeat: what it answers to another test, late or a second
  /// time, is thrown as an `Error`, whatever its type. An error may come without.
  JsonMessage(const std::string& line, const std::string& type, std::uint64_t id);

  /// A member; null if it is missing.
  const nlohmann::json* find(const std::string& name) const;
  /// The same; a missing member is a fault.
  const nlohmann::json* need(const std::string& name, const std::string& meaning);
  /// Fit to be printed (`plain_text`).
  std::string text(const std::string& name, const std::string& meaning);
  double number(const std::string& name, const std::string& meaning);

  void add_fault(const std::string& fault) { faults_.push_back(fault); }
  /// Throws `Error` with all faults, if there are any.
  void throw_if_faulty() const;

 private:
  JsonMessage(const std::string& line, const std::string& type, std::optional<std::uint64_t> id);
  void check_id(std::uint64_t id);

  std::string type_;
  nlohmann::json json_;
  std::vector<std::string> faults_;
};

}  // namespace lacuna
