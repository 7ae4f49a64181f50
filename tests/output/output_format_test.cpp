// Output formats: what each of them writes can be read again.
#include "output/output_format.hpp"

#include <gtest/gtest.h>

#include "input/reading.hpp"

namespace tcb {
namespace {

TEST(OutputFormat, each_layout_writes_what_its_format_reads) {
  const std::vector<OutputColumn> columns{{"t", CellKind::time}, {"the x", CellKind::real}};
  for (const Format& format : formats) {
    if (!format.can_read || !format.can_write) continue;
    const Layout layout = output_format(format.id).layout(columns, true);
    std::string text = layout.head;
    append_rows(text, layout, columns, {Cell(0), Cell(0.1), Cell(1), Cell(-2)}, true);
    text += layout.tail;
    InputOptions options;
    options.format = format.id;
    const std::string keys = read(text, options);
    EXPECT_TRUE(keys.starts_with("t the x\n")) << keys;
    EXPECT_NE(keys.find(": 0 0.1\n"), std::string::npos) << keys;
    EXPECT_NE(keys.find(": 1 -2\n"), std::string::npos) << keys;
  }
}

}  // namespace
}  // namespace tcb
