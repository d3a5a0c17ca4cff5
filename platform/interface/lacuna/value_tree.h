#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// A number with all digits of a time stamp: whole + part. A plain double is in `part`.
struct LongNumber {
  std::int64_t whole = 0;
  double part = 0.0;
};

/// One message of a recording, such as a line of JSON, as a tree: for formats with columns by path. Texts and keys are
/// views of the message, which must live as long. A tree is filled again and again, so that its memory is reused.
class ValueTree {
 public:
  enum class Kind { number, text, nothing, list, object };
  struct Node {
    Kind kind = Kind::nothing;
    std::string_view key = {};  ///< in an object
    LongNumber number = {};
    std::string_view text = {};
    std::size_t end = 0;  ///< index after its last descendant, where its next sibling is
  };

  const std::vector<Node>& nodes() const { return nodes_; }
  void clear() {
    nodes_.clear();
    open_.clear();
    texts_.clear();
  }

  /// The next node, in the order of the message. `key`: empty in a list.
  void add_number(std::string_view key, LongNumber number) { add({Kind::number, key, number}); }
  void add_number(std::string_view key, double number) { add({Kind::number, key, {0, number}}); }
  void add_text(std::string_view key, std::string_view text) { add({Kind::text, key, {}, text}); }
  void add_nothing(std::string_view key) { add({Kind::nothing, key}); }
  /// The nodes that follow up to `end` are inside this one. `kind`: list or object.
  void begin(Kind kind, std::string_view key) {
    open_.push_back(nodes_.size());
    add({kind, key});
  }
  void end() {
    nodes_[open_.back()].end = nodes_.size();
    open_.pop_back();
  }
  std::size_t depth() const { return open_.size(); }

  /// Keeps a text that is not a view of the message until the next `clear`.
  std::string_view keep(std::string text) { return texts_.emplace_back(std::move(text)); }

 private:
  void add(Node node) {
    node.end = nodes_.size() + 1;
    nodes_.push_back(node);
  }

  std::vector<Node> nodes_;
  std::vector<std::size_t> open_;
  std::deque<std::string> texts_;  ///< a deque does not move its elements
};

/// Visits the numbers of a tree with their paths: `header.stamp`, `wrench.force.x`, `data[3]`. Elements of a list are
/// named where an object around it has as many texts in a list `name`, `names` or `joint_names`, as in joint states:
/// `position[shoulder]`. A time of whole seconds and nanoseconds (`sec` and `nanosec`) is one number, s. Lists of more
/// than `kMostElements` are not columns.
class NumberPaths {
 public:
  static constexpr std::size_t kMostElements = 256;

  /// `visit(std::string_view path, LongNumber)`; `skip(std::string_view path, std::size_t elements)` for long lists,
  /// with 0 for a text.
  template <class Visit, class Skip>
  void walk(const ValueTree& tree, Visit&& visit, Skip&& skip) {
    path_.clear();
    names_.clear();
    if (!tree.nodes().empty()) walk_node(tree, 0, visit, skip);
  }

 private:
  using Nodes = std::vector<ValueTree::Node>;

  template <class Visit, class Skip>
  void walk_node(const ValueTree& tree, std::size_t index, Visit& visit, Skip& skip) {
    const ValueTree::Node& node = tree.nodes()[index];
    switch (node.kind) {
      case ValueTree::Kind::number: return visit(std::string_view(path_), node.number);
      case ValueTree::Kind::text: return skip(std::string_view(path_), std::size_t{0});
      case ValueTree::Kind::nothing: return;
      case ValueTree::Kind::list: return walk_list(tree, index, visit, skip);
      case ValueTree::Kind::object: return walk_object(tree, index, visit, skip);
    }
  }

  template <class Visit, class Skip>
  void walk_object(const ValueTree& tree, std::size_t index, Visit& visit, Skip& skip) {
    const Nodes& nodes = tree.nodes();
    LongNumber stamp;
    if (is_stamp(nodes, index, stamp)) return visit(std::string_view(path_), stamp);
    const std::size_t before = names_.size(), length = path_.size();
    for (std::size_t child = index + 1; child < nodes[index].end; child = nodes[child].end)
      if (is_list_of_names(nodes, child)) names_.push_back(child);
    for (std::size_t child = index + 1; child < nodes[index].end; child = nodes[child].end) {
      if (length > 0) path_ += '.';
      path_ += nodes[child].key;
      walk_node(tree, child, visit, skip);
      path_.resize(length);
    }
    names_.resize(before);
  }

  template <class Visit, class Skip>
  void walk_list(const ValueTree& tree, std::size_t index, Visit& visit, Skip& skip) {
    const Nodes& nodes = tree.nodes();
    const std::size_t count = count_in(nodes, index), length = path_.size();
    if (count > kMostElements) return skip(std::string_view(path_), count);
    std::size_t name = names_for(nodes, count), number = 0;
    for (std::size_t child = index + 1; child < nodes[index].end; child = nodes[child].end, ++number) {
      path_ += '[';
      if (name > 0)
        path_ += nodes[name].text;
      else
        path_ += std::to_string(number);
      path_ += ']';
      walk_node(tree, child, visit, skip);
      path_.resize(length);
      if (name > 0) ++name;
    }
  }

  static std::size_t count_in(const Nodes& nodes, std::size_t list) {
    std::size_t count = 0;
    for (std::size_t child = list + 1; child < nodes[list].end; child = nodes[child].end) ++count;
    return count;
  }

  /// Index of the first name in a list of this many names in an object around; 0: there is none.
  std::size_t names_for(const Nodes& nodes, std::size_t count) const {
    for (std::size_t i = names_.size(); i-- > 0;)
      if (count > 0 && nodes[names_[i]].end - names_[i] - 1 == count) return names_[i] + 1;
    return 0;
  }

  static bool is_list_of_names(const Nodes& nodes, std::size_t index) {
    const ValueTree::Node& list = nodes[index];
    if (list.kind != ValueTree::Kind::list || list.end == index + 1) return false;
    if (list.key != "name" && list.key != "names" && list.key != "joint_names") return false;
    for (std::size_t child = index + 1; child < list.end; ++child)
      if (nodes[child].kind != ValueTree::Kind::text) return false;
    return true;
  }

  /// Whether an object consists of seconds and nanoseconds only.
  static bool is_stamp(const Nodes& nodes, std::size_t index, LongNumber& stamp) {
    if (nodes[index].end != index + 3) return false;
    const ValueTree::Node &seconds = nodes[index + 1], &rest = nodes[index + 2];
    if (seconds.kind != ValueTree::Kind::number || rest.kind != ValueTree::Kind::number) return false;
    if (!(seconds.key == "sec" && rest.key == "nanosec") && !(seconds.key == "secs" && rest.key == "nsecs"))
      return false;
    stamp = {seconds.number.whole,
             seconds.number.part + 1e-9 * (static_cast<double>(rest.number.whole) + rest.number.part)};
    return true;
  }

  std::string path_;
  std::vector<std::size_t> names_;  ///< lists of names of the objects around
};

}  // namespace lacuna
