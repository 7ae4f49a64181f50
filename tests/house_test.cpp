// House rules: which room includes which, where packages are included, and that the maps name files that exist.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path project = SOURCE_FOLDER;
const fs::path src = project / "src";

/// Room -> rooms whose headers it may include. A room is a folder of src/ with its subfolders, or a file at its top.
const std::map<std::string, std::set<std::string>> allowed{
    {"tcb", {}},
    {"stream", {}},
    {"error", {}},
    {"text", {"error"}},
    {"numbers", {"tcb", "text", "error"}},
    {"io", {"stream", "text", "numbers", "error"}},
    {"schema", {"tcb", "stream", "text", "numbers", "error"}},
    {"read", {"schema", "tcb", "stream", "text", "numbers", "io", "error"}},
    {"keys", {"schema", "tcb", "stream", "text", "numbers", "error"}},
    {"sample", {"keys", "schema", "tcb", "stream", "text", "numbers", "error"}},
    {"exact", {"sample", "keys", "schema", "tcb", "stream", "text", "numbers", "error"}},
    {"write", {"sample", "schema", "tcb", "stream", "text", "numbers", "io", "error"}},
    // The list of formats names the halves that read and write; these know no format.
    {"formats", {"read", "write", "sample", "schema", "tcb", "stream", "text", "numbers", "io", "error"}},
    {"run",
     {"formats", "read", "keys", "sample", "exact", "write", "schema", "tcb", "stream", "text", "numbers", "io",
      "error"}},
    {"picture", {"keys", "sample", "schema", "tcb", "stream", "text", "numbers", "error"}},
    // The products beside resampling share the stages of run/ and the pictures, and do not know each other.
    {"plot",
     {"picture", "run", "formats", "read", "keys", "sample", "schema", "tcb", "stream", "text", "numbers", "io",
      "error"}},
    {"check",
     {"picture", "run", "formats", "read", "keys", "sample", "write", "schema", "tcb", "stream", "text", "numbers",
      "io", "error"}},
    {"fit",
     {"picture", "run", "formats", "read", "keys", "sample", "write", "schema", "tcb", "stream", "text", "numbers",
      "io", "error"}},
    {"limits",
     {"picture", "run", "formats", "read", "keys", "sample", "exact", "write", "schema", "tcb", "stream", "text",
      "numbers", "io", "error"}},
    // The command line makes the job of a product.
    {"cli",
     {"fit", "check", "limits", "plot", "picture", "run", "formats", "read", "keys", "sample", "write", "schema", "tcb",
      "text", "numbers", "io", "error"}},
    {"main", {"cli"}},
};

/// Package -> the rooms or files that may include it.
const std::map<std::string, std::vector<std::string>> packages{
    {"numbers/large_rational.hpp", {"numbers/rational.cpp", "exact/"}},
    {"nlohmann", {"read/json/", "write/camera_path.cpp", "write/gltf.cpp"}},
    {"boost", {"numbers/rational.cpp", "numbers/large_rational.hpp", "exact/", "limits/polynomial.hpp"}},
    {"fast_float", {"numbers/"}},
    {"CLI", {"cli/"}},
    {"nettle", {"io/"}},
    {"zlib.h", {"io/"}},
    {"zstd.h", {"io/"}},
};

struct SourceFile {
  std::string name;  ///< relative to src/, with slashes
  std::vector<std::string> lines;
};

std::vector<std::string> lines_of(const fs::path& path) {
  std::vector<std::string> lines;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

std::vector<SourceFile> read_sources() {
  std::vector<SourceFile> files;
  for (const auto& entry : fs::recursive_directory_iterator(src)) {
    if (!entry.is_regular_file() || entry.path().extension() == ".md") continue;
    files.push_back({entry.path().lexically_relative(src).generic_string(), lines_of(entry.path())});
  }
  std::ranges::sort(files, {}, &SourceFile::name);
  return files;
}

const std::vector<SourceFile>& sources() {
  static const std::vector<SourceFile> files = read_sources();
  return files;
}

/// "read" for read/csv/header.cpp, "main" for main.cpp.
std::string room_of(const std::string& file) { return file.substr(0, file.find_first_of("/.")); }

/// Calls found(file, line number, first group) for each match in a line of a source.
template <class F>
void each_match(const std::regex& pattern, F found) {
  for (const SourceFile& file : sources()) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string& line = file.lines[i];
      for (std::sregex_iterator at(line.begin(), line.end(), pattern), end; at != end; ++at) {
        found(file.name, i + 1, at->str(1));
      }
    }
  }
}

const std::regex include(R"re(^#include ["<]([^">]+)[">])re");

TEST(House, rooms_include_the_rooms_of_the_table) {
  each_match(include, [](const std::string& file, std::size_t line, const std::string& header) {
    const std::string from = room_of(file), to = room_of(header);
    ASSERT_TRUE(allowed.contains(from)) << "src/" << file << ": the room is not in the table";
    if (from == to || !allowed.contains(to) || !fs::is_regular_file(src / header)) return;  // not <limits>
    EXPECT_TRUE(allowed.at(from).contains(to)) << "src/" << file << ":" << line << ": includes " << header;
  });
}

TEST(House, the_library_is_used_by_its_public_headers) {
  each_match(include, [](const std::string& file, std::size_t line, const std::string& header) {
    if (room_of(file) == "tcb") return;
    EXPECT_FALSE(header.starts_with("tcb/spline/detail/")) << "src/" << file << ":" << line << ": " << header;
  });
}

TEST(House, packages_are_included_where_the_table_says) {
  each_match(include, [](const std::string& file, std::size_t line, const std::string& header) {
    const std::string found = "src/" + file + ":" + std::to_string(line) + ": includes " + header;
    if (room_of(file) == "tcb" && !header.starts_with("tcb/spline/")) {
      EXPECT_EQ(header.find_first_of("/."), std::string::npos) << found << ", which is not of the standard library";
    }
    auto package = packages.find(header);
    if (package == packages.end()) package = packages.find(header.substr(0, header.find('/')));
    if (package == packages.end()) return;
    const auto here = [&](const std::string& place) { return file.starts_with(place); };
    EXPECT_TRUE(std::ranges::any_of(package->second, here)) << found;
  });
}

/// The program never chooses a locale, and calls no function of C whose result depends on one.
TEST(House, nothing_depends_on_the_locale) {
  for (const std::string_view name :
       {"setlocale", "imbue",   "strtod",  "strtof",  "strtol",   "stod",    "stof",    "stoi",
        "stol",      "atof",    "atoi",    "isalpha", "isalnum",  "isdigit", "isspace", "isprint",
        "isupper",   "islower", "tolower", "toupper", "strftime", "strcoll"}) {
    const std::string call = std::string(name) + "(";
    for (const SourceFile& file : sources()) {
      for (std::size_t i = 0; i < file.lines.size(); ++i) {
        const std::string code = file.lines[i].substr(0, file.lines[i].find("//"));
        const std::size_t at = code.find(call);
        if (at == std::string::npos || (at > 0 && (std::isalnum(code[at - 1]) != 0 || code[at - 1] == '_'))) continue;
        ADD_FAILURE() << "src/" << file.name << ":" << i + 1 << ": " << name;
      }
    }
  }
}

/// Comments name files as in `read/csv/header.cpp`, `grid.hpp` or `tests/library`, relative to the project, to src/, to
/// the folder of the file, or by the name alone.
TEST(House, files_that_comments_name_exist) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(src)) names.insert(entry.path().filename().string());
  const std::regex named(
      R"re(//[^"]*?((?:[a-z_]+/)*[a-z_]+\.(?:cpp\.in|hpp|cpp|in|md|py|sh)\b|\b(?:src|tests|samples|man)/[\w/.-]*\w))re");
  each_match(named, [&](const std::string& file, std::size_t line, const std::string& name) {
    const bool exists = fs::exists(project / name) || fs::exists(src / name) ||
                        fs::exists((src / file).parent_path() / name) || names.contains(name);
    EXPECT_TRUE(exists) << "src/" << file << ":" << line << ": " << name << " does not exist";
  });
}

/// Markdown pages link to files that exist, and src/README.md has a row for each room and names no room that is gone.
TEST(House, links_of_pages_lead_to_files) {
  std::vector<fs::path> pages{project / "README.md"};
  for (const char* folder : {"src", "samples", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(project / folder)) {
      if (entry.path().extension() == ".md") pages.push_back(entry.path());
    }
  }
  const std::regex link(R"re(\]\(([^)#:]+)(?:#[^)]*)?\))re");
  for (const fs::path& page : pages) {
    for (const std::string& line : lines_of(page)) {
      for (std::sregex_iterator at(line.begin(), line.end(), link), end; at != end; ++at) {
        EXPECT_TRUE(fs::exists(page.parent_path() / at->str(1))) << page.string() << ": " << at->str(1);
      }
    }
  }
}

TEST(House, the_map_of_the_sources_shows_the_rooms) {
  std::string map;
  for (const std::string& line : lines_of(src / "README.md")) map += line + "\n";
  for (const auto& entry : fs::directory_iterator(src)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && name != "tcb") {
      EXPECT_NE(map.find("`" + name + "/`"), std::string::npos) << name << "/ is not in src/README.md";
    }
  }
  const std::regex shown(R"re(`([a-z_]+(?:/[a-z_]+)*(?:/|\.[ch]pp|\.in|\.py|\.sh))`)re");
  for (std::sregex_iterator at(map.begin(), map.end(), shown), end; at != end; ++at) {
    const std::string name = at->str(1);
    EXPECT_TRUE(fs::exists(src / name) || fs::exists(project / name)) << "src/README.md: " << name;
  }
}

}  // namespace
