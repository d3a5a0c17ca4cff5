#include "report/text/history_rows.h"

#include <algorithm>
#include <iterator>

namespace lacuna {

std::vector<std::string> channels_of(const std::vector<HistoryRow>& rows) {
  std::vector<std::string> channels;
  for (const HistoryRow& row : rows)
    if (!row.channel.empty() && std::find(channels.begin(), channels.end(), row.channel) == channels.end())
      channels.push_back(row.channel);
  return channels;
}

std::vector<HistoryRow> rows_of(const std::vector<HistoryRow>& rows, const std::string& channel) {
  std::vector<HistoryRow> chosen;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen),
               [&](const HistoryRow& row) { return row.channel == channel || row.channel.empty(); });
  return chosen;
}

}  // namespace lacuna
