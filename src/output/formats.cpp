// Output formats: layouts and texts of delimited text, JSON, JSON Lines, and NumPy files.
#include <fmt/format.h>

#include <array>
#include <limits>

#include "input/texts.hpp"
#include "output/layout.hpp"
#include "text/print_number.hpp"

namespace tcb {
namespace {

template <char delimiter>
Layout delimited_rows(const std::vector<OutputColumn>& columns, bool header) {
  return delimited_layout(columns, delimiter, header);
}

Layout json_rows(const std::vector<OutputColumn>& columns, bool) { return json_layout(columns); }
Layout jsonl_rows(const std::vector<OutputColumn>& columns, bool) { return jsonl_layout(columns); }
Layout npy_rows(const std::vector<OutputColumn>& columns, bool) { return npy_layout(columns); }

std::string csv_text(std::string_view text) { return delimited_text(content(text), ','); }
std::string tsv_text(std::string_view text) { return delimited_text(content(text), '\t'); }
std::string ssv_text(std::string_view text) { return text.empty() ? "NA" : delimited_text(content(text), ' '); }

std::string json_cell(std::string_view text) {
  if (text.empty()) return "null";
  return is_string(text) ? json_text(content(text)) : std::string(text);
}

/// In the order of FormatId.
constexpr std::array<OutputFormat, formats.size()> output_formats{{
    {delimited_rows<','>, csv_text, "\n"},
    {delimited_rows<'\t'>, tsv_text, "\n"},
    {delimited_rows<' '>, ssv_text, "\n"},
    {json_rows, json_cell, "null"},
    {jsonl_rows, json_cell, "null\n"},
    {npy_rows, nullptr, "", npy_head},
}};

}  // namespace

const OutputFormat& output_format(FormatId format) { return output_formats[static_cast<std::size_t>(format)]; }

std::string npy_head(std::size_t columns, std::uint64_t rows) {
  constexpr std::size_t size = 128;  // a multiple of 64, as the format requires
  constexpr std::string_view magic("\x93NUMPY\x01\x00", 8);
  constexpr char remaining = size - magic.size() - 2;
  std::string head(magic);
  head += {remaining, '\0'};
  head += fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", rows, columns);
  head.resize(size - 1, ' ');
  return head + '\n';
}

Layout npy_layout(const std::vector<OutputColumn>& columns) {
  Layout layout;
  layout.head = npy_head(columns.size(), 0);
  layout.before.resize(columns.size());
  layout.notation.kind = Notation::Kind::bytes;
  std::array<char, number_room> bytes{};
  layout.empty = {bytes.data(), write_number(std::numeric_limits<double>::quiet_NaN(), layout.notation, bytes.data())};
  return layout;
}

}  // namespace tcb
