// Input files: parts as they arrive, errors, and which paths are live.
#include "io/input_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <chrono>
#include <optional>
#include <thread>

#include "io/digest.hpp"
#include "io/file_fixture.hpp"

namespace tcb {

namespace {

TEST_F(FileTest, all_bytes_come_in_pieces_of_at_most_256_kib) {
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

TEST_F(FileTest, the_beginning_of_a_pipe_is_one_part_as_long_as_it_comes_without_a_pause) {
  const int end = pipe_to_input();
  const auto source = read_file("-");
  std::string text;
  std::thread writer([&] {
    for (int i = 0; i < 200; ++i) {
      const std::string piece = std::to_string(i) + (i % 20 == 19 ? "\n" : ",");
      text += piece;
      EXPECT_EQ(::write(end, piece.data(), piece.size()), std::ssize(piece));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    EXPECT_EQ(::write(end, "end", 3), 3);
    ::close(end);
  });
  const auto first = source(), last = source();
  writer.join();
  EXPECT_EQ(first, text);
  EXPECT_EQ(last, "end");
  EXPECT_EQ(source(), std::nullopt);
}

TEST_F(FileTest, later_parts_of_a_pipe_come_at_once) {
  const int end = pipe_to_input();
  const auto source = read_file("-");
  const std::string lines(16, '\n');
  ASSERT_EQ(::write(end, lines.data(), lines.size()), std::ssize(lines));
  EXPECT_EQ(source(), lines);
  ASSERT_EQ(::write(end, "0", 1), 1);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(source(), "0");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(90));
  ::close(end);
}

TEST_F(FileTest, a_pipe_is_waited_for_a_second_in_total) {
  const int end = pipe_to_input();
  const InputBytes input = open_file("-");
  ASSERT_EQ(::write(end, "0", 1), 1);
  EXPECT_TRUE(input.arrive());
  EXPECT_EQ(input.bytes(), "0");
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(input.arrive());
  EXPECT_GT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(900));
  EXPECT_FALSE(input.arrive());
  ::close(end);
  EXPECT_TRUE(input.arrive()) << "its end is there";
  EXPECT_TRUE(open_file(made("file", "")).arrive());
}

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
  EXPECT_EQ(
      error_of([&] { read_file(folder_.path().string())(); }),
      "usage: " + folder_.path().string() +
          ": error: this is a folder; expected a file; give --recursive and --output-dir to process the files in it");
}

TEST_F(FileTest, a_change_is_seen_also_with_the_old_size_and_time) {
  const std::string file = made("in", "abc");
  const ChangeWatch watch(file), none(path("none")), standard_input("-");
  EXPECT_EQ(watch.change(), FileChange::none);
  struct stat before {};
  ASSERT_EQ(::stat(file.c_str(), &before), 0);
  made("in", "abd");
  const timespec times[2] = {before.st_atim, before.st_mtim};
  ASSERT_EQ(::utimensat(AT_FDCWD, file.c_str(), times, 0), 0);
  EXPECT_EQ(watch.change(), FileChange::contents_or_status);
  made("in", "abcd");
  EXPECT_EQ(watch.change(), FileChange::contents);
  EXPECT_EQ(none.change(), FileChange::none);
  EXPECT_EQ(standard_input.change(), FileChange::none);
}

/// Reads a file of several parts, and calls change(path) after the first one. The bytes, or the error.
template <class Change>
std::string read_while(const std::string& file, const Change& change) {
  return error_of([&] {
    const auto source = read_file(file);
    std::string bytes = source().value();
    change(file);
    while (const auto more = source()) bytes += *more;
    throw Error(Exit::done, std::to_string(bytes.size()));
  });
}

TEST_F(FileTest, links_names_and_modes_may_change_while_a_file_is_read) {
  const std::string text(600'000, 'x'), whole = "data: tcbsample: error: 600000";
  const auto times = [](const std::string& file) {
    struct stat status {};
    EXPECT_EQ(::stat(file.c_str(), &status), 0);
    return std::array{status.st_atim, status.st_mtim};
  };
  EXPECT_EQ(read_while(made("mode", text), [](const std::string& file) { ::chmod(file.c_str(), 0600); }), whole);
  EXPECT_EQ(read_while(made("link", text), [](const std::string& file) { fs::create_hard_link(file, file + ".2"); }),
            whole);
  EXPECT_EQ(read_while(made("name", text), [](const std::string& file) { fs::rename(file, file + ".2"); }), whole);
  EXPECT_EQ(read_while(made("none", text), [](const std::string& file) { fs::remove(file); }), whole);
  for (const long place : {0L, 300'000L, 599'999L}) {
    const auto change = [&](const std::string& file) {
      const auto before = times(file);
      const int other = ::open(file.c_str(), O_WRONLY);
      EXPECT_EQ(::pwrite(other, "y", 1, place), 1);
      ::close(other);
      EXPECT_EQ(::utimensat(AT_FDCWD, file.c_str(), before.data(), 0), 0);
    };
    const std::string file = made("same", text);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // so that the change has another time
    const std::string result = read_while(file, change);
    // What is not read yet is read as it is then.
    EXPECT_TRUE(place == 0 ? result.find("the file changed while it was read") != std::string::npos : result == whole)
        << result;
  }
}

TEST_F(FileTest, standard_input_that_begins_within_a_file_may_change_its_mode) {
  const std::string file = made("in", std::string(600'000, 'x'));
  const int opened = ::open(file.c_str(), O_RDONLY);
  ASSERT_EQ(::lseek(opened, 5, SEEK_SET), 5);
  replace(0, opened);
  const auto source = read_file("-");
  std::size_t size = source().value().size();
  ASSERT_EQ(::chmod(file.c_str(), 0600), 0);
  while (const auto more = source()) size += more->size();
  EXPECT_EQ(size, 599'995U);
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

// Source: FIPS 180-4, examples by NIST.
constexpr const char* abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
constexpr const char* nothing = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";

TEST(Sha256, is_that_of_the_standard) {
  Sha256 sha256;
  EXPECT_EQ(sha256.digest(), nothing);
  sha256.add("abc");
  EXPECT_EQ(sha256.digest(), abc);
}

TEST(Sha256, takes_bytes_in_parts_and_starts_again) {
  Sha256 sha256;
  for (const char* part : {"a", "", "bc"}) sha256.add(part);
  EXPECT_EQ(sha256.digest(), abc);
  EXPECT_EQ(sha256.digest(), nothing);
}

}  // namespace

}  // namespace tcb
