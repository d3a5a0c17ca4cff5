#pragma once

namespace lacuna {

/// Processes that a command's work began and did not end: plugins' and targets' helpers that left their group and their
/// environment. This process is their subreaper.
class LeftRunning {
 public:
  /// Before the work: children that are here already are a shell's, which became this program.
  LeftRunning();
  /// After the work: ends them and says which they were.
  void end() const;

 private:
  bool has_children_of_others_;
};

}  // namespace lacuna
