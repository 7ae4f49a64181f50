// File notes: what is reported about an input, from its first bytes to its last curve; the rules of a curve and the
// requested samples in words, for provenance, explanations and pictures.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "numbers/rational.hpp"
#include "run/progress.hpp"
#include "sample/request.hpp"
#include "schema/schema.hpp"
#include "write/provenance.hpp"

namespace tcb {

class Curves;
class GapRows;
struct Input;
struct CurveSamples;
struct CurveSpec;
struct KeyOptions;

/// Reports facts about a file that a user may not expect.
class FileNotes {
 public:
  /// Notes a file that is a terminal. The arguments outlive this.
  FileNotes(Report& report, const std::string& path);

  void add(const Note& note) { report_.note(path_, note); }

  /// Notes what was detected in the input, and how the samples that are requested of it are understood.
  /// `fields`: of the rows. Throws: Error (data) for a doubt that the request has to decide.
  void add_input(const Input& input, const KeyOptions& options, const SamplingRequest& request = {},
                 std::span<const std::size_t> fields = {});

  /// Notes where the samples of a curve end, and how many of them are in gaps. Requires: they were all taken.
  void add_samples(const CurveSamples& samples, const SamplingRequest& request, bool is_closed);

  /// Notes counts of all curves, and which of their rules may surprise. `rules`: those of the command.
  void end(const Curves& curves, const KeyOptions& rules);
  /// Notes counts of all curves.
  void end(const Curves& curves);

 private:
  void add_gap_rows(GapRows& gap_rows);

  Report& report_;
  const std::string& path_;
  TimeSchema time_;
  std::vector<std::string> channels_;
  bool has_nulls_ = false;        ///< null in place of a key breaks curves
  std::uint64_t remainders_ = 0;  ///< number of curves whose end is not a row
  std::uint64_t curves_with_gap_rows_ = 0;
  std::vector<std::uint64_t> channel_gaps_;  ///< of each channel
  bool skips_cells_ = false;                 ///< numbers that are missing are left out
  bool is_open_ = false;                     ///< any curve is
  std::uint64_t rows_ = 0;                   ///< within a distance
  std::uint64_t least_rows_ = 0;             ///< of any polylines within it
};

/// Which numbers of the keys have no effect on these curves, and where their ends are not those of version 0.4.
std::vector<Note> notes_of_rules(const Curves& curves, const KeyOptions& options);

/// These channels seem to be angles.
Note angles_note(const std::vector<NamedAngle>& angles);

/// The range ends between rows; `at_key`: at the last key.
Note remainder_note(double distance, bool at_key);

std::string number_in_words(const Rational& value);

/// A time as the input writes it, to milliseconds where it is in words.
std::string shown_time(const TimeSchema& schema, const Time& time);

/// The rules of a curve, as names and values.
Facts rules_in_words(const CurveSpec& spec);

Facts preset_in_words(const CurveSpec& spec);

/// The requested samples, as in "every 0.5 of time".
std::string samples_in_words(const SamplingRequest& request);

}  // namespace tcb
