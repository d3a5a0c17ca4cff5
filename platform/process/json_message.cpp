#include "process/json_message.h"

#include "foundation/text/json_depth.h"
#include "process/quoted_text.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr std::size_t kLongestReason = 500;  // bytes, of what a program says in an error

constexpr const char* kOnlyMessages =
    "; its standard output may contain only messages, each a JSON object on a separate line; write everything else to "
    "standard error";

/// Python and others write these for NaN and infinity; they are not JSON.
bool has_no_number(const std::string& line) {
  return line.find("NaN") != std::string::npos || line.find("Infinity") != std::string::npos;
}

/// Beyond what a double holds, as 1e400.
bool has_too_large_number(const std::string& line) {
  try {
    [[maybe_unused]] const nlohmann::json read = nlohmann::json::parse(line);
    return false;
  } catch (const nlohmann::json::out_of_range&) {
    return true;
  } catch (const nlohmann::json::exception&) {
    return false;
  }
}

nlohmann::json parsed(const std::string& line) {
  if (nests_too_deep(line))
    throw Error(fmt::format("sent a line that nests arrays and objects more than {} levels deep, {}", kDeepestJson,
                            quoted_text(line)) +
                kOnlyMessages);
  nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
  if (json.is_discarded() && has_no_number(line))
    throw Error("sent NaN or Infinity, " + quoted_text(line) +
                "; correct this value, and send null for a missing reading");
  if (json.is_discarded() && has_too_large_number(line))
    throw Error("sent a number that is too large for a double, " + quoted_text(line) +
                "; send null for a missing reading");
  if (!json.is_object()) throw Error("sent a line that is not a JSON object, " + quoted_text(line) + kOnlyMessages);
  return json;
}

}  // namespace

JsonMessage::JsonMessage(const std::string& line, const std::string& type) : JsonMessage(line, type, std::nullopt) {}

JsonMessage::JsonMessage(const std::string& line, const std::string& type, std::uint64_t id)
    : JsonMessage(line, type, std::optional(id)) {}

JsonMessage::JsonMessage(const std::string& line, const std::string& type, std::optional<std::uint64_t> id)
    : type_(type), json_(parsed(line)) {
  if (id) check_id(*id);
  const nlohmann::json* own = find("type");
  if (own == nullptr || !own->is_string()) throw Error("sent a message without \"type\", " + quoted_text(line));
  const std::string given = own->get<std::string>();
  if (given == "error") {
    const nlohmann::json* message = find("message");
    const std::string reason = message && message->is_string() ? message->get<std::string>() : line;
    throw RefusedTest("says: " + plain_text(reason, kLongestReason));
  }
  if (given != type)
    throw Error(fmt::format("sent a message of type {} instead of type \"{}\"", quoted_text(given), type));
  if (id && find("id") == nullptr)
    add_fault(R"("id" is missing, the number of the test; repeat the "id" of the test's message in each answer to it)");
}

void JsonMessage::check_id(std::uint64_t id) {
  const nlohmann::json* given = find("id");
  if (given == nullptr || *given == id) return;
  throw Error(fmt::format(
      "answered with \"id\" {} instead of {}; answer each test once, before the next one, and repeat the test's \"id\"",
      quoted_text(given->dump()), id));
}

const nlohmann::json* JsonMessage::find(const std::string& name) const {
  const auto found = json_.find(name);
  return found == json_.end() ? nullptr : &*found;
}

const nlohmann::json* JsonMessage::need(const std::string& name, const std::string& meaning) {
  const nlohmann::json* found = find(name);
  if (found == nullptr) add_fault(fmt::format("\"{}\" is missing, {}", name, meaning));
  return found;
}

std::string JsonMessage::text(const std::string& name, const std::string& meaning) {
  const nlohmann::json* found = need(name, meaning);
  if (found == nullptr) return {};
  if (found->is_string() && !found->get<std::string>().empty()) return plain_text(found->get<std::string>());
  add_fault(fmt::format("\"{}\" is not {}", name, meaning));
  return {};
}

double JsonMessage::number(const std::string& name, const std::string& meaning) {
  const nlohmann::json* found = need(name, meaning);
  if (found == nullptr) return std::numeric_limits<double>::quiet_NaN();
  if (found->is_number() && std::isfinite(found->get<double>())) return found->get<double>();
  add_fault(fmt::format("\"{}\" is not {}", name, meaning));
  return std::numeric_limits<double>::quiet_NaN();
}

void JsonMessage::throw_if_faulty() const {
  if (faults_.empty()) return;
  throw Error(fmt::format("sent a wrong message of type \"{}\": {}", type_, fmt::join(faults_, "; ")));
}

}  // namespace lacuna
