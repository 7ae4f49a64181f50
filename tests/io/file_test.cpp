// Files: bytes in as they come, standard input, and outputs that appear whole or not at all.
#include "io/file.hpp"
#include "cli/remedies.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "error.hpp"

namespace tcb {
namespace {

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

/// A folder of its own for each test, and standard input and output as they were afterwards.
class FileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "tcbsample_XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override {
    for (const int number : {0, 1}) {
      if (saved_[number] >= 0) ::dup2(saved_[number], number);
      if (saved_[number] >= 0) ::close(saved_[number]);
    }
    fs::remove_all(folder_);
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string made(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  static std::string text_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
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

  fs::path folder_;
  int saved_[2] = {-1, -1};
};

TEST_F(FileTest, all_bytes_come_in_pieces_of_256_kib_at_most) {
  std::string text(600'000, '\0');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>(i * 31 % 256);
  const auto source = read_file(made("in", text));
  std::string back;
  while (const auto piece = source()) {
    EXPECT_LE(piece->size(), 256U * 1024);
    EXPECT_FALSE(piece->empty());
    back += *piece;
  }
  EXPECT_EQ(back, text);
  EXPECT_EQ(source(), std::nullopt);
}

TEST_F(FileTest, an_empty_file_has_no_pieces) { EXPECT_EQ(read_file(made("in", ""))(), std::nullopt); }

TEST_F(FileTest, standard_input_gives_bytes_as_they_come) {
  const int end = pipe_to_input();
  const auto source = read_file("-");
  ASSERT_EQ(::write(end, "0,1\n", 4), 4);
  EXPECT_EQ(source(), "0,1\n") << "nothing waits for a full piece";
  ASSERT_EQ(::write(end, "2", 1), 1);
  EXPECT_EQ(source(), "2");
  ::close(end);
  EXPECT_EQ(source(), std::nullopt);
  EXPECT_TRUE(is_live("-"));
}

TEST_F(FileTest, what_cannot_be_read_is_refused) {
  EXPECT_EQ(error_of([&] { read_file(path("none")); }),
            "usage: " + path("none") + ": error: cannot be opened: No such file or directory");
  EXPECT_EQ(error_of([&] { read_file(folder_.string())(); }),
            "usage: " + folder_.string() +
                ": error: cannot be read: Is a directory; give --recursive and --output-dir for the files in it");
}

TEST_F(FileTest, names_for_messages) {
  EXPECT_EQ(shown_name("-"), "standard input");
  EXPECT_EQ(shown_name("a/b.csv"), "a/b.csv");
}

TEST_F(FileTest, pipes_are_live_and_files_are_not) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_TRUE(is_live(path("pipe")));
  EXPECT_FALSE(is_live(made("file", "")));
  EXPECT_FALSE(is_live(path("none")));
  replace(0, ::open(path("file").c_str(), O_RDONLY));
  EXPECT_FALSE(is_live("-")) << "a file as standard input";
}

TEST_F(FileTest, folders_are_made_with_those_above) {
  make_folder(path("a/b/c"));
  EXPECT_TRUE(fs::is_directory(path("a/b/c")));
  EXPECT_EQ(error_of([&] { make_folder(path("a/b")); }), "no error") << "it is there already";
  made("file", "");
  EXPECT_EQ(error_of([&] { make_folder(path("file/a")); }),
            "usage: " + path("file/a") + ": error: cannot be made: Not a directory");
}

TEST_F(FileTest, an_output_appears_when_it_is_complete) {
  {
    Output output(path("out"));
    output.write(std::string(1'000'000, 'a'));
    EXPECT_FALSE(fs::exists(path("out")));
    output.write("\n");
    output.commit();
    EXPECT_EQ(text_of(path("out")), std::string(1'000'000, 'a') + "\n");
  }
  EXPECT_EQ(entries(), 1U) << "nothing else is left";
}

TEST_F(FileTest, an_output_that_is_not_complete_leaves_nothing_and_changes_nothing) {
  made("old", "before");
  for (const char* name : {"old", "new"}) {
    Output output(path(name));
    output.set_live(true);
    output.write("half");
  }
  EXPECT_EQ(text_of(path("old")), "before");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(FileTest, an_output_takes_the_place_of_a_file_and_of_what_a_link_points_to) {
  made("old", "a longer text than the new one");
  fs::create_symlink(path("old"), path("link"));
  Output output(path("link"));
  output.write("new");
  output.commit();
  EXPECT_EQ(text_of(path("old")), "new");
  EXPECT_TRUE(fs::is_symlink(path("link")));
}

TEST_F(FileTest, an_output_has_the_rights_of_any_new_file) {
  const mode_t mask = ::umask(0027);
  Output output(path("out"));
  output.commit();
  ::umask(mask);
  EXPECT_EQ(fs::status(path("out")).permissions(), static_cast<fs::perms>(0640));
}

TEST_F(FileTest, an_output_that_cannot_be_written_is_refused_at_once) {
  EXPECT_EQ(error_of([&] { Output output(path("none/out")); }),
            "usage: " + path("none/out") + ": error: cannot be written: No such file or directory");
  EXPECT_EQ(error_of([&] { Output output(folder_.string()); }),
            "usage: " + folder_.string() + ": error: cannot be written: Is a directory");
}

TEST_F(FileTest, a_full_device_is_an_error) {
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  EXPECT_EQ(error_of([] {
              Output output("/dev/full");
              output.write("text");
              output.commit();
            }),
            "usage: /dev/full: error: cannot be written: No space left on device");
}

TEST_F(FileTest, standard_output_gets_each_text_at_once_only_when_it_is_live) {
  int ends[2] = {-1, -1};
  ASSERT_EQ(::pipe2(ends, O_NONBLOCK), 0);
  replace(1, ends[1]);
  const auto arrived = [&] {
    char text[64];
    const ssize_t count = ::read(ends[0], text, sizeof text);
    return std::string(text, count > 0 ? static_cast<std::size_t>(count) : 0);
  };
  Output output("-");
  output.write("held, ");
  const std::string before = arrived();
  output.set_live(true);
  output.write("live");
  const std::string live = arrived();
  output.set_live(false);
  output.write("rest");
  output.commit();
  const std::string rest = arrived();
  ::close(ends[0]);
  EXPECT_EQ(before, "");
  EXPECT_EQ(live, "held, live");
  EXPECT_EQ(rest, "rest");
}

}  // namespace
}  // namespace tcb
