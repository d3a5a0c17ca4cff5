#pragma once

#include "report/pages/web_server.h"

#include <string>

namespace lacuna {

/// 128 bits from the system, as hexadecimal digits.
std::string random_token();

/// Who may ask a page server: whoever has its token, by a name of this machine, from its own pages. The port that they
/// ask for may be another one than the server's: that of an SSH tunnel.
class PageAccess {
 public:
  /// `host`: the address that the server listens at.
  PageAccess(std::string token, std::string host);

  /// Why a request is refused, for whoever sent it. Empty: it is let in.
  std::string refusal(const WebRequest& request) const;

 private:
  bool is_own_name(const std::string& name) const;
  bool comes_from_elsewhere(const WebRequest& request) const;
  std::string token_, host_, machine_;
  bool this_machine_only_;
};

}  // namespace lacuna
