// Options: those that a command line gives, with their values; and the table of names, texts, defaults, values and
// conflicts, from which help, manual and completions are made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "check/compare_job.hpp"
#include "fit/fit_options.hpp"
#include "formats/formats.hpp"
#include "io/input_list.hpp"
#include "io/terminal.hpp"
#include "limits/limit_options.hpp"
#include "picture/picture.hpp"
#include "run/job.hpp"
#include "run/key_options.hpp"
#include "run/pace_profile.hpp"
#include "write/writer_options.hpp"

namespace tcb {

/// Texts that --generate prints instead of rows.
enum class Generated { manual, curves, bash, zsh, fish, tables };

/// A column of a file that has the times or arc lengths of an option.
struct PlaceColumn {
  std::string_view option;                               ///< its name
  std::string path, name;                                ///< without a name: the column of times
  std::shared_ptr<const std::string> content = nullptr;  ///< of the file, if it was read
};

/// The times or arc lengths of the option that has them.
struct PlacesOption {
  std::vector<Rational> list;  ///< or else by group:
  bool in_seconds = false;     ///< the list has durations, as in 30min
  GroupedPlaces grouped = {};
  std::optional<PlaceColumn> column = {};  ///< until it is read
  bool from_input = false;                 ///< they are read from standard input
};

/// The values of the options, each by itself; make_job decides what they mean together. An option is identified by its
/// long name.
struct TypedOptions {
  InputListOptions files;
  KeyOptions keys;
  SamplingRequest sampling;
  PlacesOption places;
  std::optional<PaceFile> pace_profile = {};  ///< of --pace
  FitOptions fit;
  Comparison comparison;
  LimitOptions limits;
  WriterOptions output{.format = &formats().front()};
  PictureOptions picture;
  ThreadOptions threads;
  std::optional<Generated> generated;
  ColorWhen color = ColorWhen::by_terminal;
  std::optional<std::size_t> form = {};  ///< the field with the cubics of pieces

  bool has(std::string_view option) const { return find(option) != nullptr; }
  /// The value of an option as typed; "" of a flag, and where it is not given.
  std::string value(std::string_view option) const;
  void give(std::string_view option, std::string value = {});

  /// Whether a text is printed, so that no other value is read.
  bool wants_text() const { return has("--help") || has("--list-presets") || has("--version") || generated; }

 private:
  struct Given {
    std::string_view option;  ///< its name
    std::string value;
  };
  const Given* find(std::string_view option) const;

  std::vector<Given> given_;
};

/// Throws: Error (usage) for unknown options, and for values that are wrong in themselves. `color`: where errors are
/// shown, which is set before the first that is about a value.
TypedOptions read_options(const std::vector<std::string>& given, ColorWhen* color = nullptr);

// The groups of options.
inline constexpr std::string_view sampling_group = "Sampling", curve_group = "Curve", input_group = "Input",
                                  output_group = "Output", files_group = "Many files", comparison_group = "Comparison",
                                  about_group = "About";

/// In the order in which a reader of the help needs them.
inline constexpr std::array option_groups{sampling_group, curve_group,      input_group, output_group,
                                          files_group,    comparison_group, about_group};

/// What the value of an option is, for completions.
enum class ValueKind {
  flag,
  name,   ///< one of `known`
  names,  ///< several of `known`, separated by commas
  file,
  folder,
  roles,     ///< ROLE=COLUMN, separated by commas
  places,    ///< numbers, or @FILE
  attached,  ///< a text in the word of the option, or none
  other,
};

/// What a command line requests, where options differ in what they change of it.
enum Product : std::uint16_t {
  of_samples = 1,
  of_pieces = 2,
  of_fit = 4,
  of_check = 8,
  of_expected_rows = 16,  ///< a comparison, also with the rows that sampling options request
  of_identify = 32,
  of_limits = 64,
  of_picture = 128,  ///< without requested samples
  of_drawn_samples = 256,
  of_explanation = 512,  ///< without requested samples
  of_explained_samples = 1024,
};
using Products = std::uint16_t;

/// Where an option may change a byte: in the output of some products, if the format of rows offers what it asks for.
/// Elsewhere it is refused.
struct Effect {
  Products products;
  offer::Offer asks_for;

  constexpr Effect(int on, offer::Offer asked = offer::nothing)  // NOLINT(google-explicit-constructor)
      : products(static_cast<Products>(on)), asks_for(asked) {}
};

/// An option. To add one: its row in the table.
struct OptionRow {
  std::string_view name;        ///< as in "--step", which identifies it
  std::string_view other_name;  ///< a letter such as "-s", a second long name, or empty
  std::string_view value;       ///< what the help calls its value; empty for a flag
  std::string_view group;
  Effect effect;
  std::string_view text;           ///< what it does, without a point at the end; @NAMES@ stands for `known`
  std::string_view default_value;  ///< as it would be typed; empty: none, or described in the text
  ValueKind kind;
  /// Reads the value. Throws: Error (usage); the caller adds the name of the option.
  void (*store)(TypedOptions& typed, const std::string& value);
  /// The names that the value is made of, for ValueKind::name and names.
  std::vector<std::string_view> (*known)() = nullptr;

  /// The names that its value is made of, if it has such names.
  std::vector<std::string_view> known_names() const {
    return known == nullptr ? std::vector<std::string_view>() : known();
  }
  /// Both names, a letter first.
  std::vector<std::string_view> all_names() const;
  std::string description() const;
};

/// All options, by groups. Where several are at fault, an error is about the first.
std::span<const OptionRow> option_table();

const OptionRow& row_of(std::string_view name);

/// With blanks between them.
inline constexpr std::string_view sampling_options =
    "--step --rate --fps --count --per-segment --at --arc-step --arc-count --arc-at --tolerance --emit --fit";

bool has_sampling_option(const TypedOptions& typed);

/// The product of these options, of rows also where their times are scaled.
Product product_of(const TypedOptions& typed);

/// Whether samples are compared, so that there is a report.
bool is_comparison(const TypedOptions& typed);
/// Whether maxima are printed, so that there is a report.
bool prints_limits(const TypedOptions& typed);

/// No length, speed or distance is requested, so that a metric has no effect.
bool needs_no_metric(const TypedOptions& typed);

/// Throws: Error (usage) for the first option that is given without effect, and for the first conflict, each in the
/// order of its table.
void require_no_conflict(const TypedOptions& typed);

}  // namespace tcb
