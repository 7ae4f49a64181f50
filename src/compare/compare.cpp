// Comparing someone's samples with the curve, from the files to the report.
#include "compare/compare.hpp"

#include <algorithm>

#include "compare/check.hpp"
#include "compare/report.hpp"
#include "io/file.hpp"
#include "stream/stream.hpp"

namespace tcb {

namespace {

template <class Outcome>
Exit report(const Outcome& outcome, bool good, const Job& plan) {
  Output output(plan.output);
  output.write(plan.output_format == FormatId::json ? json(outcome) : text(outcome));
  output.commit();
  return good ? Exit::done : Exit::data;
}

}  // namespace

Exit compare(const Job& plan) {
  const ThreadLimit limit(plan.threads());
  if (plan.comparison->identify) {
    const Identified identified = identify(plan);
    return report(identified, identified.fits(), plan);
  }
  const Check checked = check(plan);
  return report(checked, checked.passed(), plan);
}

}  // namespace tcb
