// Doubts: what an input may mean besides what was found in it, as one list.
//
// Columns are found by fixed rules. Then each row of the list looks at what was found. A doubt is an error where its
// readings give different numbers and the request names neither; otherwise it is a note, once for a file. Each names
// the option to copy.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "numbers/parse_number.hpp"
#include "schema/columns.hpp"
#include "schema/parameter_names.hpp"
#include "schema/schema.hpp"

namespace tcb {

/// What was found at the beginning of a table.
struct FoundColumns {
  std::span<const std::string> names;                   ///< of the columns; empty: they have none
  std::span<const std::vector<std::string_view>> rows;  ///< the cells of the first records, without quotes
  const std::vector<bool>& numeric;                     ///< for each column, whether it holds numbers
  const Columns& columns;
  const ColumnOptions& requested;
  std::vector<ParameterSet> parameters = {};  ///< those of the names
  NumberMarks marks = {};
  bool is_plain = false;                ///< as in DelimitedHead
  bool has_rotations = false;           ///< rotations are requested, or none
  bool has_tcb_scale = false;           ///< the scale of tension, continuity and bias is requested
  bool has_time_unit = false;           ///< the unit of times is requested
  bool has_tangents = false;            ///< so are the tangents, or the preset
  std::vector<std::string> meant = {};  ///< names of the numbers of an array, none of which is in doubt
  std::string array = {};               ///< the name of the only array of positions; empty: there is none
};

/// The notes of the doubts about columns. Throws: Error (data) for a doubt that the request has to decide.
std::vector<std::string> doubts_of_columns(const FoundColumns& found);

/// The column of texts without a role for each of which the times of the first records increase, though they do not
/// over all records; empty where there is none.
std::string label_of_curves(const Columns& columns, std::span<const std::string> names,
                            std::span<const std::vector<std::string_view>> rows, std::span<const double> times);

/// The columns of a year, a month and a day by their names, as far as their numbers in the first records are such, and
/// of an hour, a minute and a second. Empty where there are none.
std::vector<std::size_t> parts_of_date(std::span<const std::string> names,
                                       std::span<const std::vector<std::string_view>> rows);

/// The only column called year, day, hour or the like, or whose name ends like a time, such as race_time, if its
/// numbers increase in the first three records.
std::optional<std::size_t> find_only_time(std::span<const std::string> names,
                                          std::span<const std::vector<std::string_view>> rows);

/// The mean gap between the times of the first records; nothing unless they are whole numbers that increase.
std::optional<double> first_time_gap(const FoundColumns& found);

/// What a request needs of a curve.
struct RequestNeeds {
  bool lengths = false;                    ///< arc lengths, speeds or curvatures are measured
  bool chooses_metric = false;             ///< over channels that are named
  std::optional<double> step = {};         ///< between rows, where it is in seconds
  std::optional<double> plain_step = {};   ///< where it is in the unit of the times
  std::optional<double> time_gap = {};     ///< as in Columns
  bool is_rate = false;                    ///< rows are at a rate
  std::string_view range_like_clock = {};  ///< as in SamplingRequest
  std::string_view shown_rate = {};        ///< the frame rate that the file shows; empty: none
};

/// The notes of the doubts about a request. Throws: Error (data) for a doubt that the request has to decide.
std::vector<std::string> doubts_of_request(const Schema& schema, const RequestNeeds& needs);

/// The role of which this name is a near miss: with a letter dropped, added or changed, or two letters swapped. In
/// names of four letters a changed letter is no near miss, as it often makes another word, such as tide. Nothing for
/// others, and for those of tension, continuity and bias.
std::optional<Role> near_role(std::string_view name);

}  // namespace tcb
