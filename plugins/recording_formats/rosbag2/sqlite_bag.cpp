#include "bad_bag.h"
#include "bag.h"
#include "message_pack.h"

#include <sqlite3.h>

#include <map>
#include <utility>

namespace lacuna::rosbag2 {
namespace {

constexpr int kLongestValue = 1 << 29;  ///< bytes

struct DatabaseCloser {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
};
struct StatementCloser {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, DatabaseCloser>;

/// A query to a database, row by row.
class Question {
 public:
  Question(sqlite3* database, const std::string& sql) : database_(database) {
    sqlite3_stmt* made = nullptr;
    const int result = sqlite3_prepare_v2(database, sql.c_str(), -1, &made, nullptr);
    statement_.reset(made);
    if (result != SQLITE_OK) fail();
  }
  bool next() {
    const int result = sqlite3_step(statement_.get());
    if (result != SQLITE_ROW && result != SQLITE_DONE) fail();
    return result == SQLITE_ROW;
  }
  std::int64_t number(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  std::string text(int column) const {
    const unsigned char* const text = sqlite3_column_text(statement_.get(), column);
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
    return text ? std::string(reinterpret_cast<const char*>(text), size) : std::string();
  }
  Bytes bytes(int column) const {
    const auto* const bytes = static_cast<const unsigned char*>(sqlite3_column_blob(statement_.get(), column));
    return {bytes, bytes ? static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)) : 0};
  }

 private:
  [[noreturn]] void fail() const {
    throw BadBag(std::string("cannot be read as a bag: SQLite reports ") + sqlite3_errmsg(database_) +
                 "; a rosbag2 file has the tables topics and messages");
  }
  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, StatementCloser> statement_;
};

/// A path in a URI for SQLite.
std::string uri_of(const std::string& path) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '%' || c == '?' || c == '#') {
      uri += '%';
      uri += kDigits[byte >> 4];
      uri += kDigits[byte & 15];
    } else {
      uri += c;
    }
  }
  return uri + "?mode=ro&immutable=1";  // immutable: no log is read, and nothing is written beside it
}

Database open_read_only(const std::string& path) {
  sqlite3* opened = nullptr;
  const int result = sqlite3_open_v2(uri_of(path).c_str(), &opened,
                                     SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
  Database database(opened);
  if (result != SQLITE_OK) throw BadBag(std::string("cannot be opened: ") + sqlite3_errmsg(database.get()));
  sqlite3_db_config(database.get(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database.get(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_limit(database.get(), SQLITE_LIMIT_LENGTH, kLongestValue);
  return database;
}

/// A bag in the tables of rosbag2's storage plugin sqlite3.
class SqliteBag : public Bag {
 public:
  explicit SqliteBag(const std::string& path) : database_(open_read_only(path)) {
    read_topics();
    read_definitions();
  }

  const std::vector<BagTopic>& topics() const override { return topics_; }
  bool knows_topics() const override { return true; }
  void visit(const std::function<bool(std::size_t)>& wants,
             const std::function<bool(const BagMessage&)>& visit) override {
    Question rows(database_.get(), "SELECT topic_id, timestamp, data FROM messages");
    while (rows.next()) {
      const auto topic = indices_.find(rows.number(0));
      if (topic == indices_.end())
        throw BadBag("has a message of topic number " + std::to_string(rows.number(0)) +
                     ", which is not one of its topics");
      if (wants(topic->second) && !visit({topic->second, rows.number(1), unpacked_.unpack(rows.bytes(2))})) return;
    }
  }

 private:
  void read_topics() {
    Question rows(database_.get(), "SELECT id, name, type, serialization_format FROM topics ORDER BY id");
    while (rows.next()) {
      indices_.emplace(rows.number(0), topics_.size());
      topics_.push_back({rows.text(1), rows.text(2), rows.text(3), {}, {}});
    }
  }

  /// Bags of ROS 2 Iron and later contain the definitions of their types.
  void read_definitions() {
    Question table(database_.get(),
                   "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = 'message_definitions'");
    if (!table.next()) return;
    Question rows(database_.get(), "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions");
    while (rows.next())
      for (BagTopic& topic : topics_) {
        const std::string encoding = rows.text(1);
        if (topic.type != rows.text(0) || encoding == "unknown") continue;
        topic.definition_encoding = encoding;
        topic.definition = rows.text(2);
      }
  }

  Database database_;
  std::vector<BagTopic> topics_;
  std::map<std::int64_t, std::size_t> indices_;  ///< by id
  MessagePack unpacked_;
};

}  // namespace

std::unique_ptr<Bag> open_sqlite(const std::string& path) { return std::make_unique<SqliteBag>(path); }

}  // namespace lacuna::rosbag2
