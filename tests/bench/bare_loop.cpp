// Bare loop, the reference for speed: bare_loop KEYS.csv ROWS prints ROWS rows at equal steps of time.
//
// The necessary work and nothing else: keys (a header, then time,x,y,z) to plain arrays, the cubic of tension,
// continuity and bias 0 with tcbsample's default tangents and ends, and the shortest text of each number, printed by
// the fastest routine available.
// No options, no other formats, few checks; it keeps all keys in memory, and no rows.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "numbers/print_number.hpp"

namespace {

constexpr std::size_t channels = 3;

struct Key {
  double time;
  std::array<double, channels> position, velocity;
};

[[noreturn]] void stop(const char* what) {
  std::perror(what);
  std::exit(1);
}

std::vector<Key> read_keys(const char* path) {
  const int file = open(path, O_RDONLY);
  struct stat status {};
  if (file < 0 || fstat(file, &status) != 0) stop(path);
  const auto size = static_cast<std::size_t>(status.st_size);
  void* const bytes = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  if (bytes == MAP_FAILED) stop(path);
  const char* at = static_cast<const char*>(bytes);
  const char* const end = at + size;
  while (at != end && *at++ != '\n') {
  }
  std::vector<Key> keys;
  while (at != end) {
    Key key{};
    const auto number = [&](double& value) {
      const auto [after, error] = std::from_chars(at, end, value);
      if (error != std::errc() || after == end) stop(path);
      at = after + 1;  // the comma, or the end of the line
    };
    number(key.time);
    for (double& value : key.position) number(value);
    keys.push_back(key);
  }
  munmap(bytes, size);
  close(file);
  return keys;
}

/// At a key the mean of the velocities of both chords; at an end that of the only chord.
void set_velocities(std::vector<Key>& keys) {
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const double duration = keys[i + 1].time - keys[i].time;
    for (std::size_t c = 0; c < channels; ++c) {
      const double half = (keys[i + 1].position[c] - keys[i].position[c]) / duration / 2;
      keys[i].velocity[c] += half;
      keys[i + 1].velocity[c] += half;
    }
  }
  for (double& value : keys.front().velocity) value *= 2;
  for (double& value : keys.back().velocity) value *= 2;
}

/// Buffer of text for standard output, written in blocks.
class Output {
 public:
  void number(double value, char after) {
    if (size_ + tcb::number_room > buffer_.size()) flush();
    char* const end = tcb::write_shortest(value, buffer_.data() + size_);
    *end = after;
    size_ = static_cast<std::size_t>(end + 1 - buffer_.data());
  }
  void text(const char* text) {
    while (*text != '\0') buffer_[size_++] = *text++;
  }
  void flush() {
    for (std::size_t done = 0; done < size_;) {
      const ssize_t written = write(STDOUT_FILENO, buffer_.data() + done, size_ - done);
      if (written < 0) stop("standard output");
      done += static_cast<std::size_t>(written);
    }
    size_ = 0;
  }

 private:
  std::array<char, 1 << 16> buffer_{};
  std::size_t size_ = 0;
};

void print_rows(const std::vector<Key>& keys, std::size_t rows, Output& out) {
  const double first = keys.front().time;
  const double step = (keys.back().time - first) / static_cast<double>(rows - 1);
  std::size_t i = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    const double time = row + 1 == rows ? keys.back().time : first + static_cast<double>(row) * step;
    while (i + 2 < keys.size() && keys[i + 1].time <= time) ++i;
    const Key& from = keys[i];
    const Key& to = keys[i + 1];
    const double duration = to.time - from.time;
    const double u = (time - from.time) / duration;
    out.number(time, ',');
    for (std::size_t c = 0; c < channels; ++c) {
      const double chord = to.position[c] - from.position[c];
      const double start = from.velocity[c] * duration;
      const double end = to.velocity[c] * duration;
      const double d = start + end - 2 * chord;
      const double bend = chord - start - d;
      out.number(from.position[c] + u * (start + u * (bend + u * d)), c + 1 == channels ? '\n' : ',');
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const long rows = argc == 3 ? std::atol(argv[2]) : 0;
  if (rows < 2) {
    std::fputs("usage: bare_loop KEYS.csv ROWS\n", stderr);
    return 2;
  }
  std::vector<Key> keys = read_keys(argv[1]);
  if (keys.size() < 2) return 1;
  set_velocities(keys);
  Output out;
  out.text("time,x,y,z\n");
  print_rows(keys, static_cast<std::size_t>(rows), out);
  out.flush();
  return 0;
}
