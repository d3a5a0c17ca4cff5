#include "storage/page_database.h"

#include "foundation/counted.h"
#include "storage/page_copy.h"
#include "storage/query.h"
#include "storage/storage_error.h"
#include "storage/trace_codec.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <sqlite3.h>

#include <cstring>
#include <memory>

namespace lacuna {
namespace {

constexpr const char* kTables = R"sql(
CREATE TABLE page_about (position INTEGER PRIMARY KEY, name TEXT NOT NULL, value TEXT NOT NULL) STRICT;
CREATE TABLE page_note (position INTEGER PRIMARY KEY, sentence TEXT NOT NULL) STRICT;
CREATE TABLE page_view (position INTEGER PRIMARY KEY, name TEXT NOT NULL, sentence TEXT NOT NULL, example TEXT NOT NULL)
  STRICT;
CREATE TABLE page_replay (
  id INTEGER PRIMARY KEY, experiment TEXT NOT NULL, run INTEGER NOT NULL, trial INTEGER NOT NULL, pass INTEGER NOT NULL,
  model INTEGER NOT NULL, robot TEXT NOT NULL, target_robot TEXT NOT NULL, UNIQUE (run, trial, model)) STRICT;
CREATE TABLE page_replay_trace (
  replay INTEGER NOT NULL REFERENCES page_replay (id), kind TEXT NOT NULL, channels TEXT NOT NULL,
  sample_count INTEGER NOT NULL, precision TEXT NOT NULL, times BLOB NOT NULL, samples BLOB NOT NULL,
  PRIMARY KEY (replay, kind)) STRICT;
)sql";

constexpr const char* kSamplesExample =
    "SELECT time, value FROM samples WHERE trace = (SELECT min(id) FROM traces) AND sample < 1000";

[[noreturn]] void fail(sqlite3* handle) {
  throw Error(fmt::format("the pages' own database: {}", sqlite3_errmsg(handle)));
}

/// A statement whose values are bound in order.
class PageStatement {
 public:
  PageStatement(sqlite3* handle, const char* sql) : handle_(handle), statement_(nullptr, &sqlite3_finalize) {
    sqlite3_stmt* made = nullptr;
    if (sqlite3_prepare_v2(handle, sql, -1, &made, nullptr) != SQLITE_OK) fail(handle);
    statement_.reset(made);
  }
  PageStatement& bind(std::int64_t value) {
    sqlite3_bind_int64(statement_.get(), ++index_, value);
    return *this;
  }
  PageStatement& bind(const std::string& value) {
    sqlite3_bind_text(statement_.get(), ++index_, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT);
    return *this;
  }
  PageStatement& bind(const std::vector<std::byte>& value) {
    sqlite3_bind_blob64(statement_.get(), ++index_, value.data(), value.size(), SQLITE_TRANSIENT);
    return *this;
  }
  bool step() {
    const int result = sqlite3_step(statement_.get());
    if (result != SQLITE_ROW && result != SQLITE_DONE) fail(handle_);
    return result == SQLITE_ROW;
  }
  std::int64_t integer() { return sqlite3_column_int64(statement_.get(), 0); }

 private:
  sqlite3* handle_;
  std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> statement_;
  int index_ = 0;
};

void describe_views(sqlite3* handle) {
  std::vector<ViewDescription> views = view_descriptions();
  views.push_back({"samples",
                   "One row a sample and channel of the stored time series: trace (the id in view traces), sample "
                   "(from 0), time (s), channel, value (SI). Say which trace.",
                   kSamplesExample});
  for (const ViewDescription& view : views)
    PageStatement(handle, "INSERT INTO page_view (name, sentence, example) VALUES (?, ?, ?)")
        .bind(view.name)
        .bind(view.sentence)
        .bind(view.example)
        .step();
}

}  // namespace

PageDatabase::PageDatabase() { open(":memory:"); }

PageDatabase::PageDatabase(const std::filesystem::path& file) { open(file.c_str()); }

void PageDatabase::open(const char* name) {
  constexpr int kWait = 5000;  ///< ms, for a reader to end
  if (sqlite3_open_v2(name, &handle_, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr) != SQLITE_OK) fail(handle_);
  sqlite3_busy_timeout(handle_, kWait);
  execute(kTables);
  describe_views(handle_);
}

PageDatabase::~PageDatabase() { sqlite3_close_v2(handle_); }

void PageDatabase::execute(const std::string& sql) const {
  if (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail(handle_);
}

std::int64_t PageDatabase::number(const std::string& sql) const {
  PageStatement statement(handle_, sql.c_str());
  statement.step();
  return statement.integer();
}

void PageDatabase::copy(const Database& source, std::size_t most_bytes) {
  for (const std::string& note : copy_for_pages(source.handle(), handle_, most_bytes)) add_note(note);
}

void PageDatabase::add_about(const std::string& name, const std::string& value) {
  PageStatement(handle_, "INSERT INTO page_about (name, value) VALUES (?, ?)").bind(name).bind(value).step();
}

void PageDatabase::add_note(const std::string& sentence) {
  PageStatement(handle_, "INSERT INTO page_note (sentence) VALUES (?)").bind(sentence).step();
}

void PageDatabase::add(const ReplayRecord& replay) {
  execute("BEGIN");
  PageStatement(
      handle_,
      "INSERT INTO page_replay (experiment, run, trial, pass, model, robot, target_robot) VALUES (?, ?, ?, ?, "
      "?, ?, ?)")
      .bind(replay.experiment)
      .bind(replay.run)
      .bind(replay.trial)
      .bind(replay.pass)
      .bind(replay.model)
      .bind(replay.robot)
      .bind(replay.target_robot)
      .step();
  const std::int64_t id = sqlite3_last_insert_rowid(handle_);
  for (const auto& [kind, series] : replay.traces) {
    const EncodedTrace trace = encode_trace(series, TracePrecision::float32);
    PageStatement(handle_, "INSERT INTO page_replay_trace VALUES (?, ?, ?, ?, ?, ?, ?)")
        .bind(id)
        .bind(kind)
        .bind(trace.channels)
        .bind(trace.sample_count)
        .bind(to_string(trace.precision))
        .bind(trace.times)
        .bind(trace.samples)
        .step();
  }
  execute("COMMIT");
}

bool PageDatabase::has_replay(std::int64_t run, std::int64_t trial, std::int64_t model) const {
  PageStatement statement(handle_, "SELECT count(*) FROM page_replay WHERE run = ? AND trial = ? AND model = ?");
  statement.bind(run).bind(trial).bind(model).step();
  return statement.integer() > 0;
}

std::int64_t PageDatabase::replays() const { return number("SELECT count(*) FROM page_replay"); }

std::size_t PageDatabase::size() const {
  return static_cast<std::size_t>(number("PRAGMA page_count") * number("PRAGMA page_size"));
}

std::vector<std::byte> PageDatabase::bytes() const {
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> image(sqlite3_serialize(handle_, "main", &size, 0),
                                                              &sqlite3_free);
  if (!image) throw Error("the pages' own database does not fit into memory");
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  std::memcpy(bytes.data(), image.get(), bytes.size());
  return bytes;
}

}  // namespace lacuna
