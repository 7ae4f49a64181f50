// Source tree as the house test reads it: the files under src/, each split into code, comments and string literals.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace house {

/// A piece of text of a file, with the number of its first line.
struct Text {
  int line = 0;
  std::string text;
};

struct SourceFile {
  std::string name;  ///< relative to src/, with slashes
  std::string text;  ///< as it is
  std::string code;  ///< without comments, string and character literals empty; as many lines as text
  std::vector<Text> comments;
  std::vector<Text> strings;

  std::string folder() const {
    const std::size_t slash = name.rfind('/');
    return slash == std::string::npos ? "" : name.substr(0, slash);
  }
  std::string base() const { return name.substr(name.rfind('/') + 1); }
  std::string stem() const { return base().substr(0, base().find('.')); }
  int lines() const { return static_cast<int>(std::ranges::count(text, '\n')); }
};

/// Splits C++ text; it understands comments, string and character literals, raw strings, and digit separators.
class Splitter {
 public:
  explicit Splitter(SourceFile& file) : file_(file) {}

  void run() {
    while (at_ < file_.text.size()) {
      if (follows("//")) {
        comment(file_.text.find('\n', at_), 0);
      } else if (follows("/*")) {
        comment(file_.text.find("*/", at_ + 2), 2);
      } else if (follows("R\"")) {
        raw_string();
      } else if (now() == '"') {
        string();
      } else if (now() == '\'' && !(at_ > 0 && std::isalnum(static_cast<unsigned char>(file_.text[at_ - 1])))) {
        character();
      } else {
        code(now());
        ++at_;
      }
    }
  }

 private:
  char now() const { return file_.text[at_]; }
  bool follows(std::string_view text) const { return file_.text.compare(at_, text.size(), text) == 0; }

  void code(char byte) {
    if (byte == '\n') ++line_;
    file_.code += byte;
  }

  /// Goes on at `end`, and keeps the line ends in the code.
  void skip_to(std::size_t end) {
    for (; at_ < std::min(end, file_.text.size()); ++at_) {
      if (now() == '\n') code('\n');
    }
  }

  void comment(std::size_t end, std::size_t mark) {
    end = std::min(end, file_.text.size());
    file_.comments.push_back({line_, file_.text.substr(at_ + 2, end - at_ - 2)});
    skip_to(end + mark);
  }

  void raw_string() {
    const std::size_t open = file_.text.find('(', at_);
    const std::string close = ")" + file_.text.substr(at_ + 2, open - at_ - 2) + "\"";
    const std::size_t end = file_.text.find(close, open);
    file_.strings.push_back({line_, file_.text.substr(open + 1, end - open - 1)});
    file_.code += "\"\"";
    skip_to(end + close.size());
  }

  void string() {
    std::size_t end = at_ + 1;
    while (end < file_.text.size() && file_.text[end] != '"') end += file_.text[end] == '\\' ? 2U : 1U;
    const std::string literal = file_.text.substr(at_ + 1, end - at_ - 1);
    const bool include = file_.code.ends_with("#include ");
    if (!include) file_.strings.push_back({line_, literal});
    file_.code += include ? "\"" + literal + "\"" : "\"\"";
    skip_to(end + 1);
  }

  void character() {
    std::size_t end = at_ + 1;
    while (end < file_.text.size() && file_.text[end] != '\'') end += file_.text[end] == '\\' ? 2U : 1U;
    file_.code += "''";
    skip_to(end + 1);
  }

  SourceFile& file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Every source file under a folder, in the order of names.
inline std::vector<SourceFile> read_sources(const std::filesystem::path& folder) {
  std::vector<SourceFile> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".hpp" && ending != ".cpp" && ending != ".in") continue;
    SourceFile file{entry.path().lexically_relative(folder).generic_string(), read_text(entry.path()), {}, {}, {}};
    Splitter(file).run();
    files.push_back(std::move(file));
  }
  std::ranges::sort(files, {}, &SourceFile::name);
  return files;
}

/// The identifiers, numbers and punctuation marks of code, without preprocessor lines.
inline std::vector<Text> tokens(const std::string& code) {
  std::vector<Text> found;
  int line = 1;
  bool line_start = true;
  for (std::size_t i = 0; i < code.size();) {
    const auto byte = static_cast<unsigned char>(code[i]);
    if (line_start && byte == '#') {
      while (i < code.size() && code[i] != '\n') ++i;
      continue;
    }
    if (std::isalnum(byte) || byte == '_') {
      std::size_t end = i;
      while (end < code.size() && (std::isalnum(static_cast<unsigned char>(code[end])) || code[end] == '_')) ++end;
      found.push_back({line, code.substr(i, end - i)});
      i = end;
      line_start = false;
      continue;
    }
    if (byte == '\n') {
      ++line;
      line_start = true;
    } else if (!std::isspace(byte)) {
      found.push_back({line, std::string(1, code[i])});
      line_start = false;
    }
    ++i;
  }
  return found;
}

/// The types that a file defines at namespace level, those of anonymous namespaces left aside.
inline std::vector<Text> types(const SourceFile& file) {
  enum class Scope { named, anonymous, other };
  std::vector<Scope> scopes;
  std::vector<Text> found;
  const std::vector<Text> all = tokens(file.code);
  const auto word = [&](std::size_t i) { return i < all.size() ? all[i].text : std::string(); };
  std::size_t statement = 0;  // where the statement began
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& now = all[i].text;
    if (now == "{") {
      const bool space = word(statement) == "namespace" || word(statement + 1) == "namespace";
      scopes.push_back(!space ? Scope::other : word(i - 1) == "namespace" ? Scope::anonymous : Scope::named);
    } else if (now == "}" && !scopes.empty()) {
      scopes.pop_back();
    }
    if (now == "{" || now == "}" || now == ";") {
      statement = i + 1;
      continue;
    }
    const bool type = now == "struct" || now == "class" || now == "enum" || now == "union";
    const bool nested = std::ranges::any_of(scopes, [](Scope scope) { return scope != Scope::named; });
    if (!type || nested || (i > 0 && (word(i - 1) == "<" || word(i - 1) == "," || word(i - 1) == "enum"))) continue;
    std::size_t name = i + 1;
    if (word(name) == "class" || word(name) == "struct") ++name;
    const std::size_t after = word(name + 1) == "final" ? name + 2 : name + 1;
    const bool bases = word(after) == ":" && word(after + 1) != ":";  // not Outer::Inner
    if (word(after) == "{" || bases) found.push_back(all[name]);
  }
  return found;
}

}  // namespace house
