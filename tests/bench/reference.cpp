// A yardstick of build times: a small program with three packages of this project. tests/bench/reference compiles it.
#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  CLI::App app("reference");
  std::string text = "[]";
  std::vector<double> values;
  app.add_option("text", text);
  app.add_option("-v", values);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  const auto json = nlohmann::json::parse(text);
  for (const auto& value : json) values.push_back(value.get<double>());
  std::sort(values.begin(), values.end());
  fmt::print("{} {}\n", json.dump(), values.size());
  return 0;
}
