// The house: which folder may include which, file and function lengths, and the map in src/README.md.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path source = fs::path(SOURCE_FOLDER) / "src";

std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(source)) {
    const auto ending = entry.path().extension();
    if (ending == ".hpp" || ending == ".cpp") files.push_back(entry.path());
  }
  return files;
}

/// The room that a file is in: its folder, or at the top its own name without ending.
std::string room(const fs::path& relative) {
  return relative.has_parent_path() ? relative.begin()->string() : relative.stem().string();
}

// Who may include whom. What is not listed here is an arrow against the flow.
const std::map<std::string, std::set<std::string>> allowed{
    {"main", {"cli", "resample", "compare", "file", "unfinished", "error"}},
    {"task", {"comparison", "recorder", "curves", "settings", "sampler", "format", "golden"}},
    {"comparison", {}},
    {"compare",
     {"task", "comparison", "path", "curves", "curve_plan", "fields", "lookup", "rows", "sampler", "format", "spline",
      "settings", "file", "stream", "names", "error"}},
    {"cli",
     {"task", "file", "order", "curve_plan", "fields", "settings", "sampler", "golden", "format", "spline", "names",
      "error"}},
    {"resample", {"task", "explain", "path", "rows", "inputs", "batch", "writer", "report", "error"}},
    {"batch", {"inputs", "report", "stream", "error"}},
    {"inputs", {"task", "file", "error"}},
    {"writer", {"task", "path", "labels", "recorder", "format", "file", "error"}},
    {"report", {"task", "file", "error"}},
    {"explain", {"task", "path", "curves", "order", "fields", "sampler", "format", "file"}},
    {"path",
     {"closed", "sparse", "lookup", "golden", "rows", "kept_keys", "pieces", "curve_plan", "sampler", "format",
      "stream", "error"}},
    {"curves", {"grouping", "order", "blocks", "format", "stream", "error"}},
    {"grouping", {"blocks", "format", "stream"}},
    {"order", {"blocks", "format", "stream", "error"}},
    {"blocks", {"format"}},
    {"recorder", {"rows", "sha256", "format", "stream", "error"}},
    {"sha256", {}},
    {"labels", {"rows", "format", "stream"}},
    {"sparse", {"pieces", "stream", "error"}},
    {"lookup", {"rows", "pieces", "sampler", "stream"}},
    {"rows", {"fields", "pieces", "sampler", "format", "spline", "stream", "error"}},
    {"golden", {"rows", "fields", "sampler", "format", "spline", "error"}},
    {"fields", {"sampler", "format", "spline"}},
    {"closed", {"kept_keys", "pieces", "curve_plan", "sampler", "format", "spline", "error"}},
    {"kept_keys", {"pieces"}},
    {"pieces", {"format", "spline", "stream", "error"}},
    {"curve_plan", {"settings", "sampler", "format", "spline", "names", "error"}},
    {"sampler", {"spline", "error"}},
    {"format", {"spline", "settings", "names", "stream", "error"}},
    {"settings", {}},
    {"file", {"unfinished", "stream", "error"}},
    {"unfinished", {"error"}},
    {"spline", {}},
    {"stream", {}},
    {"names", {"error"}},
    {"error", {}},
};

TEST(Layers, includes_point_one_way) {
  const std::regex include(R"re(^#include "([^"]+)")re");
  for (const fs::path& file : sources()) {
    const std::string from = room(fs::relative(file, source));
    ASSERT_TRUE(allowed.contains(from)) << file << " is in no known room";
    for (const std::string& line : lines_of(file)) {
      std::smatch match;
      if (!std::regex_search(line, match, include)) continue;
      const std::string to = room(fs::path(match[1].str()));
      EXPECT_TRUE(to == from || allowed.at(from).contains(to)) << file << " includes " << match[1];
    }
  }
}

TEST(Layers, the_core_includes_the_standard_library_only) {
  for (const fs::path& file : sources()) {
    if (room(fs::relative(file, source)) != "spline") continue;
    for (const std::string& line : lines_of(file)) {
      const bool foreign = line.starts_with("#include <") && line.find('/') != std::string::npos;
      EXPECT_FALSE(foreign) << file << ": " << line;
    }
  }
}

TEST(Layers, nlohmann_json_appears_in_the_json_reader_only) {
  for (const fs::path& file : sources()) {
    if (file.stem().string().starts_with("json")) continue;
    for (const std::string& line : lines_of(file)) {
      EXPECT_EQ(line.find("nlohmann"), std::string::npos) << file << ": " << line;
    }
  }
}

TEST(Layers, files_stay_short) {
  for (const fs::path& file : sources()) {
    if (file.parent_path().filename() == "cli" && file.stem() == "options") continue;
    EXPECT_LE(lines_of(file).size(), 250U) << file;
  }
}

TEST(Layers, the_map_shows_each_file_with_its_first_line) {
  std::set<std::string> shown;
  const std::regex entry(R"re(^\| `([^`]+)` \| (.+) \|$)re");
  for (const std::string& line : lines_of(source / "README.md")) {
    std::smatch match;
    if (!std::regex_match(line, match, entry)) continue;
    const fs::path file = source / match[1].str();
    ASSERT_TRUE(fs::exists(file)) << "the map shows " << match[1] << ", which is not there";
    EXPECT_EQ("// " + match[2].str(), lines_of(file).at(0)) << file;
    shown.insert(match[1]);
  }
  for (const fs::path& file : sources()) {
    const bool in_map = shown.contains(fs::relative(file, source).string());
    const bool by_header = file.extension() == ".cpp" && fs::exists(fs::path(file).replace_extension(".hpp"));
    EXPECT_TRUE(in_map || by_header) << file << " is missing in src/README.md";
  }
}

}  // namespace
