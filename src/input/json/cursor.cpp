// The cursor: JSON text as nlohmann-json reads it, but a number with a fraction or an exponent is read here.
#include "input/json/cursor.hpp"

#include "text/number.hpp"

namespace tcb {
namespace {

const char* behind_digits(const char* at, const char* end) {
  while (at != end && *at >= '0' && *at <= '9') ++at;
  return at;
}

/// Where a number ends that begins here: as JSON's grammar has it, with a fraction or an exponent, and followed by what
/// may follow a value. Nothing where there is no such number.
const char* behind_decimal(const char* at, const char* end) {
  if (*at == '-') ++at;
  const char* const whole = at;
  at = behind_digits(at, end);
  if (at == whole || at == end || (*whole == '0' && at != whole + 1)) return nullptr;
  const char* const behind_whole = at;
  if (*at == '.') {
    const char* const fraction = ++at;
    at = behind_digits(at, end);
    if (at == fraction) return nullptr;
  }
  if (at != end && (*at == 'e' || *at == 'E')) {
    ++at;
    if (at != end && (*at == '-' || *at == '+')) ++at;
    const char* const exponent = at;
    at = behind_digits(at, end);
    if (at == exponent) return nullptr;
  }
  const bool is_decimal = at != behind_whole;
  const bool ends = at == end || std::string_view(" \t\r\n,]}").find(*at) != std::string_view::npos;
  return is_decimal && ends ? at : nullptr;
}

}  // namespace

void JsonCursor::look_at_number() {
  const char* const behind = behind_decimal(at_, end_);
  if (behind != nullptr) {
    const std::string_view text(at_, static_cast<std::size_t>(behind - at_));
    if (const auto value = parse_number(text)) {
      number_ = {*value, text};
      behind_number_ = behind;
      return;
    }
  }
  seen_ = at_ + 1;
  while (seen_ != end_ && std::string_view(" \t\r\n,]}\"").find(*seen_) == std::string_view::npos) ++seen_;
}

}  // namespace tcb
