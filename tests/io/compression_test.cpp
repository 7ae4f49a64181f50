// Compression: what is compressed is decompressed again, in parts of any size; broken and cut data are refused.
#include "io/compression.hpp"

#include <gmock/gmock.h>

#include <string>

#include "error.hpp"

namespace tcb {
namespace {

using namespace std::string_literals;
using testing::HasSubstr;

/// A text in parts of this size.
Source<std::string> parts_of(std::string text, std::size_t size) {
  return [text = std::move(text), size, at = std::size_t{0}]() mutable -> std::optional<std::string> {
    if (at >= text.size()) return std::nullopt;
    std::string part = text.substr(at, size);
    at += size;
    return part;
  };
}

std::string all_of(const Source<std::string>& source) {
  std::string text;
  while (const auto part = source()) text += *part;
  return text;
}

std::string unpacked(const std::string& bytes, std::size_t size = 1000) {
  return all_of(decompressed(parts_of(bytes, size)));
}

std::string packed(Compression compression, const std::string& text, std::size_t size = 100'000) {
  Compressor compressor(compression);
  std::string bytes;
  for (std::size_t at = 0; at < text.size(); at += size) bytes += compressor.add(text.substr(at, size));
  return bytes + compressor.add("", true);
}

std::string long_text() {
  std::string text;
  for (int i = 0; i < 200'000; ++i) text += std::to_string(i * 7919 % 100'003) + "\n";
  return text;
}

/// The message of the error of these bytes; "": they are taken.
std::string refusal(const std::string& bytes) {
  try {
    unpacked(bytes);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::data);
    return error.message();
  }
  return "";
}

/// "0,1\n" as gzip -n wrote it.
const std::string by_gzip = "\x1f\x8b\x08\0\0\0\0\0\0\x03\x33\xd0\x31\xe4\x02\0\x95\x76\xb0\xc6\x04\0\0\0"s;

TEST(Compression, endings_name_it) {
  EXPECT_EQ(compression_of("a.csv.gz"), Compression::gzip);
  EXPECT_EQ(compression_of("A.CSV.GZ"), Compression::gzip);
  EXPECT_EQ(compression_of("a.zst"), Compression::zstandard);
  EXPECT_EQ(compression_of("a.csv"), Compression::none);
  EXPECT_EQ(compression_of("-"), Compression::none);
  EXPECT_EQ(compression_of("folder/.gz"), Compression::none);
}

TEST(Compression, other_bytes_are_left_as_they_are) {
  for (const std::string& text : {""s, "t"s, "\x1f"s, "t,x\n0,1\n"s}) EXPECT_EQ(unpacked(text, 1), text);
}

TEST(Compression, what_is_compressed_is_decompressed_again) {
  for (const Compression compression : {Compression::gzip, Compression::zstandard}) {
    for (const std::string& text : {""s, "x"s, long_text(), std::string(3'000'000, 'a')}) {
      const std::string bytes = packed(compression, text);
      EXPECT_EQ(unpacked(bytes), text);
      EXPECT_LE(bytes.size(), text.size() / 2 + 32);
    }
    EXPECT_EQ(unpacked(packed(compression, "several parts"), 1), "several parts");
    EXPECT_EQ(unpacked(packed(compression, "one, ") + packed(compression, "two")), "one, two") << "two in one file";
  }
}

TEST(Compression, the_bytes_do_not_depend_on_their_division) {
  const std::string text = long_text();
  EXPECT_EQ(packed(Compression::gzip, text, 999), packed(Compression::gzip, text, 1 << 20));
}

TEST(Compression, files_of_other_programs_are_read) {
  EXPECT_EQ(unpacked(by_gzip), "0,1\n");
  EXPECT_EQ(unpacked(by_gzip + std::string(512, '\0')), "0,1\n") << "zeros at the end are padding";
}

TEST(Compression, a_skippable_frame_may_come_first) {
  const std::string frame = "\x50\x2A\x4D\x18\x04\0\0\0abcd"s;  // pzstd writes such frames
  EXPECT_EQ(unpacked(frame + packed(Compression::zstandard, "0,1\n")), "0,1\n");
}

TEST(Compression, a_window_beyond_the_limit_is_refused) {
  const std::string window_of_256_mib = "\x28\xB5\x2F\xFD\0\x90\x01\0\0"s;
  EXPECT_THAT(refusal(window_of_256_mib), HasSubstr("a window of more than 128 MiB"));
}

TEST(Compression, cut_data_are_refused) {
  for (const Compression compression : {Compression::gzip, Compression::zstandard}) {
    const std::string bytes = packed(compression, "t,x\n0,1\n1,2\n");
    for (std::size_t size = 4; size < bytes.size(); ++size) {
      EXPECT_THAT(refusal(bytes.substr(0, size)), HasSubstr("data end too early")) << size;
    }
  }
}

TEST(Compression, broken_data_are_refused) {
  for (const Compression compression : {Compression::gzip, Compression::zstandard}) {
    std::string bytes = packed(compression, long_text());
    for (std::size_t at = bytes.size() / 2; at < bytes.size() / 2 + 100; ++at) bytes[at] = '\xFF';
    EXPECT_THAT(refusal(bytes), HasSubstr("data are damaged"));
  }
  std::string bytes = by_gzip;
  bytes[bytes.size() - 8] ^= 1;
  EXPECT_THAT(refusal(bytes), HasSubstr("data are damaged")) << "its checksum is another";
  EXPECT_THAT(refusal(by_gzip + "more"), HasSubstr("gzip data are damaged"));
}

}  // namespace
}  // namespace tcb
