// JSON text as nlohmann-json reads it: its pieces, and places in them.
#include "read/json/json_text.hpp"

#include <functional>

#include "read/json/scanner.hpp"

namespace tcb {

/// False at the end of the text.
bool JsonText::begin_next_piece() {
  for (std::size_t next = piece_ + 1; next < pieces_.size(); ++next) {
    if (pieces_[next].empty()) continue;
    piece_ = next;
    now_ = pieces_[next].data();
    end_ = now_ + pieces_[next].size();
    return true;
  }
  return false;
}

const char* JsonText::byte(std::size_t index) const {
  const char* end = nullptr;
  for (const std::string_view piece : pieces_) {
    if (index < piece.size()) return piece.data() + index;
    index -= piece.size();
    if (!piece.empty()) end = piece.data() + piece.size();
  }
  return end;
}

std::string_view JsonText::rest(const char* from) const {
  bool is_found = false;
  for (const std::string_view piece : pieces_) {
    const char* const begin = piece.data();
    const char* const end = begin + piece.size();
    const bool is_inside = std::greater_equal<>()(from, begin) && std::less_equal<>()(from, end);
    if (!is_found && !is_inside) continue;
    const char* at = is_found ? begin : from;
    is_found = true;
    while (at != end && is_json_blank(*at)) ++at;
    if (at != end) return {at, static_cast<std::size_t>(end - at)};
  }
  return {};
}

}  // namespace tcb
