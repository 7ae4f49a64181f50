// Atomic outputs: files that appear when they are complete, permissions, links, and errors.
#include "io/atomic_output.hpp"

#include <sys/resource.h>
#include <sys/stat.h>

#include "io/file_fixture.hpp"

namespace tcb {
namespace {

TEST_F(FileTest, folders_are_made_with_those_above) {
  make_folder(path("a/b/c"));
  EXPECT_TRUE(fs::is_directory(path("a/b/c")));
  EXPECT_EQ(error_of([&] { make_folder(path("a/b")); }), "no error") << "it is there already";
  made("file", "");
  EXPECT_EQ(error_of([&] { make_folder(path("file/a")); }),
            "usage: " + path("file/a") + ": error: the folder cannot be created: Not a directory");
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

TEST_F(FileTest, an_output_replaces_a_file_and_the_target_of_a_link) {
  made("old", "a longer text than the new one");
  fs::create_symlink(path("old"), path("link"));
  Output output(path("link"));
  output.write("new");
  output.commit();
  EXPECT_EQ(text_of(path("old")), "new");
  EXPECT_TRUE(fs::is_symlink(path("link")));
}

TEST_F(FileTest, an_output_does_not_inherit_setuid_and_setgid) {
  made("old", "");
  ASSERT_EQ(::chmod(path("old").c_str(), 06755), 0);
  Output output(path("old"));
  output.commit();
  EXPECT_EQ(fs::status(path("old")).permissions(), static_cast<fs::perms>(0755));
}

TEST_F(FileTest, files_of_others_with_names_of_temporary_files_are_not_touched) {
  made(".out.tcbsample", "mine");
  Output output(path("out"));
  output.commit();
  EXPECT_EQ(text_of(path(".out.tcbsample")), "mine");
  EXPECT_EQ(entries(), 2U);
}

TEST_F(FileTest, an_output_without_a_temporary_file_for_its_beginning_leaves_nothing) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  const int next = ::dup(0);
  ::close(next);
  const rlimit one_more{static_cast<rlim_t>(next) + 1, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &one_more), 0);
  const std::string error = error_of([&] { Output output(path("out.npy.gz"), true); });
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_NE(error.find("Too many open files"), std::string::npos) << error;
  EXPECT_EQ(entries(), 0U);
}

TEST_F(FileTest, an_output_that_cannot_be_written_is_refused_at_once) {
  EXPECT_EQ(error_of([&] { Output output(path("none/out")); }),
            "usage: " + path("none/out") + ": error: cannot be written: No such file or directory");
  EXPECT_EQ(error_of([&] { Output output(folder_.path().string()); }),
            "usage: " + folder_.path().string() + ": error: cannot be written: Is a directory");
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
