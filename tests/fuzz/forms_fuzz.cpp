// Fuzzer of the forms of a table: random keys, written in every form that a reader knows, are the keys that were drawn,
// and a form with a fault is refused. The bytes of an input are choices.
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "choices.hpp"
#include "reading.hpp"

namespace tcb::fuzz {
namespace {

/// Keys as text: a time and positions in each row, which are multiples of 1/8, so that all types have them.
struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;
};

Table draw_table(Choices& choices) {
  Table table{{"t"}, {}};
  const char* const names[] = {"x", "y", "z", "fov", "a b", "a\\\"b", "\xC3\xA9"};
  const std::size_t first = choices.number(6), channels = 1 + choices.number(2);
  for (std::size_t i = 0; i < channels; ++i) table.names.emplace_back(names[(first + i) % std::size(names)]);
  const std::size_t rows = 2 + choices.number(4);
  std::size_t time = choices.number(100);
  const bool whole = choices.yes();
  for (std::size_t row = 0; row < rows; ++row) {
    time += 1 + choices.number(20);
    table.rows.push_back({fmt::format("{}", time)});
    for (std::size_t i = 0; i < channels; ++i) {
      const double value = static_cast<double>(choices.number(250)) - 125;
      table.rows.back().push_back(fmt::format("{}", whole ? value : value / 8));
    }
  }
  return table;
}

/// What is wrong with a form.
enum class Fault { none, cell_missing, cell_surplus, cut, member_twice, nested, count, text };

/// Joins `count` texts by commas, in brackets or braces, with blanks that choices draw.
template <class Item>
std::string joined(Choices& choices, std::string_view brackets, std::size_t count, Item item) {
  const char* const blanks[] = {"", "", " ", "\n"};
  std::string text(1, brackets[0]);
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += ',';
    text += blanks[choices.number(3)];
    text += item(i);
  }
  return text + blanks[choices.number(3)] + brackets[1];
}

std::string quoted(std::string_view text) { return fmt::format("\"{}\"", text); }

/// The table as JSON: records, lines, lists, tables of pandas in each orientation, arrays, wrappers.
std::string to_json(Choices& choices, const Table& table, Fault fault, bool& are_lines) {
  const std::size_t rows = table.rows.size(), columns = table.names.size();
  const std::size_t bad = choices.number(rows - 1);
  const auto member = [&](std::size_t row, std::size_t column) {
    return fmt::format("{}:{}", quoted(table.names[column]), table.rows[row][column]);
  };
  const auto record = [&](std::size_t row) {
    const bool here = row == bad;
    const std::size_t count = here && fault == Fault::cell_missing ? columns - 1 : columns;
    const std::size_t first = columns - count;  // without a time: other members may be in some records only
    std::string text = joined(choices, "{}", count, [&](std::size_t column) { return member(row, first + column); });
    if (here && (fault == Fault::member_twice || fault == Fault::cell_surplus)) {
      text.insert(1, member(row, columns - 1) + ",");
    }
    if (here && fault == Fault::nested) {
      text.insert(1, fmt::format("\"n\":{}1{},", std::string(300, '['), std::string(300, ']')));
    }
    return text;
  };
  const auto records = [&] { return joined(choices, "[]", rows, record); };
  const auto cells = [&](std::size_t row) {
    std::size_t count = columns;
    if (row == bad && fault == Fault::cell_missing) count -= 1;
    if (row == bad && fault == Fault::cell_surplus) count += 1;
    return joined(choices, "[]", count,
                  [&](std::size_t column) { return column < columns ? table.rows[row][column] : std::string("1"); });
  };
  const auto arrays = [&] { return joined(choices, "[]", rows, cells); };
  const auto names = [&] {
    return joined(choices, "[]", columns, [&](std::size_t column) { return quoted(table.names[column]); });
  };
  // The cells of a column, by an index or not.
  const auto column = [&](std::size_t c, bool by_index) {
    std::size_t count = rows;
    if (c + 1 == columns && fault == Fault::cell_missing) count -= 1;
    if (c + 1 == columns && fault == Fault::cell_surplus) count += 1;
    const auto cell = [&](std::size_t row) {
      const std::string value = row < rows ? table.rows[row][c] : "1";
      return by_index ? fmt::format("\"{}\":{}", row, value) : value;
    };
    return quoted(table.names[c]) + ":" + joined(choices, by_index ? "{}" : "[]", count, cell);
  };
  const auto columns_by = [&](bool by_index) {
    std::string text = joined(choices, "{}", columns, [&](std::size_t c) { return column(c, by_index); });
    if (fault == Fault::member_twice) text.insert(1, column(columns - 1, by_index) + ",");
    return text;
  };
  switch (choices.number(8)) {
    case 0: return records();
    case 1: {
      are_lines = true;
      std::string text;
      for (std::size_t row = 0; row < rows; ++row) {
        std::string line = record(row);
        std::ranges::replace(line, '\n', ' ');
        text += line + "\n";
      }
      return text;
    }
    case 2: return columns_by(false);
    case 3: return columns_by(true);
    case 4: {
      const std::string data = arrays();
      const std::string index = joined(choices, "[]", rows, [](std::size_t row) { return fmt::format("{}", row); });
      std::string text = fmt::format("{{\"columns\":{},\"index\":{},\"data\":{}}}", names(), index, data);
      if (fault == Fault::member_twice) text.insert(1, fmt::format("\"columns\":{},", names()));
      return text;
    }
    case 5:
      return joined(choices, "{}", rows, [&](std::size_t row) { return fmt::format("\"{}\":{}", row, record(row)); });
    case 6: {
      std::string text = fmt::format("{{\"closed\":false,\"keys\":{}}}", records());
      if (fault == Fault::nested) {
        text.insert(1, fmt::format("\"n\":{}1{},", std::string(300, '['), std::string(300, ']')));
      }
      return text;
    }
    case 7: return fmt::format("{{\"curves\":[{{\"keys\":{}}}]}}", records());
    default: {
      const auto key = [&](std::size_t row) {
        std::string text = fmt::format("{{\"position\":[");
        std::size_t count = columns;
        if (row == bad && fault == Fault::cell_missing) count -= 1;
        if (row == bad && fault == Fault::cell_surplus) count += 1;
        for (std::size_t c = 1; c < count; ++c) text += (c > 1 ? "," : "") + (c < columns ? table.rows[row][c] : "1");
        text += fmt::format("],\"t\":{}", table.rows[row][0]);
        if (row == bad && fault == Fault::member_twice) text += ",\"t\":0";
        return text + "}";
      };
      return joined(choices, "[]", rows, key);
    }
  }
}

template <class T>
void append(std::string& bytes, double value, bool big_endian) {
  const T number = static_cast<T>(value);
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  if (big_endian) std::reverse(raw, raw + sizeof number);
  bytes.append(raw, sizeof number);
}

/// The table as an array of NumPy: each version, type and order of bytes; rows of numbers or of records.
std::string to_npy(Choices& choices, const Table& table, Fault fault) {
  const bool is_whole = std::ranges::none_of(table.rows, [](const auto& row) {
    return std::ranges::any_of(row, [](const std::string& cell) { return cell.find('.') != std::string::npos; });
  });
  const char type = is_whole ? choices.one({'f', 'i'}) : 'f';
  const int width = type == 'f' ? choices.one({8, 4}) : choices.one({8, 4, 2});
  const bool big_endian = choices.yes(), is_structured = choices.yes();
  const std::size_t rows = table.rows.size(), columns = table.names.size();
  const std::string number = fmt::format("'{}{}{}'", big_endian ? '>' : '<', type, width);
  std::string descr = number;
  if (is_structured) {
    descr = "[";
    for (std::size_t c = 0; c < columns; ++c)
      descr += fmt::format("('{}', {}), ", c == 0 ? "t" : fmt::format("c{}", c), number);
    descr += "]";
  }
  const std::string shape = is_structured ? fmt::format("({},)", rows) : fmt::format("({}, {})", rows, columns);
  std::string header = fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': {}, }}", descr, shape);
  if (fault == Fault::nested) header.insert(header.find(", 'shape'"), "s");
  if (fault == Fault::member_twice) header.replace(header.find("'shape'"), 7, "'shapes'");
  if (fault == Fault::count) header.replace(header.find(shape), 1, "((");
  const int version = 1 + static_cast<int>(choices.number(2));
  const std::size_t before = version == 1 ? 10 : 12;
  while ((before + header.size() + 1) % 64 != 0) header += ' ';
  header += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += static_cast<char>(version);
  bytes += '\0';
  for (std::size_t i = 0; i < before - 8; ++i) bytes += static_cast<char>(header.size() >> (8 * i) & 255);
  bytes += header;
  const auto put = [&](std::size_t row, std::size_t column) {
    const double value = std::stod(table.rows[row][column]);
    if (type == 'f')
      return width == 8 ? append<double>(bytes, value, big_endian) : append<float>(bytes, value, big_endian);
    if (width == 8) return append<std::int64_t>(bytes, value, big_endian);
    width == 4 ? append<std::int32_t>(bytes, value, big_endian) : append<std::int16_t>(bytes, value, big_endian);
  };
  for (std::size_t i = 0; i < rows * columns; ++i) put(i / columns, i % columns);
  if (fault == Fault::cell_surplus) bytes += std::string(static_cast<std::size_t>(width), '\0');
  if (fault == Fault::cell_missing) bytes.resize(bytes.size() - static_cast<std::size_t>(width));
  return bytes;
}

/// The table as delimited text.
std::string to_delimited(Choices& choices, const Table& table, Fault fault, char delimiter) {
  const std::size_t bad = choices.number(table.rows.size() - 1);
  const std::string_view end = choices.one({"\n", "\r\n"});
  std::string text;
  const auto line = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) text += (i > 0 ? std::string(1, delimiter) : "") + cells[i];
    text += end;
  };
  std::vector<std::string> names{"t"};
  for (std::size_t c = 1; c < table.names.size(); ++c) names.push_back(fmt::format("c{}", c));
  line(names);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    std::vector<std::string> cells = table.rows[row];
    if (row == bad && fault == Fault::cell_missing) cells.pop_back();
    if (row == bad && fault == Fault::cell_surplus) cells.emplace_back("1");
    if (row == bad && fault == Fault::nested) cells.back() = "1e999";
    line(cells);
  }
  return text;
}

/// The table as a scene of 3D Studio: the track of positions of an object, of three channels.
std::string to_3ds(const Table& table, Fault fault) {
  const auto word = [](std::uint64_t value, int size) {
    std::string bytes;
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
    return bytes;
  };
  const auto chunk = [&](unsigned id, const std::string& content) {
    return word(id, 2) + word(content.size() + 6, 4) + content;
  };
  std::string track = std::string(10, '\0') + word(table.rows.size() + (fault == Fault::count ? 1 : 0), 4);
  for (const auto& row : table.rows) {
    track += word(std::stoull(row[0]), 4) + word(0, 2);
    for (std::size_t c = 1; c < row.size(); ++c) append<float>(track, std::stod(row[c]), false);
  }
  if (fault == Fault::cell_missing) track.resize(track.size() - sizeof(float));
  if (fault == Fault::cell_surplus) track += word(0, sizeof(float));
  const std::string node = chunk(0xB010, std::string("a") + '\0' + word(0, 6)) + chunk(0xB020, track);
  return chunk(0x4D4D, chunk(2, word(3, 4)) + chunk(0xB000, chunk(0xB002, node)));
}

/// The table as a motion of LightWave, whose first three channels are the position.
std::string to_lightwave(const Table& table, Fault fault) {
  std::string text = "LWMO\n3\n\nNumChannels 3\n";
  for (std::size_t c = 0; c < 3; ++c) {
    text += fmt::format("Channel {}\n{{ Envelope\n  {}\n", c, table.rows.size() + (fault == Fault::count ? 1 : 0));
    for (const auto& row : table.rows) {
      const bool is_bad = c == 1 && &row == &table.rows.back();
      const std::string_view value = is_bad && fault == Fault::text ? "o.5" : std::string_view(row[c + 1]);
      const std::string_view numbers = is_bad && fault == Fault::cell_missing ? "0 0 0" : "0 0 0 0 0 0 0";
      text += fmt::format("  Key {} {} {}\n", value, row[0], numbers);
    }
    text += "  Behaviors 1 1\n}\n";
  }
  return text;
}

/// A text in another encoding, with its mark.
std::string encoded(std::string_view text, int width, bool big_endian) {
  std::string bytes;
  const auto put = [&](std::uint32_t code) {
    for (int i = 0; i < width; ++i) bytes += static_cast<char>(code >> 8 * (big_endian ? width - 1 - i : i) & 255);
  };
  put(0xFEFF);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);  // the texts of this file have no character above U+07FF
    if (byte < 0x80) {
      put(byte);
    } else {
      put((byte & 0x1FU) << 6 | (static_cast<unsigned char>(text[++i]) & 0x3FU));
    }
  }
  return bytes;
}

std::string numbers_of(const Table& table) {
  InputOptions options;
  options.format = find_format("csv");
  std::string text = "t";
  for (std::size_t c = 1; c < table.names.size(); ++c) text += fmt::format(",c{}", c);
  text += '\n';
  for (const auto& row : table.rows) text += fmt::format("{}\n", fmt::join(row, ","));
  const Reading reading = read(text, options, std::string::npos);
  require(!reading.refused, "keys of a table are refused", text + reading.text);
  return reading.numbers;
}

/// The lines without the zeros at their ends, as a track has tension, continuity and bias for each of its channels.
std::string without_last_zeros(std::string_view lines) {
  std::string text;
  for (; !lines.empty(); lines.remove_prefix(lines.find('\n') + 1)) {
    std::string_view line = lines.substr(0, lines.find('\n'));
    while (line.ends_with(" 0")) line.remove_suffix(2);
    text += fmt::format("{}\n", line);
  }
  return text;
}

void try_form(Choices& choices) {
  Table table = draw_table(choices);
  Fault fault = choices.one({Fault::none, Fault::none, Fault::none, Fault::cell_missing, Fault::cell_surplus,
                             Fault::cut, Fault::member_twice, Fault::nested, Fault::count, Fault::text});
  const std::size_t piece = 1 + choices.number(63);
  InputOptions options;
  std::string text;
  Table written = table;
  switch (choices.number(6)) {
    case 0:
    case 1: {
      bool are_lines = false;
      if (fault == Fault::text) {  // in place of a tension, which no channel can be
        written.names.emplace_back("tension");
        for (auto& row : written.rows) row.emplace_back("0");
        written.rows[choices.number(written.rows.size() - 1)].back() = choices.one({"\"o.5\"", "[1]", "true"});
      }
      if (fault == Fault::count) fault = Fault::none;
      text = to_json(choices, written, fault, are_lines);
      if (fault == Fault::nested && text.find("[[[[[") == std::string::npos)
        fault = Fault::none;                                      // a form without records
      if (fault == Fault::cut && are_lines) fault = Fault::none;  // fewer lines are a form as well
      options.format = find_format(are_lines ? "jsonl" : "json");
      break;
    }
    case 2:
      if (fault == Fault::text) fault = Fault::none;
      text = to_npy(choices, table, fault);
      options.format = find_format("npy");
      break;
    case 3:
    case 4:
    case 5: {
      table.names.resize(4, "c");
      for (std::size_t i = 0; i < table.rows.size(); ++i) {
        table.rows[i].resize(4, "0");
        table.rows[i][3] = fmt::format("{}", i);  // a track that never changes would be left out
      }
      const std::string_view format = choices.one({"3ds", "lws"});
      options.format = find_format(format);
      const Fault other = format == "3ds" ? Fault::cut : Fault::none;
      const bool has_form = fault == other || fault == Fault::cell_missing || fault == Fault::count ||
                            (fault == Fault::cell_surplus && format != "lws") ||
                            (fault == Fault::text && format != "3ds");
      if (!has_form) fault = Fault::none;
      text = format == "3ds" ? to_3ds(table, fault) : to_lightwave(table, fault);
      break;
    }
    default: {
      if (fault == Fault::member_twice || fault == Fault::count || fault == Fault::cut) fault = Fault::none;
      if (fault == Fault::text) table.rows[choices.number(table.rows.size() - 1)][0] = "1 2";
      const char delimiter = choices.one({',', '\t'});
      text = to_delimited(choices, table, fault, delimiter);
      options.format = find_format(delimiter == ',' ? "csv" : "tsv");
    }
  }
  const bool is_table =
      options.format != find_format("npy") && options.format->name != "3ds" && options.format->name != "lws";
  if (is_table && fault != Fault::cut && choices.number(3) == 0) {
    text = encoded(text, choices.one({2, 4}), choices.yes());
  }
  if (fault == Fault::cut) text.resize(text.size() - 1 - choices.number(text.size() / 2));
  const Reading reading = read(text, options, std::string::npos);
  if (fault == Fault::none) {
    require(!reading.refused, "a form is refused", text + "\n" + reading.text);
    require_same(without_last_zeros(numbers_of(table)), without_last_zeros(reading.numbers), text);
  } else {
    require(reading.refused, "a form with a fault is read",
            fmt::format("fault {}: {}\n{}", static_cast<int>(fault), text, reading.text));
  }
  require_same_readings(text, options, piece, false);
}

}  // namespace
}  // namespace tcb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tcb::fuzz::Choices choices(data, size);
  tcb::fuzz::try_form(choices);
  return 0;
}
