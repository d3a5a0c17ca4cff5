#include "report/pages/page_access.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <random>

namespace lacuna {
namespace {

/// As long a look at every byte of the longer one, wherever they differ.
bool same_token(const std::string& a, const std::string& b) {
  unsigned difference = a.size() == b.size() ? 0U : 1U;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(i < b.size() ? b[i] : 0);
  return difference == 0U;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

/// The name in a Host header, without port and brackets.
std::string host_name(const std::string& host) {
  if (host.starts_with('[')) return host.substr(1, host.find(']') - 1);
  return host.substr(0, host.find(':'));
}

bool is_loopback_name(const std::string& name) { return name == "127.0.0.1" || name == "localhost" || name == "::1"; }

/// A number, which no other site can take for itself.
bool is_address(const std::string& name) {
  std::array<unsigned char, sizeof(in6_addr)> address{};
  return inet_pton(AF_INET, name.c_str(), address.data()) == 1 ||
         inet_pton(AF_INET6, name.c_str(), address.data()) == 1;
}

std::string first_label(const std::string& name) { return name.substr(0, name.find('.')); }

std::string machine_name() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return "";
  return first_label(lower_case(name.data()));
}

}  // namespace

std::string random_token() {
  std::random_device device;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", device());
  return token;
}

PageAccess::PageAccess(std::string token, std::string host)
    : token_(std::move(token)),
      host_(lower_case(std::move(host))),
      machine_(machine_name()),
      this_machine_only_(is_loopback_name(host_)) {}

std::string PageAccess::refusal(const WebRequest& request) const {
  if (!is_own_name(host_name(lower_case(request.header("host")))))
    return "this name does not belong to this machine; open the address that `lacuna serve` printed";
  if (comes_from_elsewhere(request))
    return "pages of other sites have no access; open the address that `lacuna serve` printed";
  const std::string token = request.method == "GET" ? request.parameter("token") : request.header("x-lacuna-token");
  if (!same_token(token_, token))
    return "the token is missing or wrong; open the complete address that `lacuna serve` printed";
  return "";
}

/// Another site can have any name lead to this machine, but not one of these.
bool PageAccess::is_own_name(const std::string& name) const {
  if (is_loopback_name(name)) return true;
  if (this_machine_only_) return false;
  return is_address(name) || name == host_ || (!machine_.empty() && first_label(name) == machine_);
}

/// A browser says so of itself. An address may be opened from anywhere, as from a message, but into a page of its own.
bool PageAccess::comes_from_elsewhere(const WebRequest& request) const {
  const std::string origin = lower_case(request.header("origin")), host = lower_case(request.header("host"));
  if (!origin.empty() && origin != "http://" + host && origin != "https://" + host) return true;
  const std::string site = request.header("sec-fetch-site");
  if (site.empty() || site == "same-origin" || site == "none") return false;
  return request.method != "GET" || request.header("sec-fetch-mode") != "navigate" ||
         request.header("sec-fetch-dest") != "document";
}

}  // namespace lacuna
