#include "storage/core/bounded_functions.h"

#include <sqlite3.h>

#include <algorithm>
#include <cstring>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

/// The callbacks of SQLite's interface for functions; no exception may leave them.
namespace lacuna {
namespace {

/// Empty where there is no memory for it.
std::string_view view_of(const void* first, sqlite3_value* value) {
  return {static_cast<const char*>(first), first == nullptr ? 0 : static_cast<std::size_t>(sqlite3_value_bytes(value))};
}

std::string_view text_of(sqlite3_value* value) { return view_of(sqlite3_value_text(value), value); }

bool any_null(int count, sqlite3_value** values) {
  return std::any_of(values, values + count,
                     [](sqlite3_value* value) { return sqlite3_value_type(value) == SQLITE_NULL; });
}

const char* find(std::string_view in, std::string_view what) {
  return static_cast<const char*>(memmem(in.data(), in.size(), what.data(), what.size()));  // linear
}

bool begins_character(char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U; }

void instr(sqlite3_context* context, int count, sqlite3_value** values) {
  if (any_null(count, values)) return;
  const bool blobs = sqlite3_value_type(values[0]) == SQLITE_BLOB && sqlite3_value_type(values[1]) == SQLITE_BLOB;
  const auto bytes = [&](sqlite3_value* value) {
    return blobs ? view_of(sqlite3_value_blob(value), value) : text_of(value);
  };
  const std::string_view in = bytes(values[0]), what = bytes(values[1]);
  if (what.empty()) return sqlite3_result_int(context, 1);
  const char* const at = in.empty() ? nullptr : find(in, what);
  if (at == nullptr) return sqlite3_result_int(context, 0);
  const auto before = blobs ? at - in.data() : std::count_if(in.data(), at, begins_character);
  sqlite3_result_int64(context, before + 1);
}

std::size_t longest_text(sqlite3_context* context) {
  return static_cast<std::size_t>(sqlite3_limit(sqlite3_context_db_handle(context), SQLITE_LIMIT_LENGTH, -1));
}

void replace(sqlite3_context* context, int count, sqlite3_value** values) {
  if (any_null(count, values)) return;
  std::string_view in = text_of(values[0]);
  const std::string_view what = text_of(values[1]), with = text_of(values[2]);
  if (in.empty() || what.empty() || what.front() == '\0') return sqlite3_result_value(context, values[0]);
  const std::size_t most = longest_text(context);
  std::string made;
  try {
    for (const char* at = find(in, what); at != nullptr; at = find(in, what)) {
      made.append(in.data(), at).append(with);
      in.remove_prefix(static_cast<std::size_t>(at - in.data()) + what.size());
      if (made.size() > most) return sqlite3_result_error_toobig(context);
    }
    made.append(in);
  } catch (const std::exception&) {
    return sqlite3_result_error_nomem(context);
  }
  if (made.size() > most) return sqlite3_result_error_toobig(context);
  sqlite3_result_text64(context, made.data(), made.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
}

std::vector<std::string_view> characters(std::string_view text) {
  std::vector<std::string_view> found;
  while (!text.empty()) {
    std::size_t size = 1;
    while (size < text.size() && !begins_character(text[size])) ++size;
    found.push_back(text.substr(0, size));
    text.remove_prefix(size);
  }
  return found;
}

template <bool Left, bool Right>
void trim(sqlite3_context* context, int count, sqlite3_value** values) try {
  if (any_null(count, values)) return;
  std::string_view text = text_of(values[0]);
  const std::string_view taken = count > 1 ? text_of(values[1]) : std::string_view(" ");
  constexpr std::size_t kMostBytes = std::size_t{4} * kMostTrimmed;
  if (taken.size() > kMostBytes)
    return sqlite3_result_error(context, "trim: too many characters; at most 64 are allowed", -1);
  const std::vector<std::string_view> set = characters(taken);
  const auto strip = [&](auto matches, auto remove) {
    for (bool any = true; any && !text.empty();) {
      const auto found = std::find_if(set.begin(), set.end(), matches);
      any = found != set.end();
      if (any) remove(found->size());
    }
  };
  if constexpr (Left)
    strip([&](std::string_view c) { return text.starts_with(c); }, [&](std::size_t n) { text.remove_prefix(n); });
  if constexpr (Right)
    strip([&](std::string_view c) { return text.ends_with(c); }, [&](std::size_t n) { text.remove_suffix(n); });
  sqlite3_result_text64(context, text.empty() ? "" : text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
} catch (const std::exception&) {
  sqlite3_result_error_nomem(context);
}

/// Whether a format repeats a character more than `most` times: `%.5c`, or `%.*c` with the number among the values.
bool repeats_too_often(std::string_view format, int count, sqlite3_value** values, std::size_t most) {
  int next = 1;
  for (std::size_t at = format.find('%'); at != std::string_view::npos; at = format.find('%', at)) {
    std::uint64_t number = 0;  // the last one: the precision, where there is one
    bool precision = false;
    for (++at; at < format.size(); ++at) {
      const char c = format[at];
      if (c == '.') precision = true;
      if (c == '.') number = 0;
      if (c >= '0' && c <= '9')
        number = std::min<std::uint64_t>(number * 10 + static_cast<std::uint64_t>(c - '0'), most + 1);
      if (c == '*') {
        const double given = next < count ? std::abs(sqlite3_value_double(values[next])) : 0.0;
        number = given > static_cast<double>(most) ? most + 1 : static_cast<std::uint64_t>(given);
        ++next;
      }
      if (std::strchr("-+ 0#!,.*123456789l", c) == nullptr) break;
    }
    if (at >= format.size()) return false;
    if (format[at] == 'c' && precision && number > most) return true;
    if (format[at] != '%') ++next;
    ++at;
  }
  return false;
}

/// SQLite's own function, asked through a connection that has it.
void print(sqlite3_context* context, int count, sqlite3_value** values) {
  if (count == 0 || any_null(1, values)) return;
  if (repeats_too_often(text_of(values[0]), count, values, longest_text(context)))
    return sqlite3_result_error_toobig(context);
  constexpr std::string_view kBegin = "SELECT printf(?";
  std::array<char, 512> question{};  // longer than with the 127 arguments that a function may have
  char* end = std::copy(kBegin.begin(), kBegin.end(), question.begin());
  for (int i = 1; i < count; ++i) end = std::copy_n(",?", 2, end);
  *end = ')';
  sqlite3* const plain = static_cast<sqlite3*>(sqlite3_user_data(context));
  sqlite3_limit(plain, SQLITE_LIMIT_LENGTH, static_cast<int>(longest_text(context)));
  sqlite3_stmt* statement = nullptr;
  int result = sqlite3_prepare_v2(plain, question.data(), -1, &statement, nullptr);
  for (int i = 0; result == SQLITE_OK && i < count; ++i) result = sqlite3_bind_value(statement, i + 1, values[i]);
  if (result == SQLITE_OK && sqlite3_step(statement) == SQLITE_ROW)
    sqlite3_result_value(context, sqlite3_column_value(statement, 0));
  else
    sqlite3_result_error_code(context, sqlite3_errcode(plain));
  sqlite3_finalize(statement);
}

void close_plain(void* plain) { sqlite3_close(static_cast<sqlite3*>(plain)); }

/// Without the memory for another connection there is no such function.
void add_print(sqlite3* handle, const char* name) {
  sqlite3* plain = nullptr;
  sqlite3_open(":memory:", &plain);
  sqlite3_create_function_v2(handle, name, -1, SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_INNOCUOUS, plain, &print,
                             nullptr, nullptr, &close_plain);
}

using Function = void (*)(sqlite3_context*, int, sqlite3_value**);

void add(sqlite3* handle, const char* name, int arguments, Function function) {
  sqlite3_create_function_v2(handle, name, arguments, SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_INNOCUOUS, nullptr,
                             function, nullptr, nullptr, nullptr);
}

}  // namespace

void add_bounded_functions(sqlite3* handle) {
  add(handle, "instr", 2, &instr);
  add(handle, "replace", 3, &replace);
  for (const int arguments : {1, 2}) {
    add(handle, "trim", arguments, &trim<true, true>);
    add(handle, "ltrim", arguments, &trim<true, false>);
    add(handle, "rtrim", arguments, &trim<false, true>);
  }
  add_print(handle, "printf");
  add_print(handle, "format");
}

}  // namespace lacuna
