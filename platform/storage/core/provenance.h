#pragma once

#include <string>

namespace lacuna {

/// What a result came from, beside its inputs. Says nothing about whose machine it was.
struct Provenance {
  std::string program;          ///< version of Lacuna
  std::string source_revision;  ///< of the version control, "-dirty" with uncommitted changes; "unknown" outside of it
  std::string compiler;
  std::string build_type;
  std::string ode;
  std::string sqlite;
  std::string eigen;
  std::string processor;  ///< model name
  std::string system;     ///< kernel and machine: "Linux x86_64"
};

Provenance provenance_of_this_program();

}  // namespace lacuna
