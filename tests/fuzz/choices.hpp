// Choices: the bytes of a fuzzer's input, from its end, as choices of options; what is left is a text.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tcb::fuzz {

class Choices {
 public:
  Choices(const std::uint8_t* data, std::size_t size) : left_(reinterpret_cast<const char*>(data), size) {}

  /// A number from 0 to most; 0 when no bytes are left.
  std::size_t number(std::size_t most) {
    std::size_t value = 0;
    for (std::size_t reach = most; reach > 0; reach >>= 8) value = value << 8 | byte();
    return most == SIZE_MAX ? value : value % (most + 1);
  }

  bool yes() { return number(1) == 1; }

  /// One of `of`, equally likely.
  template <class T, std::size_t Size>
  T one(const T (&of)[Size]) {
    return of[number(Size - 1)];
  }
  template <class T, std::size_t Size>
  T one(const std::array<T, Size>& of) {
    return of[number(Size - 1)];
  }

  /// The bytes that no choice took.
  std::string_view rest() const { return left_; }

 private:
  std::uint8_t byte() {
    if (left_.empty()) return 0;
    const auto last = static_cast<std::uint8_t>(left_.back());
    left_.remove_suffix(1);
    return last;
  }

  std::string_view left_;
};

}  // namespace tcb::fuzz
