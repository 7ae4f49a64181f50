// Sample columns: the columns of samples of a curve, which have the names that the program gives them.
#include "schema/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <unordered_map>

#include "option_names.hpp"
#include "schema/usual_names.hpp"

namespace tcb {
namespace {

/// The columns of samples that are requested: by cell, and by name or number.
class SampleRequests {
 public:
  SampleRequests(std::span<const std::string> header, const std::vector<bool>& numeric, const SampleNames& names)
      : header_(header), numeric_(numeric), names_(names), cells_(std::ssize(numeric)), taken_(numeric.size()) {
    for (const std::string& name : header) ++named_[name];
  }

  /// The groups, if all of them are there.
  void add_groups() {
    std::vector<std::ptrdiff_t> groups;
    for (const std::string& name : names_.groups) {
      groups.push_back(header_.empty() ? std::ssize(groups)
                                       : cell_where([&](const auto& other) { return other == name; }));
    }
    if (!std::ranges::all_of(groups, [&](std::ptrdiff_t cell) { return cell < cells_; })) return;
    for (const std::ptrdiff_t cell : groups) add(Role::group, cell);
  }

  /// The time, where columns have no names.
  void add_time_by_place() {
    const auto cell = std::ssize(requests_) + static_cast<std::ptrdiff_t>(names_.time_place);
    if (cell < cells_) add(Role::time, cell);
  }

  void add_time_by_name() {
    std::ptrdiff_t time = cell_where([&](const auto& name) { return name == names_.time; });
    if (time == cells_) time = cell_where([](const auto& name) { return role_of_name(name) == Role::time; });
    const bool has_lengths = std::ranges::count(header_, "s") > 0;
    for (std::ptrdiff_t cell = 0; time == cells_ && !has_lengths && cell < cells_; ++cell) {
      const auto at = static_cast<std::size_t>(cell);
      if (!numeric_[at] || !is_usual_time(header_[at])) continue;
      time = cell;
      break;
    }
    if (time < cells_) add(Role::time, time);
  }

  /// Every other column of numbers.
  void add_channels() {
    for (std::ptrdiff_t cell = 0; cell < cells_; ++cell) {
      const auto at = static_cast<std::size_t>(cell);
      const bool is_label = std::ranges::count(names_.labels, header_[at]) > 0;
      if (numeric_[at] && !is_label && !taken_[at]) add(Role::position, cell);
    }
  }

  std::vector<RoleRequest>& requests() { return requests_; }

 private:
  /// The first cell with a name for which is_it holds; cells_ where there is none.
  template <class F>
  std::ptrdiff_t cell_where(F is_it) const {
    return std::ranges::find_if(header_, is_it) - header_.begin();
  }

  void add(Role role, std::ptrdiff_t cell) {
    const auto at = static_cast<std::size_t>(cell);
    taken_[at] = true;
    // By name, as another name may be this one's number.
    const bool by_name = at < header_.size() && named_[header_[at]] == 1;
    requests_.push_back({role, {by_name ? header_[at] : fmt::format("{}", cell + 1)}});
  }

  std::span<const std::string> header_;
  const std::vector<bool>& numeric_;
  const SampleNames& names_;
  std::ptrdiff_t cells_;
  std::vector<RoleRequest> requests_;
  std::unordered_map<std::string_view, std::size_t> named_;  ///< how many columns have a name
  std::vector<bool> taken_;
};

}  // namespace

Columns find_sample_columns(std::span<const std::string> given, const std::vector<bool>& numeric,
                            const SampleNames& names, bool timeless) {
  std::vector<std::string> header(given.begin(), given.end());
  for (const auto& [theirs, ours] : names.maps) {
    const auto found = std::ranges::find(given, theirs);
    if (found == given.end()) throw no_such_column(theirs, header).about(option::map);
    header[static_cast<std::size_t>(found - given.begin())] = ours;
  }
  SampleRequests samples(header, numeric, names);
  samples.add_groups();
  if (!names.times_only.empty()) {
    samples.requests().push_back({Role::time, {names.time}, names.times_only});
    return requested_columns(header, numeric, samples.requests());
  }
  if (header.empty()) {
    if (!timeless) samples.add_time_by_place();
    return find_columns(header, numeric, samples.requests(), timeless);
  }
  samples.add_time_by_name();
  samples.add_channels();
  return find_columns(header, numeric, samples.requests(), true);
}

}  // namespace tcb
