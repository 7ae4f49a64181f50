// A folder of its own for each test of files, and standard streams as they were afterwards.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "error.hpp"
#include "io/terminal.hpp"
#include "temporary_folder.hpp"

namespace tcb {

namespace fs = std::filesystem;

template <class F>
std::string error_of(F f) {
  try {
    f();
  } catch (const Error& error) {
    return (error.exit() == Exit::usage ? "usage: " : "data: ") + error_text(error);
  }
  return "no error";
}

class FileTest : public testing::Test {
 protected:
  void TearDown() override {
    for (const int number : {0, 1}) {
      if (saved_[number] >= 0) ::dup2(saved_[number], number);
      if (saved_[number] >= 0) ::close(saved_[number]);
    }
  }

  std::string path(const std::string& name) const { return folder_.path(name); }
  std::string made(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  static std::string text_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
  }

  /// Puts a descriptor in the place of standard input (0) or output (1).
  void replace(int number, int by) {
    saved_[number] = ::dup(number);
    ASSERT_EQ(::dup2(by, number), number);
    ::close(by);
  }
  /// Standard input is a pipe from here on; the end to write to.
  int pipe_to_input() {
    int ends[2] = {-1, -1};
    EXPECT_EQ(::pipe(ends), 0);
    replace(0, ends[0]);
    return ends[1];
  }

  TemporaryFolder folder_;
  int saved_[2] = {-1, -1};
};

}  // namespace tcb
