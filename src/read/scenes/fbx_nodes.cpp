// FBX nodes: the text of an FBX file as a tree.
#include "read/scenes/fbx.hpp"

#include <algorithm>
#include <string>

#include "numbers/parse_number.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

Error unexpected_text_in_fbx(std::string_view text) {
  return data_error("{} is here; expected the name of a node and a colon, or the end of a node; export the file again",
                    in_quotes(text));
}

constexpr std::string_view blanks = " \t\r\n";

class Parser {
 public:
  Parser(std::string_view text, MemoryUse& memory) : text_(text), memory_(memory) {}

  FbxNode parse() {
    FbxNode file{.children = read_nodes(0)};
    if (at_ < text_.size()) throw unexpected_text_in_fbx("}").at({"", line_, 0});
    return file;
  }

 private:
  /// The nodes before a brace that closes them, or the end.
  std::vector<FbxNode> read_nodes(std::size_t level) {
    std::vector<FbxNode> nodes;
    while (skip_blanks() && text_[at_] != '}') nodes.push_back(read_node(level));
    return nodes;
  }

  /// Skips blanks and comments; false at the end.
  bool skip_blanks() {
    while (at_ < text_.size()) {
      if (text_[at_] == ';') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (blanks.find(text_[at_]) == std::string_view::npos) {
        return true;
      } else {
        line_ += text_[at_] == '\n' ? 1 : 0;
        ++at_;
      }
    }
    return false;
  }

  FbxNode read_node(std::size_t level) {
    const std::size_t end = text_.find_first_of(":{}\",;\n", at_);
    if (end == std::string_view::npos || text_[end] != ':') {
      throw unexpected_text_in_fbx(text_.substr(at_, std::min<std::size_t>(end - at_, 20))).at({"", line_, 0});
    }
    memory_.add(2 * sizeof(FbxNode));  // as lists of children grow
    FbxNode node{text_.substr(at_, end - at_), {}, line_};
    at_ = end + 1;
    const std::size_t first = at_;
    const std::size_t last = skip_values();
    node.text = text_.substr(first, last - first);
    constexpr std::size_t most_levels = 64;
    if (level >= most_levels)
      throw data_error("nodes are within more than {} others; expected fewer; export the file again", most_levels)
          .at({"", line_, 0});
    if (at_ == text_.size() || text_[at_] != '{') return node;
    ++at_;
    node.children = read_nodes(level + 1);
    if (at_ == text_.size()) throw file_ends_early().at({"", line_, 0});
    ++at_;
    return node;
  }

  /// Goes to the brace or the end of line after a list of values, and returns where the list ends. A list continues
  /// on the next line where a comma is before or after the line break. It may begin on the next line.
  std::size_t skip_values() {
    const std::size_t first = at_;
    bool is_complete = true;  // no comma is open
    for (;;) {
      at_ = std::min(text_.find_first_not_of(" \t\r", at_), text_.size());
      if (at_ == text_.size() || text_[at_] == '{' || text_[at_] == '}') return at_;
      const char byte = text_[at_];
      if (byte == '"') {
        const std::size_t end = text_.find('"', at_ + 1);
        if (end == std::string_view::npos) throw file_ends_early().at({"", line_, 0});
        line_ += static_cast<std::uint64_t>(std::ranges::count(text_.substr(at_, end - at_), '\n'));
        at_ = end + 1;
        is_complete = true;
      } else if (byte == ',') {
        ++at_;
        is_complete = false;
      } else if (byte == '\n' || byte == ';') {
        const std::size_t end = at_;
        const bool is_empty = text_.find_first_not_of(blanks, first) >= end;
        if (!skip_blanks()) return end;
        const bool has_value = is_empty && std::string_view("0123456789-\"").find(text_[at_]) != std::string_view::npos;
        if (is_complete && text_[at_] != ',' && !has_value) return end;
      } else {
        at_ = std::min(text_.find_first_of(" \t\r\n,{};\"", at_), text_.size());
        is_complete = true;
      }
    }
  }

  std::string_view text_;
  MemoryUse& memory_;
  std::size_t at_ = 0;
  std::uint64_t line_ = 1;
};

}  // namespace

const FbxNode* FbxNode::find(std::string_view child) const {
  const auto found = std::ranges::find(children, child, &FbxNode::name);
  return found == children.end() ? nullptr : &*found;
}

const FbxNode& FbxNode::child(std::string_view child) const {
  if (const FbxNode* const found = find(child)) return *found;
  throw data_error("the node has no child {}; expected one; export the file again", in_quotes(child)).at({"", line, 0});
}

FbxValues::FbxValues(const FbxNode& node) : rest_(node.text), line_(node.line) {
  const FbxNode* const array = node.find("a");
  if (array == nullptr) {
    skip_blanks();
    return;
  }
  skip_blanks();
  const std::string_view text = rest_.substr(0, rest_.find_last_not_of(blanks) + 1);
  const std::string_view digits = text.substr(text.starts_with('*') ? 1 : text.size());
  left_ = in_digits<std::uint64_t>(digits);
  if (!left_) throw count_of_file_expected(text).at({"", line_, 0});
  rest_ = array->text;
  line_ = array->line;
  skip_blanks();
  require_count();
}

void FbxValues::require_count() const {
  if (!left_ || (*left_ > 0) == !rest_.empty()) return;
  throw data_error("the array has more or fewer values than its count says; expected as many; export the file again")
      .at({"", line_, 0});
}

void FbxValues::skip_blanks() {
  for (;;) {
    const std::size_t count = std::min(rest_.find_first_not_of(blanks), rest_.size());
    line_ += static_cast<std::uint64_t>(std::ranges::count(rest_.substr(0, count), '\n'));
    rest_.remove_prefix(count);
    if (!rest_.starts_with(';')) return;
    rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
  }
}

std::string_view FbxValues::next() {
  if (at_end()) throw file_ends_early().at({"", line_, 0});
  const bool is_quoted = rest_.front() == '"';
  if (is_quoted) rest_.remove_prefix(1);
  const std::size_t size = std::min(is_quoted ? rest_.find('"') : rest_.find_first_of(", \t\r\n;"), rest_.size());
  const std::string_view value = rest_.substr(0, size);
  rest_.remove_prefix(std::min(is_quoted ? size + 1 : size, rest_.size()));
  skip_blanks();
  if (rest_.starts_with(',')) rest_.remove_prefix(1);
  skip_blanks();
  if (left_) --*left_;
  require_count();
  return value;
}

WrittenNumber FbxValues::next_number() {
  const std::string_view text = next();
  const auto value = parse_number(text);
  if (!value) throw number_of_file_expected(text).at({"", line_, 0});
  return {*value, std::string(text)};
}

std::int64_t FbxValues::next_integer() {
  const std::string_view text = next();
  const auto integer = in_digits<std::int64_t>(text);
  if (!integer) throw count_of_file_expected(text).at({"", line_, 0});
  return *integer;
}

FbxNode parse_fbx(std::string_view text, MemoryUse& memory) { return Parser(text, memory).parse(); }

}  // namespace tcb
