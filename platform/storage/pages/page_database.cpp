#include "storage/pages/page_database.h"

#include "storage/core/statement.h"
#include "storage/pages/page_copy.h"
#include "storage/queries/page_query.h"
#include "storage/traces/trace_codec.h"

#include <lacuna/error.h>

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
CREATE TABLE page_run (run INTEGER PRIMARY KEY, models INTEGER NOT NULL, tests INTEGER NOT NULL) STRICT;
CREATE TABLE page_replay (
  id INTEGER PRIMARY KEY, experiment TEXT NOT NULL, identity TEXT NOT NULL, run INTEGER NOT NULL,
  trial INTEGER NOT NULL, pass INTEGER NOT NULL, model INTEGER NOT NULL, robot TEXT NOT NULL,
  target_robot TEXT NOT NULL, UNIQUE (identity, trial, model)) STRICT;
CREATE TABLE page_replay_trace (
  replay INTEGER NOT NULL REFERENCES page_replay (id), kind TEXT NOT NULL, channels TEXT NOT NULL,
  sample_count INTEGER NOT NULL, precision TEXT NOT NULL, times BLOB NOT NULL, samples BLOB NOT NULL,
  PRIMARY KEY (replay, kind)) STRICT;
)sql";

constexpr const char* kSamplesExample =
    "SELECT time, value FROM samples WHERE trace = (SELECT min(id) FROM traces) AND sample < 1000";

/// A reader of these tables may have a long query under way.
constexpr auto kWait = kLongestPageQuery + std::chrono::seconds(5);

void describe_views(const Database& database) {
  std::vector<ViewDescription> views = view_descriptions();
  views.push_back({"samples",
                   "One row per sample and channel of the stored time series: trace (the id in view traces), sample "
                   "(from 0), time (s), channel, value (SI). Say which trace.",
                   kSamplesExample});
  Statement insert(database, "INSERT INTO page_view (name, sentence, example) VALUES (?, ?, ?)");
  for (const ViewDescription& view : views) insert.run_with(view.name, view.sentence, view.example);
}

void add_trace(const Database& database, std::int64_t replay, const std::string& kind, const TimeSeries& series) {
  const EncodedTrace trace = encode_trace(series, TracePrecision::float32);
  Statement(database, "INSERT INTO page_replay_trace VALUES (?, ?, ?, ?, ?, ?, ?)")
      .run_with(replay, kind, trace.channels, trace.sample_count, to_string(trace.precision), trace.times,
                trace.samples);
}

}  // namespace

PageDatabase::PageDatabase() : PageDatabase(Database::open_blank()) {}

PageDatabase::PageDatabase(const std::filesystem::path& file) : PageDatabase(Database::open_blank(file)) {}

PageDatabase::PageDatabase(Database database) : database_(std::move(database)) {
  database_.wait_for_writers(kWait);
  database_.execute(kTables);
  describe_views(database_);
}

void PageDatabase::copy(const Database& source, std::size_t most_bytes) {
  for (const std::string& note : copy_for_pages(source, database_, most_bytes)) add_note(note);
}

void PageDatabase::add_about(const std::string& name, const std::string& value) {
  Statement(database_, "INSERT INTO page_about (name, value) VALUES (?, ?)").run_with(name, value);
}

void PageDatabase::add_note(const std::string& sentence) {
  Statement(database_, "INSERT INTO page_note (sentence) VALUES (?)").run_with(sentence);
}

std::int64_t PageDatabase::add(const ReplayRecord& replay) {
  Transaction transaction(database_);
  Statement(database_,
            "INSERT INTO page_replay (experiment, identity, run, trial, pass, model, robot, target_robot)"
            " VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
      .run_with(replay.experiment, replay.identity, replay.run, replay.trial, replay.pass, replay.model, replay.robot,
                replay.target_robot);
  const std::int64_t id = sqlite3_last_insert_rowid(database_.handle());
  for (const auto& [kind, series] : replay.traces) add_trace(database_, id, kind, series);
  transaction.commit();
  return id;
}

std::optional<std::int64_t> PageDatabase::find_replay(const std::string& identity, std::int64_t trial,
                                                      std::int64_t model) const {
  Statement found(database_, "SELECT id FROM page_replay WHERE identity = ? AND trial = ? AND model = ?");
  found.with(identity, trial, model);
  return found.step() ? std::optional(found.integer(0)) : std::nullopt;
}

std::size_t PageDatabase::size() const {
  Statement size(database_, "SELECT page_count * page_size FROM pragma_page_count, pragma_page_size");
  size.step();
  return static_cast<std::size_t>(size.integer(0));
}

std::vector<std::byte> PageDatabase::bytes() const {
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> image(sqlite3_serialize(database_.handle(), "main", &size, 0),
                                                              &sqlite3_free);
  if (!image) throw Error("the database of the pages does not fit into memory");
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  std::memcpy(bytes.data(), image.get(), bytes.size());
  return bytes;
}

}  // namespace lacuna
