// Conventions: the ways in which programs make a curve of the same keys, and their names as rules and presets.
#include "check/conventions.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "sample/curve_spec.hpp"
#include "sample/fields.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

using Triple = std::array<double, 3>;
using spline::end_rules;
using spline::tangent_rules;

Triple triple_of(const spline::Tcb<double>& tcb) { return {tcb.tension, tcb.continuity, tcb.bias}; }

/// The distinct values of tension, continuity and bias among all keys.
std::set<Triple> triples(const KeptInput& kept) {
  std::set<Triple> found;
  for (const KeptKeys& curve : kept.curves) {
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

/// Whether keys can have this curve of rotations, which some have not with velocities or whole turns.
bool is_curve_of(spline::RotationCurve curve, const KeptInput& kept) {
  if (curve == spline::RotationCurve::squad) return true;
  const bool is_slerp = curve == spline::RotationCurve::slerp;
  const auto has_whole_turn = [&](const Keys& keys, std::size_t rotation) {
    const GivenRotation& given = kept.schema.rotations[rotation].given;
    for (std::size_t key = 0; given.relative && key < keys.size(); ++key) {
      const double angle = keys.position(key)[given.channels[3]];
      if (std::abs(angle) >= spline::whole_turn<double>(given.notation.degrees).hi) return true;
    }
    return false;
  };
  for (const KeptKeys& kept_curve : kept.curves) {
    for (const KeyBlock& block : kept_curve.blocks) {
      if (is_slerp && !block.keys.velocities.empty()) return false;
      for (std::size_t i = 0; !is_slerp && i < kept.schema.rotations.size(); ++i) {
        if (has_whole_turn(block.keys, i)) return false;
      }
    }
  }
  return true;
}

/// Whether the keys have neither ease nor velocities nor missing positions, with which timing is always even.
bool has_rules_alone(const KeptKeys& curve) {
  return std::ranges::all_of(curve.blocks, [](const KeyBlock& block) {
    return block.keys.eases.empty() && block.keys.velocities.empty() && !block.keys.is_sparse();
  });
}

/// A convention with each curve of rotations that is tried. Without positions, slerp is one convention alone. With
/// linear tangents, squad and casteljau are slerp.
void add_with_curves(std::vector<Convention>& all, Convention convention, const ComparedParts& parts) {
  if (parts.rotation_curves.empty()) all.push_back(convention);
  for (const spline::RotationCurve curve : parts.rotation_curves) {
    const bool has_tangents = parts.positions || curve != spline::RotationCurve::slerp;
    const bool is_arc = curve == spline::RotationCurve::squad || curve == spline::RotationCurve::casteljau;
    if (convention.is_linear() && is_arc && parts.rotation_curves.size() > 1) continue;
    convention.rotation_curve = curve;
    if (has_tangents || std::ranges::count(all, curve, &Convention::rotation_curve) == 0) all.push_back(convention);
  }
}

/// The presets with monotone timing.
void add_timings(std::vector<Convention>& all, std::size_t orders, const ComparedParts& parts) {
  for (const spline::PresetRow& row : spline::presets) {
    if (row.timing == spline::Timing::even || !parts.may_be_timed) continue;
    for (std::size_t order = 0; order < orders; ++order) {
      Convention convention{row.tangents, row.ends, row.ends, false, order};
      convention.timing = row.timing;
      add_with_curves(all, convention, parts);
    }
  }
}

/// The presets whose rotations have other rules than positions.
void add_presets(std::vector<Convention>& all, std::size_t orders, const ComparedParts& parts) {
  for (const auto& [id, name, tangents, ends, product, rotations, timing] : spline::presets) {
    const bool is_tried = std::ranges::count(parts.rotation_curves, rotations.curve) > 0;
    if (timing != spline::Timing::even) continue;
    if (!parts.positions || !is_tried || (!rotations.tangents && !rotations.ends)) continue;
    const auto is_same = [&, like = std::tuple(tangents, ends, rotations)](const Convention& other) {
      if (!other.rotation_preset) return false;
      const spline::PresetRow& row = row_of(*other.rotation_preset);
      return std::tuple(row.tangents, row.ends, row.rotations) == like;
    };
    if (std::ranges::any_of(all, is_same)) continue;
    for (std::size_t order = 0; order < orders; ++order) {
      all.push_back({tangents, ends, ends, false, order, rotations.curve, id});
    }
  }
}

/// Whether the rules of rotations of a preset are those of a convention.
bool has_rotations_of(const Convention& convention, const spline::PresetRow& preset, bool closed) {
  spline::RotationRules rules;
  if (convention.rotation_preset) rules = row_of(*convention.rotation_preset).rotations;
  const auto tangents = [](const spline::RotationRules& own, spline::TangentRule of_positions) {
    return own.tangents.value_or(of_positions);
  };
  const auto ends = [](const spline::RotationRules& own, spline::EndRule of_positions) {
    return own.ends.value_or(of_positions);
  };
  const spline::EndRule own_ends = ends(preset.rotations, preset.ends);
  const bool same_ends = ends(rules, convention.start) == own_ends && ends(rules, convention.end) == own_ends;
  return preset.rotations.curve == convention.rotation_curve && (closed || same_ends) &&
         tangents(rules, convention.tangents) == tangents(preset.rotations, preset.tangents);
}

bool has_positions_of(const Convention& convention, const spline::PresetRow& preset, bool closed) {
  return preset.tangents == convention.tangents && preset.timing == convention.timing &&
         (closed || (preset.ends == convention.start && preset.ends == convention.end));
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

std::vector<TcbOrders> distinct_orders(const KeptInput& kept) {
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

ComparedParts compared_parts(const CurveSettings& rules, const ComparisonInputs& inputs) {
  ComparedParts parts{.positions = false};
  const Schema& keys = inputs.kept.schema;
  const std::vector<PositionCell> cells = position_cells(keys.channels.size(), rotation_columns(keys));
  bool rotations = false;
  for (const MatchedColumn& column : inputs.columns.compared) {
    const bool is_position = cells[column.computed].rotation == PositionCell::none;
    (is_position ? parts.positions : rotations) = true;
  }
  for (const KeptKeys& curve : inputs.kept.curves) {
    const CurveSpec spec = make_spec(merged(rules, curve.curve_info->settings));
    parts.closed = parts.closed || spec.closed;
    parts.may_be_timed = parts.may_be_timed && has_rules_alone(curve);
    if (rotations && rules.rotation_curve) parts.rotation_curves.assign(1, spec.rules.rotation_rules.curve);
  }
  for (const auto& row : spline::rotation_curves) {
    const bool is_tried = rotations && !rules.rotation_curve && is_curve_of(row.id, inputs.kept);
    if (is_tried) parts.rotation_curves.push_back(row.id);
  }
  return parts;
}

std::vector<Convention> conventions(std::size_t orders, const ComparedParts& parts) {
  std::vector<Convention> all;
  for (std::size_t order = 0; order < orders; ++order) {
    for (const bool equal_speed : {false, true}) {
      for (const auto& tangents : tangent_rules<double>) {
        if (tangents.id == spline::TangentRule::linear) continue;
        for (std::size_t ends = 0; ends < (parts.closed ? 1 : end_rules<double>.size()); ++ends) {
          const auto& rule = end_rules<double>[ends];
          if (rule.takes_velocity) continue;
          add_with_curves(all, {tangents.id, rule.id, rule.id, equal_speed, order}, parts);
        }
      }
    }
  }
  add_with_curves(all, {.tangents = spline::TangentRule::linear}, parts);
  add_presets(all, orders, parts);
  add_timings(all, orders, parts);
  return all;
}

std::vector<Convention> with_mixed_ends(const Convention& convention) {
  std::vector<Convention> all;
  if (convention.is_linear()) return all;
  for (const auto& start : end_rules<double>) {
    for (const auto& end : end_rules<double>) {
      const bool given = start.takes_velocity || end.takes_velocity;
      if (start.id == end.id || given) continue;
      all.push_back(convention);
      all.back().start = start.id;
      all.back().end = end.id;
    }
  }
  return all;
}

std::optional<std::string> ends_of(const Convention& convention, const ComparedParts& parts) {
  if (parts.closed || convention.is_linear()) return std::nullopt;
  const std::string start(name_of(convention.start)), end(name_of(convention.end));
  return start == end ? start : start + "," + end;
}

CurveSettings settings_of(const Convention& convention, CurveSettings others, const ComparedParts& parts) {
  others.tangents = convention.tangents;
  if (!parts.closed && !convention.is_linear()) others.ends = {{{convention.start}, {convention.end}}, {"--ends"}};
  others.equal_speed = convention.equal_speed;
  others.timing = convention.timing;
  if (convention.rotation_curve) others.rotation_curve = convention.rotation_curve;
  others.rotation_preset = convention.rotation_preset;
  return others;
}

std::vector<std::string> presets_of(const Convention& convention, const ComparedParts& parts) {
  std::vector<std::string> names;
  for (const auto& preset : spline::presets) {
    const bool same_positions = !parts.positions || has_positions_of(convention, preset, parts.closed);
    const bool same_rotations = parts.rotation_curves.empty() || has_rotations_of(convention, preset, parts.closed);
    if (same_positions && same_rotations && !convention.equal_speed) names.emplace_back(preset.name);
  }
  return names;
}

}  // namespace tcb
