// Errors of curves: faults of the library as errors of the program, with its channels and lines.
#include "sample/curve_errors.hpp"

#include <stdexcept>

#include "numbers/print_number.hpp"
#include "sample/errors.hpp"

namespace tcb {

Error curve_error(const spline::BuildError& error, const KeyStore& keys, const std::vector<std::string>& channels) {
  using enum spline::BuildErrorCode;
  const TextPosition last{"", keys.last_line(), 0};
  switch (error.code) {
    case channel_without_positions: return channel_without_numbers(channels[error.channel]);
    case ease_with_missing_positions: return ease_with_missing_cells();
    case closed_too_few_keys: return too_few_closed_keys();
    case period_missing: return no_period();
    case period_not_finite:
    case period_too_short: return tcb::period_too_short(time_text(keys.key(error.key).times[0]));
    case period_contradicted: return closing_key_against_period(keys.first_line()).at(last);
    case seam_tcb_differs: return closing_key_differs(keys.first_line()).at(last);
    case seam_velocity_differs: return closing_velocity_differs(keys.first_line()).at(last);
    case seam_velocity_missing: return tcb::seam_velocity_missing(channels[error.channel]);
    default: throw std::logic_error(error.message());  // the stages before find every other fault
  }
}

}  // namespace tcb
