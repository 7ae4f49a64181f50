// Values of rotations: from the text of --rotation and --rotation-output to their values, or to an error.
#include "cli/rotation_values.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "cli/errors.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// The axes of Euler angles: capital letters for turns around the axes as already turned, small ones around fixed axes.
spline::RotationNotation euler_order(std::string_view letters, const std::string& text) {
  spline::RotationNotation notation{spline::RotationForm::euler};
  notation.intrinsic = letters.find_first_not_of("XYZ") == std::string_view::npos;
  const bool is_order = notation.intrinsic || letters.find_first_not_of("xyz") == std::string_view::npos;
  if (letters.size() != 3 || !is_order || letters[1] == letters[0] || letters[1] == letters[2]) {
    throw not_an_order_of_axes(text);
  }
  for (std::size_t i = 0; i < letters.size(); ++i) {
    notation.axes[i] = static_cast<std::uint8_t>(letters[i] - (notation.intrinsic ? 'X' : 'x'));
  }
  return notation;
}

/// The columns of a rotation after its form. Euler angles still lack their order.
GivenRotation rotation_request(std::string_view part, const std::string& text) {
  const std::size_t equals = std::min(part.find('='), part.size());
  const auto form = std::ranges::find(rotation_forms, part.substr(0, equals), &RotationFormName::name);
  if (equals == part.size() || form == rotation_forms.end()) {
    throw not_a_rotation(text);
  }
  GivenRotation request{{form->form}};
  for (const std::string_view column : split(part.substr(equals + 1), ':')) request.columns.emplace_back(column);
  if (request.columns.size() != request.notation.numbers() || std::ranges::count(request.columns, "") > 0) {
    throw not_a_rotation(text);
  }
  return request;
}

}  // namespace

std::vector<GivenRotation> rotations(const std::string& text, bool& none) {
  constexpr std::string_view order = "order=";
  std::vector<GivenRotation> result;
  const auto last_is = [&](spline::RotationForm form) {
    return !result.empty() && result.back().notation.form == form;
  };
  const auto lacks_order = [&] {
    return last_is(spline::RotationForm::euler) && result.back().notation.axes == std::array<std::uint8_t, 3>{};
  };
  for (const std::string_view part : split(text, ',')) {
    if (part.starts_with(order) && lacks_order()) {
      result.back().notation = euler_order(part.substr(order.size()), text);
    } else if (lacks_order()) {
      throw not_a_rotation(text);
    } else if (part == "relative" && last_is(spline::RotationForm::axis_angle)) {
      result.back().relative = true;
    } else if (part == "none") {
      none = true;
    } else {
      result.push_back(rotation_request(part, text));
    }
  }
  if (lacks_order() || (none && !result.empty())) throw not_a_rotation(text);
  return result;
}

spline::RotationNotation rotation_form(const std::string& text) {
  constexpr std::string_view euler = "euler=";
  if (text.starts_with(euler)) return euler_order(text.substr(euler.size()), text);
  const auto found = std::ranges::find(rotation_forms, text, &RotationFormName::name);
  if (found == rotation_forms.end() || found->form == spline::RotationForm::euler) {
    throw not_a_form_of_rotations(text);
  }
  return {found->form};
}

}  // namespace tcb
