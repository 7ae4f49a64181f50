// Converter: text in another encoding to UTF-8. converter_iconv.cpp by iconv of the C library, and
// converter_windows.cpp by Windows.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace tcb {

class Converter {
 public:
  explicit Converter(std::string_view encoding);
  ~Converter();

  /// Whether the system knows the encoding.
  bool is_known() const;

  /// Appends the converted bytes to a text, without a byte order mark. An incomplete character at the end waits for
  /// further bytes. Returns whether all bytes may be text.
  bool add(std::string_view bytes, std::string& text);

  bool is_complete() const { return rest_.empty(); }

 private:
  struct State;
  std::unique_ptr<State> state_;
  std::string rest_;
};

}  // namespace tcb
