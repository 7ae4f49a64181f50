// Conventions: the ways in which programs make a curve of the same keys, and their names as rules and presets.

#include <algorithm>
#include <set>

#include "compare/ranking.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

using Triple = std::array<double, 3>;
using spline::end_rules;
using spline::tangent_rules;

Triple triple_of(const spline::Tcb<double>& tcb) { return {tcb.tension, tcb.continuity, tcb.bias}; }

/// The distinct values of tension, continuity and bias among all keys.
std::set<Triple> triples(const KeptCurves& kept) {
  std::set<Triple> found;
  for (const KeptCurve& curve : kept.curves) {
    for (const KeyBlock& block : curve.blocks) {
      if (block.keys.tcbs.empty()) found.insert(triple_of(block.keys.common_tcb));
      for (const auto& tcb : block.keys.tcbs) found.insert(triple_of(tcb));
    }
  }
  return found;
}

/// All orders and signs, by the number of negative signs; the usual one is the first.
std::vector<TcbOrder> all_orders() {
  std::vector<TcbOrder> orders;
  for (const unsigned signs : {0U, 1U, 2U, 4U, 3U, 5U, 6U, 7U}) {
    TcbOrder order;
    for (unsigned i = 0; i < 3; ++i) order.negative[i] = ((signs >> i) & 1U) != 0;
    do {
      orders.push_back(order);
    } while (std::ranges::next_permutation(order.source).found);
  }
  return orders;
}

}  // namespace

spline::Tcb<double> TcbOrder::of(const spline::Tcb<double>& tcb) const {
  const Triple values = triple_of(tcb);
  const auto value = [&](std::size_t i) { return negative[i] ? -values[source[i]] : values[source[i]]; };
  return {value(0), value(1), value(2)};
}

std::string TcbOrder::name() const {
  std::string text;
  for (std::size_t i = 0; i < source.size(); ++i) {
    text += std::string(i > 0 ? "," : "") + (negative[i] ? "-" : "") + "TCB"[source[i]];
  }
  return text;
}

std::vector<TcbOrders> distinct_orders(const KeptCurves& kept) {
  const std::set<Triple> known = triples(kept);
  std::vector<TcbOrders> distinct;
  for (const TcbOrder& order : all_orders()) {
    const auto is_same = [&](const TcbOrders& other) {
      return std::ranges::all_of(known, [&](const Triple& triple) {
        const spline::Tcb<double> tcb{triple[0], triple[1], triple[2]};
        return order.of(tcb) == other.order.of(tcb);
      });
    };
    const auto same = std::ranges::find_if(distinct, is_same);
    if (same == distinct.end())
      distinct.push_back({order, {}});
    else
      same->same.push_back(order.name());
  }
  return distinct;
}

std::vector<Convention> conventions(std::size_t orders, bool closed) {
  std::vector<Convention> all;
  for (std::size_t order = 0; order < orders; ++order) {
    for (const bool equal_speed : {false, true}) {
      for (const auto& tangents : tangent_rules<double>) {
        for (std::size_t ends = 0; ends < (closed ? 1 : end_rules<double>.size()); ++ends) {
          const auto& rule = end_rules<double>[ends];
          if (!rule.takes_velocity) all.push_back({tangents.id, rule.id, rule.id, equal_speed, order});
        }
      }
    }
  }
  return all;
}

std::vector<Convention> with_mixed_ends(const Convention& convention) {
  std::vector<Convention> all;
  for (const auto& start : end_rules<double>) {
    for (const auto& end : end_rules<double>) {
      const bool given = start.takes_velocity || end.takes_velocity;
      if (start.id != end.id && !given)
        all.push_back({convention.tangents, start.id, end.id, convention.equal_speed, convention.order});
    }
  }
  return all;
}

std::string ends_of(const Convention& convention) {
  const std::string start(name_of(convention.start)), end(name_of(convention.end));
  return start == end ? start : start + "," + end;
}

CurveSettings settings_of(const Convention& convention, CurveSettings others, bool closed) {
  others.tangents = name_of(convention.tangents);
  if (!closed) others.ends = ends_of(convention);
  others.equal_speed = convention.equal_speed;
  return others;
}

std::vector<std::string> presets_of(const Convention& convention, bool closed) {
  std::vector<std::string> names;
  for (const auto& preset : spline::presets) {
    const bool same = preset.tangents == convention.tangents &&
                      (closed || (preset.ends == convention.start && preset.ends == convention.end)) &&
                      !convention.equal_speed;
    if (same) names.emplace_back(preset.name);
  }
  return names;
}

}  // namespace tcb
