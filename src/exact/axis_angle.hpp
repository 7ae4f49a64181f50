// Axis angles: of a rotation that is about one axis all along a segment.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

#include "exact/ball.hpp"
#include "tcb/spline/rotation.hpp"

namespace tcb {

/// Whether the turns from the first point of a rotation's segment to the others have one axis, as far as balls tell.
/// Then the rotation turns about that axis alone; the shorter way between two of its points may change sides.
template <class B>
bool may_be_about_one_axis(const spline::RotationSegment<B>& rotation) {
  if (rotation.curve() == spline::RotationCurve::components || rotation.has_whole_turns()) return false;
  const auto& points = rotation.points();
  std::array<spline::Quaternion<B>, 3> turns;
  std::transform(points.begin() + 1, points.end(), turns.begin(),
                 [&](const auto& q) { return conjugate(points[0]) * q; });
  const auto size = [](const auto& q) { return q.x * q.x + (q.y * q.y + q.z * q.z); };
  const auto& longest = *std::ranges::max_element(turns, {}, [&](const auto& q) { return size(q).middle(); });
  return !size(longest).may_be_zero() && std::ranges::all_of(turns, [&](const auto& q) {
    return (q.x * longest.y - q.y * longest.x).may_be_zero() && (q.y * longest.z - q.z * longest.y).may_be_zero() &&
           (q.z * longest.x - q.x * longest.z).may_be_zero();
  });
}
template <class B>
using Polynomial = std::array<B, 4>;  ///< by the powers of u

template <class B>
B value(const Polynomial<B>& p, const B& u) {
  return p[0] + u * (p[1] + u * (p[2] + u * p[3]));
}

/// Places by size; those that may be equal are merged into one.
template <class B>
std::vector<B> merged(std::vector<B> places) {
  std::ranges::sort(places, {}, &B::middle);
  std::vector<B> result;
  for (const B& place : places) {
    if (!result.empty() && (place - result.back()).may_be_zero()) {
      result.back() = result.back().widened((place - result.back()).most());
    } else {
      result.push_back(place);
    }
  }
  return result;
}

/// Adds the zeros of a quadratic between two places, and perhaps zeros just outside.
template <class B>
void add_zeros(const B& c0, const B& c1, const B& c2, const B& begin, const B& end, std::vector<B>& zeros) {
  const auto add = [&](const B& above, const B& below) {
    if (above.least() > below.most()) return;  // beyond 1
    const B zero = above / below, from_begin = zero - begin, to_end = end - zero;
    const auto is_negative = [](const B& x) { return !x.may_be_zero() && x.rough() < 0; };
    if (!is_negative(from_begin) && !is_negative(to_end)) zeros.push_back(zero);
  };
  if (c0.least() > c1.most() + c2.most()) return;
  if (c2.is_zero()) return c1.is_zero() ? void() : add(-c0, c1);
  const B square = c1 * c1 - B(4.0) * c0 * c2;
  if (square < B()) return;
  const B root = sqrt(square), half = halved(-c1 + (c1.rough() < 0 ? root : -root));
  add(half, c2);
  add(c0, half);
}

/// Half the angle of a rotation about one axis. It is a cubic on each part of a segment between the places at which the
/// shorter way between two of its points changes sides; each part moves in one direction.
template <class B>
class AngleAboutAxis {
 public:
  struct Part {
    B begin, end;
    bool begins_at_rest, ends_at_rest;
    Polynomial<B> angle;
  };

  explicit AngleAboutAxis(const spline::RotationSegment<B>& rotation) {
    const std::array<B, 4> angles = angles_of(rotation.points());
    const auto way = [&](std::size_t from, std::size_t to) {
      const B change = angles[to] - angles[from];
      return Polynomial<B>{angles[from], change - turns_in(change), B(), B()};
    };
    if (rotation.curve() == spline::RotationCurve::slerp) {
      join({way(0, 3)}, B(), B(1.0));
    } else if (rotation.curve() == spline::RotationCurve::squad) {
      weight_ = {B(), B(2.0), B(-2.0)};
      join({way(0, 3), way(1, 2)}, B(), B(1.0));
    } else {
      weight_ = {B(), B(1.0), B()};
      join({way(0, 1), way(1, 2), way(2, 3)}, B(), B(1.0));
    }
  }

  const std::vector<Part>& parts() const { return parts_; }
  const Part& part_at(const B& place) const {
    const auto is_after = [&](const Part& part) { return place.middle() < part.end.middle(); };
    const auto found = std::ranges::find_if(parts_, is_after);
    return found == parts_.end() ? parts_.back() : *found;
  }

 private:
  static std::array<B, 4> angles_of(const std::array<spline::Quaternion<B>, 4>& points) {
    std::array<spline::Quaternion<B>, 4> turns;
    std::ranges::transform(points, turns.begin(), [&](const auto& q) { return conjugate(points[0]) * q; });
    const auto longest = std::ranges::max_element(turns, {}, [](const auto& q) {
      return dot(q, {q.x, q.y, q.z, B()}).middle();
    });
    const spline::Quaternion<B> axis = normalized(spline::Quaternion<B>{longest->x, longest->y, longest->z, B()});
    std::array<B, 4> angles;
    for (std::size_t i = 1; i < turns.size(); ++i) {
      const B sine = dot(turns[i], axis);
      angles[i] = sine.rough() < 0 ? -angle_of(-sine, turns[i].w) : angle_of(sine, turns[i].w);
    }
    return angles;
  }

  /// The whole turns that the shorter way leaves out. Throws: Undecided where the ways are about the same.
  static B turns_in(const B& angle) {
    const B turn = B(2.0) * spline::pi<B>();
    return turn * floor(angle / turn + B(0.5));
  }

  /// Joins each way with the next one, up to one.
  void join(const std::vector<Polynomial<B>>& ways, const B& begin, const B& end) {
    if (ways.size() == 1) return add(ways[0], begin, end);
    std::vector<Polynomial<B>> changes;
    std::vector<B> ends{begin, end};
    for (std::size_t i = 0; i + 1 < ways.size(); ++i) {
      Polynomial<B>& change = changes.emplace_back();
      std::ranges::transform(ways[i + 1], ways[i], change.begin(), std::minus());
      constexpr int most_turns = 9;  // of half turns: more than three ways have together
      for (int turns = -most_turns; turns <= most_turns; turns += 2) {
        add_zeros(change[0] - B(turns) * spline::pi<B>(), change[1], change[2], begin, end, ends);
      }
    }
    ends = merged(std::move(ends));
    for (std::size_t part = 1; part < ends.size(); ++part) {
      const B middle((ends[part - 1] + ends[part]).middle());
      std::vector<Polynomial<B>> joined;
      for (std::size_t i = 0; i < changes.size(); ++i) {
        Polynomial<B> change = changes[i], way = ways[i];
        change[0] = change[0] - turns_in(value(change, halved(middle)));
        for (std::size_t power = 1; power < way.size(); ++power) {
          for (std::size_t k = 1; k <= std::min<std::size_t>(power, 2); ++k) {
            way[power] = way[power] + weight_[k] * change[power - k];
          }
        }
        joined.push_back(way);
      }
      join(joined, ends[part - 1], ends[part]);
    }
  }

  void add(const Polynomial<B>& angle, const B& begin, const B& end) {
    std::vector<B> rests, ends{begin, end};
    try {
      add_zeros(angle[1], B(2.0) * angle[2], B(3.0) * angle[3], begin, end, rests);
    } catch (const Undecided&) {  // it nearly rests, but does not turn back
    }
    std::ranges::copy(rests, std::back_inserter(ends));
    ends = merged(std::move(ends));
    const auto is_rest = [&](const B& place) {
      return std::ranges::any_of(rests, [&](const B& rest) { return (rest - place).may_be_zero(); });
    };
    for (std::size_t part = 1; part < ends.size(); ++part) {
      parts_.push_back({ends[part - 1], ends[part], is_rest(ends[part - 1]), is_rest(ends[part]), angle});
    }
  }

  std::array<B, 3> weight_;
  std::vector<Part> parts_;
};

}  // namespace tcb
