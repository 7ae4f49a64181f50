// NumPy arrays: the rows of .npy files as lines of delimited text.
//
// An array of two dimensions has columns by number, and a structured one of one dimension columns by name. Numbers are
// floats of 32 and 64 bits, integers and booleans, in either order of bytes. Each becomes the shortest decimal of its
// double, or a whole number.
// Source: NumPy, "numpy.lib.format", versions 1.0 to 3.0 of the format.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "numbers/print_number.hpp"
#include "read/csv/csv_reader.hpp"
#include "read/input.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

constexpr std::string_view npy_magic = "\x93NUMPY";
constexpr char npy_delimiter = '\t';
constexpr std::size_t most_columns = 1'000'000;

Error array_ends_early() {
  return data_error("the array ends early; expected as many rows as its header has; save it again");
}

Error unknown_header(std::string_view text) {
  return data_error(
      "the header of the array has {}; expected that of versions 1 to 3 of the format; save the array again with "
      "numpy.save",
      in_quotes(text));
}

/// Bytes that are read as needed.
class NpyBytes {
 public:
  explicit NpyBytes(Source<std::string> source) : source_(std::move(source)) {}

  /// The next bytes, as many as requested or all that are left.
  std::string take(std::size_t size) {
    while (buffer_.size() < size) {
      std::optional<std::string> more = source_();
      if (!more) break;
      buffer_ += *more;
    }
    std::string taken = buffer_.substr(0, size);
    buffer_.erase(0, taken.size());
    return taken;
  }
  std::string take_all(std::size_t size) {
    std::string taken = take(size);
    if (taken.size() < size) throw array_ends_early();
    return taken;
  }

 private:
  Source<std::string> source_;
  std::string buffer_;
};

/// The numbers of a column.
struct NpyColumn {
  std::string name;
  char kind = 'f';  ///< f: float, i: integer, u: unsigned, b: boolean
  std::size_t size = 8;
  bool is_big = false;     ///< the highest byte first
  std::size_t offset = 0;  ///< in a row
};

/// The description of an array.
struct NpyArray {
  std::vector<NpyColumn> columns;
  std::uint64_t rows = 0;
  std::size_t row_size = 0;
  bool is_structured = false;
};

Error not_a_number(std::string_view column, std::string_view type) {
  const std::string which = column.empty() ? "" : fmt::format(" has column {}, which", in_quotes(column));
  return data_error(
      "the array{} is of type {}; expected floats of 32 or 64 bits, integers or booleans; convert it, as with "
      "array.astype(float)",
      which, type);
}

Error not_plain(std::string_view column) {
  return data_error(
      "the array has column {}, which has columns of its own; expected numbers; convert it, as with "
      "numpy.lib.recfunctions.structured_to_unstructured(array)",
      in_quotes(column));
}

/// Reads the dictionary of a header, as Python writes it: {'descr': TYPE, 'fortran_order': BOOL, 'shape': (N, ...), }.
class NpyHeader {
 public:
  explicit NpyHeader(std::string_view text) : text_(text) {}

  NpyArray read() {
    NpyArray array;
    std::vector<std::uint64_t> shape;
    std::vector<std::string> known;
    list('{', '}', [&] {
      const std::size_t begin = at_;
      const std::string name = string();
      if (std::ranges::count(known, name) > 0) refuse(begin);
      known.push_back(name);
      expect(':');
      if (name == "descr") {
        read_columns(array);
      } else if (name == "fortran_order") {
        require_rows();
      } else if (name == "shape") {
        shape = numbers();
      } else {
        refuse(begin);
      }
    });
    blanks();
    if (at_ < text_.size()) refuse(at_);
    constexpr std::size_t entries = 3;
    if (known.size() < entries) {
      throw data_error(
          "the header of the array lacks an entry; expected descr, fortran_order and shape; save the array again with "
          "numpy.save");
    }
    set_shape(array, shape);
    return array;
  }

 private:
  [[noreturn]] void refuse(std::size_t at) const { throw unknown_header(text_.substr(std::min(at, text_.size()), 20)); }

  void blanks() { at_ = std::min(text_.find_first_not_of(" \n", at_), text_.size()); }
  bool skip(char c) {
    blanks();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!skip(c)) refuse(at_);
  }
  /// A list in brackets: entries that f reads, with commas between them, and one after the last or not. Returns how
  /// many commas it has.
  template <class F>
  std::size_t list(char first, char last, F f) {
    expect(first);
    std::size_t commas = 0;
    while (!skip(last)) {
      f();
      if (skip(',')) {
        ++commas;
        continue;
      }
      expect(last);
      break;
    }
    return commas;
  }
  std::string string() {
    blanks();
    const char quote = at_ < text_.size() ? text_[at_] : '\0';
    const std::size_t end = text_.find(quote, at_ + 1);
    if ((quote != '\'' && quote != '"') || end == std::string_view::npos) refuse(at_);
    std::string value(text_.substr(at_ + 1, end - at_ - 1));
    at_ = end + 1;
    return value;
  }
  /// Reads whether the numbers are column after column. Throws: Error (data) where they are.
  void require_rows() {
    constexpr std::string_view no = "False";
    blanks();
    if (text_.substr(at_).starts_with("True")) {
      throw data_error(
          "the array is stored column after column (fortran_order); expected row after row; save it again, as with "
          "numpy.ascontiguousarray(array)");
    }
    if (!text_.substr(at_).starts_with(no)) refuse(at_);
    at_ += no.size();
  }
  /// A tuple, which with one entry has a comma.
  std::vector<std::uint64_t> numbers() {
    std::vector<std::uint64_t> values;
    blanks();
    const std::size_t begin = at_;
    const std::size_t commas = list('(', ')', [&] {
      blanks();
      std::uint64_t value = 0;
      const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
      if (error != std::errc()) refuse(at_);
      at_ = static_cast<std::size_t>(end - text_.data());
      values.push_back(value);
    });
    if (values.size() == 1 && commas == 0) refuse(begin);
    return values;
  }

  void read_columns(NpyArray& array) {
    blanks();
    array.is_structured = at_ < text_.size() && text_[at_] == '[';
    if (!array.is_structured) return array.columns.push_back(column("", string()));
    list('[', ']', [&] {
      expect('(');
      const std::string name = string();
      expect(',');
      blanks();
      if (text_.substr(at_).starts_with('[')) throw not_plain(name);
      const NpyColumn one = column(name, string());
      std::uint64_t count = 1;
      const bool has_several = skip(',');
      for (const std::uint64_t size : has_several ? numbers() : std::vector<std::uint64_t>()) {
        count = size == 0 || count > most_columns / size ? 0 : count * size;
      }
      if (count == 0 || count + array.columns.size() > most_columns) refuse(at_);
      expect(')');
      for (std::uint64_t i = 0; i < count; ++i) {
        array.columns.push_back(one);
        if (has_several) array.columns.back().name += fmt::format("[{}]", i);
      }
    });
  }

  /// A type is the order of bytes, < or >, which is | for single bytes, a kind, and a size.
  static NpyColumn column(const std::string& name, const std::string& type) {
    NpyColumn column{name};
    const bool is_short = type.size() == 3;
    const std::size_t size = is_short && type[2] >= '1' && type[2] <= '8' ? static_cast<std::size_t>(type[2] - '0') : 0;
    column.is_big = type.starts_with('>');
    column.kind = is_short ? type[1] : '\0';
    column.size = size;
    const bool has_order = column.is_big || type.starts_with('<') || (type.starts_with('|') && size == 1);
    const bool is_float = column.kind == 'f' && (size == 4 || size == 8);
    const bool is_whole =
        (column.kind == 'i' || column.kind == 'u') && (size == 1 || size == 2 || size == 4 || size == 8);
    const bool is_number = is_float || is_whole || (column.kind == 'b' && size == 1);
    if (!has_order || !is_number) throw not_a_number(name, type);
    if (name.find_first_of("\t\r\n\"") != std::string::npos) {
      throw data_error("the column {} has a tab, a line end or a quote in its name; expected a name without; rename it",
                       in_quotes(name));
    }
    return column;
  }

  static void set_shape(NpyArray& array, const std::vector<std::uint64_t>& shape) {
    const std::size_t dimensions = array.is_structured ? 1 : 2;
    const bool is_good = !array.columns.empty() && shape.size() == dimensions &&
                         (array.is_structured || (shape[1] > 0 && shape[1] <= most_columns));
    if (!array.is_structured && shape.size() == 3 && (shape[1] == 3 || shape[1] == 4) && shape[2] == 4) {
      throw data_error(
          "the array has poses of {} x 4 numbers; expected two dimensions, a row for each key; write the rows of KITTI "
          "with numpy.savetxt(\"poses.txt\", array[:, :3].reshape(-1, 12)), which --input-format kitti reads",
          shape[1]);
    }
    if (!is_good) {
      throw data_error("the {}array has {} dimensions; expected {}; change its shape, as with numpy.column_stack",
                       array.is_structured ? "structured " : "", shape.size(),
                       array.is_structured ? "1" : "2, a row for each key");
    }
    array.rows = shape[0];
    if (!array.is_structured) array.columns.resize(shape[1], array.columns.front());
    for (NpyColumn& one : array.columns) {
      one.offset = array.row_size;
      array.row_size += one.size;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

void append(std::string& out, const NpyColumn& column, const char* bytes) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < column.size; ++i) {
    const std::size_t place = column.is_big ? column.size - 1 - i : i;
    bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[place])) << 8 * i;
  }
  if (column.kind == 'f') {
    const double value = column.size == 8 ? std::bit_cast<double>(bits)
                                          : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    if (value == value) return append_number(out, value);
    out += "nan";
    return;
  }
  const std::size_t unused = 64 - 8 * column.size;
  const auto is_signed = static_cast<std::int64_t>(bits << unused) >> unused;
  out += column.kind == 'i' ? std::to_string(is_signed) : std::to_string(bits);
}

/// The lines of rows that are read one after the other.
class NpyRows {
 public:
  NpyRows(NpyArray array, NpyBytes bytes) : array_(std::move(array)), bytes_(std::move(bytes)) {}

  std::optional<std::string> operator()() {
    if (row_ == array_.rows) {
      if (bytes_.take(1).empty()) return std::nullopt;
      throw data_error(
          "the file goes on after the array; expected as many rows as its header has; save each array in a file of its "
          "own");
    }
    constexpr std::uint64_t most_rows = 1024, most_bytes = 1UL << 20;
    const std::uint64_t rows =
        std::min({most_rows, std::max<std::uint64_t>(1, most_bytes / array_.row_size), array_.rows - row_});
    const std::string block = bytes_.take_all(rows * array_.row_size);
    std::string text;
    for (std::uint64_t i = 0; i < rows; ++i) {
      for (std::size_t k = 0; k < array_.columns.size(); ++k) {
        if (k > 0) text += npy_delimiter;
        append(text, array_.columns[k], block.data() + i * array_.row_size + array_.columns[k].offset);
      }
      text += '\n';
    }
    row_ += rows;
    return text;
  }

 private:
  NpyArray array_;
  NpyBytes bytes_;
  std::uint64_t row_ = 0;
};

/// The text of an array, and in `options` how it is delimited.
Source<std::string> text_of_npy(Source<std::string> bytes, InputOptions& options) {
  NpyBytes input(std::move(bytes));
  const std::string head = input.take_all(npy_magic.size() + 2);
  if (!head.starts_with(npy_magic)) {
    throw data_error(
        "the file is not an array of NumPy; expected one that numpy.save wrote; give another --input-format");
  }
  const auto version = static_cast<unsigned char>(head[npy_magic.size()]);
  if (version < 1 || version > 3) throw unknown_header(std::to_string(version));
  const std::string length = input.take_all(version == 1 ? 2 : 4);
  std::size_t size = 0;
  for (std::size_t i = length.size(); i-- > 0;) size = size << 8 | static_cast<unsigned char>(length[i]);
  constexpr std::size_t longest_header = 1UL << 24;
  if (size > longest_header) throw unknown_header(std::to_string(size));
  const std::string header = input.take_all(size);
  NpyArray array = NpyHeader(header).read();
  options.delimited = {};
  options.delimited.delimiter = npy_delimiter;
  options.delimited.header = array.is_structured;
  options.delimited.comment.clear();
  std::string names;
  for (const NpyColumn& column : array.columns) {
    if (array.is_structured) names += (names.empty() ? "" : std::string(1, npy_delimiter)) + column.name;
  }
  Source<std::string> rows = NpyRows(std::move(array), std::move(input));
  return names.empty() ? rows : preceded_by(names + "\n", std::move(rows));
}

Records open_npy(const Format&, Source<std::string> bytes, InputOptions options) {
  bytes = text_of_npy(std::move(bytes), options);
  Records records = open_delimited(std::move(bytes), options);
  records.columns.has_time_by_place = false;  // by what an array of keys is, which needs no note
  return records;
}

bool begins_npy(std::string_view beginning) { return beginning.starts_with(npy_magic); }

}  // namespace

extern const InputFormat npy_input{.open = open_npy, .begins = begins_npy};

}  // namespace tcb
