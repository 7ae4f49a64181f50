// NumPy's files, version 1.0: a head of fixed size, and the rows as doubles.
#include "output/npy.hpp"

#include <fmt/format.h>

#include <array>

#include "text/print_number.hpp"

namespace tcb {

std::string npy_head(std::size_t columns, std::uint64_t rows) {
  constexpr std::size_t size = 128;  // a multiple of 64, as the format asks for
  constexpr std::string_view magic("\x93NUMPY\x01\x00", 8);
  constexpr char rest = size - magic.size() - 2;
  std::string head(magic);
  head += {rest, '\0'};
  head += fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", rows, columns);
  head.resize(size - 1, ' ');
  return head + '\n';
}

Layout npy_layout(const std::vector<OutputColumn>& columns) {
  Layout layout;
  layout.head = npy_head(columns.size(), 0);
  layout.before.resize(columns.size());
  layout.notation.kind = Notation::Kind::bytes;
  std::array<char, number_room> nothing{};
  layout.empty = {nothing.data(),
                  write_number(std::numeric_limits<double>::quiet_NaN(), layout.notation, nothing.data())};
  return layout;
}

}  // namespace tcb
