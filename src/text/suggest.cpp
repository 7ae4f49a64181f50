// Names: the distance between them, and their case.
#include "text/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

#include "text/utf8.hpp"

namespace tcb {
namespace {

/// How many letters have to be changed, dropped or added to make b of a.
/// Source: R. A. Wagner, M. J. Fischer, "The string-to-string correction problem", doi:10.1145/321796.321811.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

template <class Text>
std::string joined(std::span<const Text> names) {
  constexpr std::size_t most = 20;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    if (i > 0) text += ", ";
    text += names[i];
  }
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return text;
}

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string_view> known) {
  const auto is_too_long = [&](std::string_view other) { return 2 * name.size() > 3 * other.size(); };
  if (std::ranges::all_of(known, is_too_long)) return "";
  const auto nearest =
      std::ranges::min_element(known, {}, [&](std::string_view other) { return edit_distance(name, other); });
  if (nearest == known.end() || edit_distance(name, *nearest) * 3 > std::max(name.size(), nearest->size())) return "";
  return std::string(*nearest);
}

std::string_view likely_name(std::string_view name, std::span<const std::string_view> known) {
  if (const std::string nearest = nearest_name(name, known); !nearest.empty())
    return *std::ranges::find(known, nearest);
  const auto only = [&](const auto& is_likely) {
    const auto found = std::ranges::find_if(known, is_likely);
    const bool is_one = found != known.end() && std::find_if(found + 1, known.end(), is_likely) == known.end();
    return is_one ? *found : std::string_view();
  };
  const auto has_same_letters = [&](std::string_view other) { return std::ranges::is_permutation(other, name); };
  const auto begins_so = [&](std::string_view other) { return name.size() > 1 && other.starts_with(name); };
  const auto contains_it = [&](std::string_view other) {
    return name.size() > 2 && other.find(name) != std::string_view::npos;
  };
  if (const std::string_view found = only(has_same_letters); !found.empty()) return found;
  if (const std::string_view found = only(begins_so); !found.empty()) return found;
  return only(contains_it);
}

std::string did_you_mean(std::string_view name, std::span<const std::string_view> known) {
  std::vector<std::string> lowered;
  std::ranges::transform(known, std::back_inserter(lowered), in_lower_case);
  const std::vector<std::string_view> compared(lowered.begin(), lowered.end());
  const std::string_view likely = likely_name(in_lower_case(name), compared);
  if (likely.empty()) return "";
  const auto index = static_cast<std::size_t>(std::ranges::find(compared, likely) - compared.begin());
  return "; did you mean " + std::string(known[index]) + "?";
}

std::string did_you_mean(std::string_view name, std::span<const std::string> known) {
  return did_you_mean(name, std::vector<std::string_view>(known.begin(), known.end()));
}

bool is_near(std::string_view name, std::string_view known) {
  if (std::max(name.size(), known.size()) - std::min(name.size(), known.size()) > 1) return false;
  const std::string one = in_lower_case(name), other = in_lower_case(known);
  const std::size_t shorter = std::min(one.size(), other.size());
  std::size_t first = 0, last = 0;  // how many letters are the same
  while (first < shorter && one[first] == other[first]) ++first;
  while (last < shorter - first && one[one.size() - 1 - last] == other[other.size() - 1 - last]) ++last;
  const std::string here = one.substr(first, one.size() - first - last);
  const std::string there = other.substr(first, other.size() - first - last);
  const auto are = [&](std::size_t a, std::size_t b) { return here.size() == a && there.size() == b; };
  if (are(1, 0) || are(0, 1)) return (here + there)[0] >= 'a' && (here + there)[0] <= 'z';
  return (are(1, 1) && known.size() > 4) || (are(2, 2) && here[0] == there[1] && here[1] == there[0]);
}

bool lists_word(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); !word.empty() && at < words.size(); at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return true;
  }
  return false;
}

std::vector<std::string> words_of(std::string_view name) {
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  const auto is_letter = [](char c) {
    return (lower(c) >= 'a' && lower(c) <= 'z') || static_cast<unsigned char>(c) > 127;
  };
  std::vector<std::string> words;
  char before = ' ';
  for (std::size_t at = 0; at < name.size(); ++at) {
    const char c = name[at];
    const char next = at + 1 < name.size() ? name[at + 1] : ' ';
    const bool is_new = is_capital(c) ? !is_capital(before) || (is_letter(next) && !is_capital(next))
                                      : is_letter(c) != is_letter(before);
    const bool follows_word = is_letter(before) || is_digit(before);
    before = c;
    if (!is_letter(c) && !is_digit(c)) continue;
    if (is_new || !follows_word) words.emplace_back();
    words.back() += lower(c);
  }
  return words;
}

std::string in_shell(std::string_view word) {
  const auto is_plain = [](char c) {
    return (lower(c) >= 'a' && lower(c) <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) > 127 ||
           std::string_view("_-./:=,+%@").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, is_plain)) return std::string(word);
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

std::string command_in_shell(std::span<const std::string> words) {
  std::string command;
  for (const std::string& word : words) command += (command.empty() ? "" : " ") + in_shell(word);
  if (printable(command) == command) return command;
  std::string format;  // of printf, within single quotes; a shell may expand ! in spite of them
  for (const char c : command) {
    const bool is_plain = c >= ' ' && c <= '~' && std::string_view("'\\!%").find(c) == std::string_view::npos;
    format += is_plain ? std::string(1, c) : fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  }
  return fmt::format("eval \"$(printf '{}')\"", format);
}

std::string listed(std::span<const std::string> names) { return joined(names); }
std::string listed(std::span<const std::string_view> names) { return joined(names); }

std::string how_many(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::string in_lower_case(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), lower);
  return result;
}

bool same_in_any_case(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, lower, lower); }

bool matches(std::string_view name, std::string_view pattern) {
  std::size_t star = std::string_view::npos, retry = 0, at = 0, next = 0;  // retry: what follows the last *
  while (at < name.size()) {
    if (next < pattern.size() && pattern[next] == '*') {
      star = next++;
      retry = at;
    } else if (next < pattern.size() && (pattern[next] == '?' || pattern[next] == name[at])) {
      ++at;
      ++next;
    } else if (star != std::string_view::npos) {
      next = star + 1;
      at = ++retry;
    } else {
      return false;
    }
  }
  while (next < pattern.size() && pattern[next] == '*') ++next;
  return next == pattern.size();
}

bool has_ending(std::string_view path, std::string_view ending) {
  if (path.size() <= ending.size() || path[path.size() - ending.size() - 1] == '/') return false;
  return std::ranges::equal(path.substr(path.size() - ending.size()), ending, {}, lower);
}

std::string_view compression_ending(std::string_view path) {
  for (const std::string_view ending : {".gz", ".zst"}) {
    if (has_ending(path, ending)) return ending;
  }
  return "";
}

std::string_view without_compression(std::string_view path) {
  return path.substr(0, path.size() - compression_ending(path).size());
}

}  // namespace tcb
