// Output formats: how rows, texts and breaks of each format are written.
#include "output/output_format.hpp"

#include <array>

#include "input/texts.hpp"
#include "output/npy.hpp"

namespace tcb {
namespace {

Layout csv_rows(const std::vector<OutputColumn>& columns, bool header) {
  return delimited_layout(columns, ',', header);
}
Layout tsv_rows(const std::vector<OutputColumn>& columns, bool header) {
  return delimited_layout(columns, '\t', header);
}
Layout ssv_rows(const std::vector<OutputColumn>& columns, bool header) {
  return delimited_layout(columns, ' ', header);
}
Layout json_rows(const std::vector<OutputColumn>& columns, bool) { return json_layout(columns); }
Layout jsonl_rows(const std::vector<OutputColumn>& columns, bool) { return jsonl_layout(columns); }
Layout npy_rows(const std::vector<OutputColumn>& columns, bool) { return npy_layout(columns); }

std::string csv_text(std::string_view text) { return delimited_text(content(text), ','); }
std::string tsv_text(std::string_view text) { return delimited_text(content(text), '\t'); }
std::string ssv_text(std::string_view text) { return text.empty() ? "NA" : delimited_text(content(text), ' '); }
std::string json_cell(std::string_view text) {
  return text.empty() ? "null" : is_string(text) ? json_text(content(text)) : std::string(text);
}

/// In the order of FormatId.
constexpr std::array<OutputFormat, formats.size()> output_formats{{
    {csv_rows, csv_text, "\n"},
    {tsv_rows, tsv_text, "\n"},
    {ssv_rows, ssv_text, "\n"},
    {json_rows, json_cell, "null"},
    {jsonl_rows, json_cell, "null\n"},
    {npy_rows, nullptr, "", npy_head},
}};

}  // namespace

const OutputFormat& output_format(FormatId format) { return output_formats[static_cast<std::size_t>(format)]; }

}  // namespace tcb
