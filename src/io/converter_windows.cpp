// Converter by Windows.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

#include <cstdint>
#include <utility>

#include "io/converter.hpp"

namespace tcb {
namespace {

/// Appends UTF-16 as UTF-8; false: it has half a surrogate pair.
bool append(std::string& text, const std::wstring& units) {
  if (units.empty()) return true;
  const auto count = static_cast<int>(units.size());
  const auto convert = [&](char* out, int room) {
    return ::WideCharToMultiByte(CP_UTF8, WC_ERR_INVALID_CHARS, units.data(), count, out, room, nullptr, nullptr);
  };
  const int size = convert(nullptr, 0);
  if (size == 0) return false;
  const std::size_t before = text.size();
  text.resize(before + static_cast<std::size_t>(size));
  return convert(text.data() + before, size) == size;
}

}  // namespace

/// Units of one, two or four bytes; the byte order mark tells which byte of a unit is the first.
struct Converter::State {
  std::size_t unit_size = 0;  ///< 0: an unknown encoding
  bool begins = true;
  bool is_big_endian = false;

  std::uint32_t unit_at(std::string_view bytes, std::size_t at) const {
    std::uint32_t unit = 0;
    for (std::size_t i = 0; i < unit_size; ++i) {
      const std::size_t from = is_big_endian ? at + i : at + unit_size - 1 - i;
      unit = unit << 8U | static_cast<unsigned char>(bytes[from]);
    }
    return unit;
  }
};

Converter::Converter(std::string_view encoding) : state_(std::make_unique<State>()) {
  if (encoding == "UTF-32") state_->unit_size = 4;
  if (encoding == "UTF-16") state_->unit_size = 2;
  if (encoding == "WINDOWS-1252") state_->unit_size = 1;
}

Converter::~Converter() = default;

bool Converter::is_known() const { return state_->unit_size > 0; }

bool Converter::add(std::string_view bytes, std::string& text) {
  constexpr std::uint32_t mark = 0xFEFF, last = 0x10FFFF, first_of_pairs = 0x10000;
  constexpr unsigned windows_1252_page = 1252;
  rest_ += bytes;
  std::wstring units;
  std::size_t at = 0;
  const std::size_t size = state_->unit_size;
  if (size == 1) {
    if (rest_.find_first_of("\x81\x8D\x8F\x90\x9D") != std::string::npos) return false;  // undefined
    units.resize(rest_.size());
    const auto count = static_cast<int>(rest_.size());
    if (count > 0) ::MultiByteToWideChar(windows_1252_page, 0, rest_.data(), count, units.data(), count);
    rest_.clear();
    return append(text, units);
  }
  for (; at + size <= rest_.size(); at += size) {
    std::uint32_t unit = state_->unit_at(rest_, at);
    if (state_->begins && unit != mark) {
      state_->is_big_endian = true;
      unit = state_->unit_at(rest_, at);
      if (unit != mark) state_->is_big_endian = false;
    }
    if (std::exchange(state_->begins, false) && unit == mark) continue;
    if (unit > last) return false;
    if (unit >= first_of_pairs) {
      units += static_cast<wchar_t>(0xD800U + ((unit - first_of_pairs) >> 10U));
      units += static_cast<wchar_t>(0xDC00U + ((unit - first_of_pairs) & 0x3FFU));
    } else {
      units += static_cast<wchar_t>(unit);
    }
  }
  const bool is_half = size == 2 && !units.empty() && (units.back() & 0xFC00U) == 0xD800U;
  if (is_half) units.pop_back();
  rest_.erase(0, is_half ? at - size : at);
  return append(text, units);
}

}  // namespace tcb
