// Reader: opens an input in the format that is given, or found by its ending or its first byte.
#include "input/reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "error.hpp"
#include "input/csv/key_parser.hpp"
#include "input/csv/records.hpp"
#include "input/json/shapes.hpp"

namespace tcb {
namespace {

/// Throws: Error (data) for a text in two or four bytes a character, and for what is no text.
void require_bytes(std::string_view beginning) {
  using namespace std::string_view_literals;
  if (beginning.starts_with("\x93NUMPY")) {
    throw Error(Exit::data, TextPosition{"", 1, 1},
                "the file is one of NumPy's; expected text; convert it, for example with numpy.savetxt");
  }
  const bool four = beginning.starts_with("\xFF\xFE\0\0"sv) || beginning.starts_with("\0\0\xFE\xFF"sv);
  if (!four && !beginning.starts_with("\xFF\xFE") && !beginning.starts_with("\xFE\xFF")) return;
  const char* const name = four ? "UTF-32" : "UTF-16";
  throw Error(
      Exit::data, TextPosition{"", 1, 1},
      fmt::format("the text is {}; expected UTF-8; convert it, for example with iconv -f {} -t UTF-8", name, name));
}

/// Drops a UTF-8 byte order mark. Throws: Error (data) for two.
Source<std::string> without_mark(Source<std::string> bytes) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  std::string beginning;
  constexpr std::size_t enough = 6;  // to tell what require_bytes() looks for
  while (beginning.size() < enough) {
    auto more = bytes();
    if (!more) break;
    beginning += *more;
  }
  require_bytes(beginning);
  if (beginning.starts_with(mark)) beginning.erase(0, mark.size());
  if (beginning.starts_with(mark)) {
    throw Error(Exit::data, TextPosition{"", 1, 1}, "a byte order mark twice; expected one at most; take it out");
  }
  return preceded_by(std::move(beginning), std::move(bytes));
}

/// The format by the file's ending, or by the first byte that is not blank.
FormatId detect(const std::string& path, const std::string& beginning) {
  if (const auto format = find_input_format(path)) return *format;
  const std::size_t at = beginning.find_first_not_of(" \t\r\n");
  const bool json = at != std::string::npos && (beginning[at] == '[' || beginning[at] == '{');
  return json ? FormatId::json : FormatId::csv;
}

Input open_as(FormatId format, Source<std::string> bytes, InputOptions options) {
  const char delimiter = format_of(format).delimiter;
  if (delimiter == '\0') return open_json(std::move(bytes), options);
  if (!options.delimiter && format != FormatId::csv) options.delimiter = delimiter;  // csv: any, to be found
  return open_delimited(std::move(bytes), options);
}

}  // namespace

Input open_input(const std::string& path, Source<std::string> bytes, const InputOptions& options) {
  bytes = without_mark(std::move(bytes));
  std::string beginning;
  for (bool blank = true; blank;) {
    auto more = bytes();
    if (!more) break;
    blank = more->find_first_not_of(" \t\r\n") == std::string::npos;
    beginning += *more;
    if (beginning.size() > longest_record) refuse_long_record(1);
  }
  const FormatId format = options.format ? *options.format : detect(path, beginning);
  Input input = open_as(format, preceded_by(std::move(beginning), std::move(bytes)), options);
  input.threads = options.threads;
  input.facts.format = format;
  return input;
}

}  // namespace tcb
