// The two sides of a comparison: keys, and someone's samples of their curves.
#include "compare/sides.hpp"

#include "curve/fields.hpp"
#include "io/file.hpp"

namespace tcb {

ComparisonInputs read_sides(const Job& plan, const std::vector<std::size_t>& chosen) {
  ComparisonInputs sides;
  sides.keys = shown_name(plan.files[0]);
  sides.file = shown_name(plan.comparison->file);
  sides.threads = plan.threads();
  sides.kept = in_file(sides.keys, [&] { return keep(plan); });
  const bool timeless = !chosen.empty() && fields()[chosen[0]].name != "time";
  const auto options = table_options(sides.kept.input, timeless, sides.threads);
  in_file(sides.file, [&] {
    sides.table = read_table(plan.comparison->file, options);
    sides.columns = match_columns(sides.table, sides.kept.input, chosen);
  });
  return sides;
}

}  // namespace tcb
