// Microbenchmarks of numbers to text and back: this program's code, std::to_chars, fmt and std::from_chars.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <bit>
#include <charconv>
#include <random>
#include <string>
#include <vector>

#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"

namespace {

using Values = std::vector<double>;
using Texts = std::vector<std::string>;

double unit(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

template <class Next>
Values values(const Next& next) {
  std::mt19937_64 random(1);
  Values result(10'000);
  for (double& value : result) value = next(random);
  return result;
}

const Values random_bits =
    values([](std::mt19937_64& random) { return std::bit_cast<double>(random() & 0xBFEFFFFFFFFFFFFF); });
const Values between_0_and_1 = values(unit);
const Values coordinates = values([](std::mt19937_64& random) { return 200 * unit(random) - 100; });
const Values thousandths =
    values([](std::mt19937_64& random) { return static_cast<double>(random() % 1'000'000) / 1000; });
const Values integers = values([](std::mt19937_64& random) { return static_cast<double>(random() % 100'000); });

Texts texts(const Values& values) {
  Texts result;
  for (const double value : values) result.push_back(fmt::format("{}", value));
  return result;
}

template <class Write>
void print(benchmark::State& state, const Values& values, const Write& write) {
  std::array<char, 512> text;
  for (auto _ : state) {
    for (const double value : values) benchmark::DoNotOptimize(write(value, text.data()));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(values.size()));
}

template <class Read>
void read(benchmark::State& state, const Values& values, const Read& parse) {
  const Texts all = texts(values);
  for (auto _ : state) {
    for (const std::string& text : all) benchmark::DoNotOptimize(parse(text));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(values.size()));
}

char* to_chars(double value, char* out) { return std::to_chars(out, out + tcb::number_room, value).ptr; }
char* to_chars_fixed(double value, char* out) {
  return std::to_chars(out, out + 512, value, std::chars_format::fixed, 6).ptr;
}
char* to_chars_digits(double value, char* out) {
  return std::to_chars(out, out + 512, value, std::chars_format::general, 9).ptr;
}
char* with_fmt(double value, char* out) { return fmt::format_to(out, "{}", value); }
char* time(double value, char* out) { return tcb::write_time(value, out); }
char* fixed(double value, char* out) { return tcb::write_fixed(value, 6, out); }
char* digits(double value, char* out) { return tcb::write_digits(value, 9, out); }
double from_chars(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

void compare(const std::string& name, const Values& values) {
  const auto printing = [&](const char* way, auto write) {
    benchmark::RegisterBenchmark(("print/" + name + "/" + way).c_str(),
                                 [=, &values](benchmark::State& state) { print(state, values, write); });
  };
  const auto reading = [&](const char* way, auto parse) {
    benchmark::RegisterBenchmark(("read/" + name + "/" + way).c_str(),
                                 [=, &values](benchmark::State& state) { read(state, values, parse); });
  };
  printing("ours", tcb::write_shortest);
  printing("ours_as_time", time);
  printing("to_chars", to_chars);
  printing("fmt", with_fmt);
  printing("six_decimals", fixed);
  printing("six_decimals_by_to_chars", to_chars_fixed);
  printing("nine_digits", digits);
  printing("nine_digits_by_to_chars", to_chars_digits);
  reading("ours", tcb::parse_number);
  reading("ours_as_time", tcb::parse_time);
  reading("from_chars", from_chars);
}

}  // namespace

int main(int count, char** arguments) {
  compare("random_bits", random_bits);
  compare("between_0_and_1", between_0_and_1);
  compare("coordinates", coordinates);
  compare("thousandths", thousandths);
  compare("integers", integers);
  benchmark::Initialize(&count, arguments);
  benchmark::RunSpecifiedBenchmarks();
}
