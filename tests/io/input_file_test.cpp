// Input files: parts as they arrive, errors, and which paths are live.
#include "io/input_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <optional>

#include "io/file_fixture.hpp"
#include "io/sha256.hpp"

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
      error_of([&] { read_file(folder_.string())(); }),
      "usage: " + folder_.string() +
          ": error: this is a folder; expected a file; give --recursive and --output-dir to process the files in it");
}

TEST_F(FileTest, a_change_is_seen_also_with_the_old_size_and_time) {
  const std::string file = made("in", "abc");
  const ChangeWatch watch(file), none(path("none")), standard_input("-");
  EXPECT_FALSE(watch.has_changed());
  struct stat before {};
  ASSERT_EQ(::stat(file.c_str(), &before), 0);
  made("in", "abd");
  const timespec times[2] = {before.st_atim, before.st_mtim};
  ASSERT_EQ(::utimensat(AT_FDCWD, file.c_str(), times, 0), 0);
  EXPECT_TRUE(watch.has_changed());
  EXPECT_FALSE(none.has_changed() || standard_input.has_changed());
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
