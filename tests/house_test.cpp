// House rules: includes by folder, sizes, names, words, one list of errors, and tests that mirror the sources.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "house/source_tree.hpp"

namespace {

using house::SourceFile;
using house::Text;
namespace fs = std::filesystem;

const fs::path project = SOURCE_FOLDER;

const std::vector<SourceFile>& sources() {
  static const std::vector<SourceFile> files = house::read_sources(project / "src");
  return files;
}

/// The folder of the table below: input/csv and input/json count as input; at the top, the file's name.
std::string room(const std::string& file) {
  if (file.starts_with("tcb/spline/")) return "tcb/spline";
  return file.substr(0, file.find_first_of("/."));
}

/// Folder -> folders whose headers it may include.
const std::map<std::string, std::set<std::string>> allowed{
    {"error", {}},
    {"tcb/spline", {}},
    {"stream", {}},
    {"text", {"tcb/spline", "error"}},
    {"io", {"stream", "text", "error"}},
    {"input", {"text", "stream", "tcb/spline", "error", "io"}},
    {"keys", {"input", "text", "stream", "tcb/spline", "error"}},
    {"sampling", {"text", "tcb/spline", "error"}},
    {"curve", {"keys", "input", "sampling", "text", "stream", "tcb/spline", "error"}},
    {"exact", {"curve", "keys", "input", "sampling", "text", "stream", "tcb/spline", "error"}},
    {"fit", {"input", "text", "tcb/spline", "error"}},
    {"output", {"curve", "input", "text", "io", "stream", "tcb/spline", "error"}},
    {"picture", {"curve", "keys", "input", "sampling", "text", "stream", "tcb/spline", "error"}},
    {"app",
     {"picture", "output", "fit", "exact", "curve", "sampling", "keys", "input", "io", "text", "stream", "tcb/spline",
      "error"}},
    {"compare",
     {"app", "picture", "output", "fit", "curve", "sampling", "keys", "input", "io", "text", "stream", "tcb/spline",
      "error"}},
    {"cli",
     {"compare", "app", "picture", "output", "exact", "curve", "sampling", "keys", "input", "io", "text", "tcb/spline",
      "error"}},
    {"main", {"cli", "compare", "app", "io", "error"}},
};

/// Package, or a header of ours that includes one -> where it may be included: a folder, or one file.
const std::map<std::string, std::vector<std::string>> packages{
    {"numbers/large_rational.hpp", {"numbers/rational.cpp", "exact/"}},
    {"nlohmann", {"input/json/"}},
    {"boost", {"numbers/rational.cpp", "numbers/large_rational.hpp", "exact/"}},
    {"fast_float", {"text/"}},
    {"CLI", {"cli/"}},
    {"nettle", {"io/"}},
    {"zlib.h", {"io/"}},
    {"zstd.h", {"io/"}},
};

/// Files that hold a table, which may be longer than 300 lines and shorter than others.
const std::set<std::string> tables{"error.hpp", "cli/remedies.cpp", "cli/options.cpp", "tcb/spline/rules.hpp"};

/// Words of the glossary that are retired, wherever they occur: comments, strings, and parts of names.
const std::vector<std::string> retired{
    "told",  "heard",  "beside",        "stands",     "stand",     "said",         "says",
    "knows", "behind", "becomes of",    "goes along", "go along",  "foreign",      "sift",
    "climb", "ladder", "stretch",       "stretches",  "judge",     "beside keys",  "going round",
    "talk",  "slip",   "exchange them", "apart by",   "gives way", "is no number",
};

/// Names of code that are retired, as whole names; as words of prose they may be used.
const std::set<std::string> retired_names{
    "Path",   "Stretch", "WholeCurve", "Whole",    "over",     "BesideKeys",  "heard",    "joined",    "Few",   "few",
    "Talk",   "Sides",   "sides",      "sift",     "judge",    "going_round", "left_out", "left_out_", "Twice", "twice",
    "narrow", "bend",    "Lane",       "Ladder",   "climb",    "foreign",     "slip",     "told",      "Piece", "piece",
    "pieces", "piece_",  "pieces_",    "Recorder", "KeptKeys", "Place",       "Meta",     "Batch",     "Plan",
};

/// One message for all findings of a rule, so that the output is a list to work off.
class Findings {
 public:
  explicit Findings(std::string rule) : rule_(std::move(rule)) {}
  ~Findings() { EXPECT_EQ(count_, 0) << rule_ << ":\n" << list_; }
  void add(const SourceFile& file, int line, const std::string& what) {
    add("src/" + file.name + ":" + std::to_string(line) + ": " + what);
  }
  void add(const std::string& what) {
    ++count_;
    list_ += "  " + what + "\n";
  }

 private:
  std::string rule_;
  std::string list_;
  int count_ = 0;
};

/// Calls found(line, match) for each match in a text that may have several lines.
template <class F>
void each_match(const Text& text, const std::regex& pattern, F found) {
  for (std::sregex_iterator at(text.text.begin(), text.text.end(), pattern), end; at != end; ++at) {
    const auto before = text.text.begin() + at->position();
    found(text.line + static_cast<int>(std::count(text.text.begin(), before, '\n')), at->str());
  }
}

std::vector<Text> prose(const SourceFile& file) {
  std::vector<Text> all = file.comments;
  all.insert(all.end(), file.strings.begin(), file.strings.end());
  return all;
}

/// A name in the words it is made of: CurveSpec and curve_spec are "curve spec".
std::string in_words(const std::string& name) {
  std::string words;
  for (const char byte : name) {
    if (std::isupper(static_cast<unsigned char>(byte)) && !words.empty() && words.back() != ' ') words += ' ';
    words += byte == '_' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(byte)));
  }
  return words;
}

TEST(House, includes_follow_the_table_of_folders) {
  Findings findings("includes that the table of folders does not allow");
  const std::regex include(R"re(#include ["<]([^">]+\.hpp)[">])re");
  for (const SourceFile& file : sources()) {
    const auto row = allowed.find(room(file.name));
    if (row == allowed.end()) {
      findings.add(file, 1, "the folder is not in the table");
      continue;
    }
    each_match({1, file.code}, include, [&](int line, const std::string& match) {
      const std::string header = match.substr(match.find_first_of("\"<") + 1);
      const std::string to = room(header);
      if (to == row->first || row->second.contains(to) || !allowed.contains(to)) return;
      findings.add(file, line, row->first + " may not include " + header.substr(0, header.size() - 1));
    });
  }
}

TEST(House, packages_are_included_where_they_belong) {
  Findings findings("headers of packages outside their place");
  const std::regex include(R"re(#include ["<][^">]+[">])re");
  for (const SourceFile& file : sources()) {
    each_match({1, file.code}, include, [&](int line, const std::string& match) {
      const std::string header = match.substr(10, match.size() - 11);
      if (room(file.name) == "tcb/spline" && !header.starts_with("tcb/spline/") &&
          header.find_first_of("/.") != std::string::npos) {
        findings.add(file, line, header + " is not of the standard library");
      }
      auto package = packages.find(header);
      if (package == packages.end()) package = packages.find(header.substr(0, header.find('/')));
      if (package == packages.end()) return;
      const auto here = [&](const std::string& place) { return file.name.starts_with(place); };
      if (std::ranges::none_of(package->second, here)) findings.add(file, line, header);
    });
  }
}

TEST(House, options_are_spelled_in_cli_only) {
  Findings findings("options spelled outside src/cli");
  const std::regex option(R"re((^|[^-\w!])--[a-z][-\w]*)re");
  for (const SourceFile& file : sources()) {
    if (file.name.starts_with("cli/")) continue;
    for (const Text& text : prose(file)) {
      each_match(text, option, [&](int line, const std::string& match) { findings.add(file, line, match); });
    }
  }
}

TEST(House, messages_are_not_data) {
  Findings findings("what() used outside error.hpp, main.cpp, app/batch.cpp and cli/");
  for (const SourceFile& file : sources()) {
    if (file.name == "error.hpp" || file.name == "main.cpp" || file.name == "run/batch.cpp" ||
        room(file.name) == "cli") {
      continue;
    }
    each_match({1, file.code}, std::regex(R"re(\bwhat\(\))re"),
               [&](int line, const std::string& match) { findings.add(file, line, match); });
  }
}

TEST(House, messages_are_composed_in_cli_only) {
  Findings findings("words of errors outside src/cli, src/app and main.cpp");
  for (const SourceFile& file : sources()) {
    if (room(file.name) == "cli" || room(file.name) == "app" || file.name == "main.cpp") continue;
    each_match({1, file.code}, std::regex(R"re(\berror_(message|text)\b)re"),
               [&](int line, const std::string& match) { findings.add(file, line, match); });
  }
}

/// A pattern for the retired words.
std::regex retired_words(std::regex::flag_type flags = std::regex::ECMAScript) {
  std::string any;
  for (const std::string& word : retired) any += (any.empty() ? "" : "|") + word;
  return std::regex("\\b(" + any + ")\\b", flags);
}

TEST(House, retired_words_do_not_come_back) {
  Findings findings("retired words in comments and strings");
  const std::regex words = retired_words(std::regex::icase);
  for (const SourceFile& file : sources()) {
    for (const Text& text : prose(file)) {
      each_match(text, words, [&](int line, const std::string& match) { findings.add(file, line, match); });
    }
  }
}

TEST(House, documents_and_comments_of_tests_use_no_retired_words) {
  Findings findings("retired words in documents and in comments of tests");
  const std::regex words = retired_words(std::regex::icase);
  const auto look = [&](const std::string& name, const Text& text) {
    each_match(text, words, [&](int line, const std::string& match) {
      findings.add(name + ":" + std::to_string(line) + ": " + match);
    });
  };
  for (const char* name : {"README.md", "CHANGELOG.md", "man/tcbsample.1.in", "src/README.md", "samples/README.md",
                           "samples/cluster/README.md", "samples/golden/README.md", "samples/pieces/README.md",
                           "samples/vectors/README.md", "tests/bench/README.md"}) {
    look(name, {1, house::read_text(project / name)});
  }
  for (const SourceFile& file : house::read_sources(project / "tests")) {
    for (const Text& comment : file.comments) look("tests/" + file.name, comment);
  }
}

TEST(House, retired_names_do_not_come_back) {
  Findings findings("retired names in code");
  const std::regex words = retired_words();
  std::map<std::string, bool> known;
  for (const SourceFile& file : sources()) {
    for (const Text& token : house::tokens(file.code)) {
      const auto [entry, first] = known.try_emplace(token.text);
      if (first) {
        entry->second = retired_names.contains(token.text) || std::regex_search(in_words(token.text), words);
      }
      if (entry->second) findings.add(file, token.line, token.text);
    }
    if (std::regex_search(in_words(file.stem()), words)) findings.add(file, 1, "the file's name");
  }
}

TEST(House, a_name_is_given_once) {
  Findings findings("headers or types that share a name");
  std::map<std::string, std::string> headers;
  std::map<std::string, std::string> defined;
  for (const SourceFile& file : sources()) {
    if (file.name.ends_with(".hpp")) {
      const auto [first, made] = headers.try_emplace(file.base(), file.name);
      if (!made) findings.add(file, 1, "src/" + first->second + " has this name too");
    }
    for (const Text& type : house::types(file)) {
      const auto [first, made] = defined.try_emplace(type.text, file.name);
      if (!made) findings.add(file, type.line, type.text + " is in src/" + first->second + " too");
    }
  }
}

TEST(House, no_folder_or_file_is_a_drawer) {
  Findings findings("names that say nothing");
  const std::regex drawer("utils?|common|misc|types?|helpers?");
  for (const SourceFile& file : sources()) {
    const fs::path name = fs::path(file.name).replace_extension();
    for (const fs::path& part : name) {
      if (std::regex_match(part.string(), drawer)) findings.add(file, 1, part.string());
    }
  }
}

TEST(House, files_and_folders_have_their_size) {
  Findings findings("sizes");
  std::map<std::string, int> folders;
  std::vector<int> lines;
  std::vector<std::string> small;
  for (const SourceFile& file : sources()) {
    ++folders[file.folder()];
    lines.push_back(file.lines());
    if (tables.contains(file.name)) continue;
    if (file.lines() > 300) findings.add(file, 1, std::to_string(file.lines()) + " lines; at most 300");
    if (file.lines() < 30) small.push_back(file.name);
  }
  for (const auto& [folder, count] : folders) {
    if (count > 15) findings.add("src/" + folder + ": " + std::to_string(count) + " files; at most 15");
  }
  if (small.size() > 13) {
    for (const std::string& name : small) findings.add("src/" + name + ": under 30 lines, as at most 13 files may be");
  }
  std::ranges::sort(lines);
  const int median = lines.at(lines.size() / 2);
  if (median < 90 || median > 200) findings.add("median of lines: " + std::to_string(median) + "; 90 to 200");
}

TEST(House, first_lines_name_the_contents) {
  Findings findings("files whose first line is no comment of one sentence");
  for (const SourceFile& file : sources()) {
    if (!std::regex_search(file.text, std::regex(R"re(^// [A-Z`"][^\n]{8,}[.:,\w])re"))) findings.add(file, 1, "");
  }
}

TEST(House, every_error_is_thrown_and_has_words) {
  Findings findings("error codes");
  std::vector<std::string> codes;
  std::map<std::string, int> worded;
  std::map<std::string, int> thrown;
  for (const SourceFile& file : sources()) {
    const std::vector<Text> all = house::tokens(file.code);
    for (std::size_t i = 0; i + 3 < all.size(); ++i) {
      if (all[i].text != "ErrorCode") continue;
      if (file.name == "error.hpp" && all[i + 1].text == "{") {
        for (std::size_t code = i + 2; all[code].text != "}"; ++code) {
          if (all[code].text != ",") codes.push_back(all[code].text);
        }
      } else if (all[i + 1].text == ":") {
        ++(file.name.starts_with("cli/remedies") ? worded : thrown)[all[i + 3].text];
      }
    }
  }
  for (const std::string& code : codes) {
    if (worded[code] != 1) findings.add(code + ": worded " + std::to_string(worded[code]) + " times in cli/remedies");
    if (thrown[code] == 0) findings.add(code + ": never thrown");
  }
  EXPECT_FALSE(codes.empty());
}

/// tests/FOLDER for src/FOLDER; the library's tests are in tests/spline.
std::string test_of(const SourceFile& file) {
  const std::string name = file.name.starts_with("tcb/") ? file.name.substr(4) : file.name;
  return "tests/" + fs::path(name).replace_extension().generic_string() + "_test.cpp";
}

TEST(House, tests_mirror_the_sources) {
  Findings findings("sources without a test of their name, and tests without a source");
  std::set<std::string> expected{"tests/house_test.cpp"};
  for (const SourceFile& file : sources()) {
    expected.insert(test_of(file));
    if (!file.name.ends_with(".cpp") || file.name == "main.cpp") continue;
    if (!fs::exists(project / test_of(file))) findings.add(file, 1, test_of(file) + " is missing");
  }
  for (const auto& entry : fs::recursive_directory_iterator(project / "tests")) {
    const std::string name = entry.path().lexically_relative(project).generic_string();
    const bool apart = name.starts_with("tests/library/") || name.starts_with("tests/fuzz/");
    if (name.ends_with("_test.cpp") && !apart && !expected.contains(name)) findings.add(name + ": no source");
  }
}

TEST(House, the_readme_shows_every_folder_and_the_glossary) {
  Findings findings("src/README.md");
  const std::string readme = house::read_text(project / "src/README.md");
  std::set<std::string> folders;
  for (const SourceFile& file : sources()) folders.insert(file.folder());
  for (const std::string& folder : folders) {
    if (!folder.empty() && readme.find("`" + folder + "/`") == std::string::npos) findings.add(folder + "/ is missing");
  }
  const std::regex shown(R"re(`([a-z_/]+(?:/|\.[ch]pp))`)re");
  each_match({1, readme}, shown, [&](int line, const std::string& match) {
    const std::string name = match.substr(1, match.size() - 2);
    if (!fs::exists(project / "src" / name) && !fs::exists(project / name)) {
      findings.add("line " + std::to_string(line) + ": " + match + " does not exist");
    }
  });
  if (readme.find("## Glossary") == std::string::npos) findings.add("no glossary");
  if (std::ranges::count(readme, '\n') > 120) findings.add("longer than 120 lines");
}

}  // namespace
