#include "report/pages/pages.h"

#include "report/pages/base64.h"
#include "report/pages/gzip.h"

#include <lacuna/error.h>

#ifdef LACUNA_PAGES
extern "C" const char lacuna_pages_begin[];
extern "C" const char lacuna_pages_end[];
#endif

namespace lacuna {
namespace {

constexpr std::string_view kConnect = "%CONNECT%";
constexpr std::string_view kData = "<!--lacuna-data-->";

/// What report/web is bundled to (report/web/build.mjs).
std::string_view asset() {
#ifdef LACUNA_PAGES
  return {lacuna_pages_begin, static_cast<std::size_t>(lacuna_pages_end - lacuna_pages_begin)};
#else
  return {};
#endif
}

std::string page(std::string_view connect, std::string_view data) {
  require_pages();
  const std::string_view all = asset();
  const std::size_t policy = all.find(kConnect), place = all.find(kData);
  std::string text;
  text.reserve(all.size() + data.size());
  text += all.substr(0, policy);
  text += connect;
  text += all.substr(policy + kConnect.size(), place - policy - kConnect.size());
  text += data;
  text += all.substr(place + kData.size());
  return text;
}

}  // namespace

bool has_pages() { return !asset().empty(); }

void require_pages() {
  if (!has_pages())
    throw Error(
        "this lacuna was built without its pages; build it with Node.js and npm installed and without "
        "-DLACUNA_REPORT=OFF");
}

std::string report_page(std::span<const std::byte> database) {
  const std::string data = base64(gzip(database));
  return page("'none'", "<script type=\"application/gzip;base64\" id=\"lacuna-data\">" + data + "</script>");
}

std::string served_page() { return page("'self'", ""); }

}  // namespace lacuna
