// Sources: streams that are pulled item by item.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace tcb {

/// The next item, or nothing at the end. An item is computed when it is requested, not before, so memory
/// stays bounded and a slow pipe shows each row as soon as it can be known.
template <class T>
using Source = std::function<std::optional<T>()>;

/// A source with one more item in front.
template <class T>
Source<T> preceded_by(T item, Source<T> source) {
  return [first = std::optional<T>(std::move(item)), source = std::move(source)]() mutable {
    return first ? std::exchange(first, std::nullopt) : source();
  };
}

/// The items of a list.
template <class T>
Source<T> each_of(std::deque<T> items) {
  return [items = std::move(items)]() mutable -> std::optional<T> {
    if (items.empty()) return std::nullopt;
    std::optional<T> item(std::move(items.front()));
    items.pop_front();
    return item;
  };
}

/// Appends the next item to a text, which becomes the item if it is empty. Whether there was one.
inline bool append_next(std::string& text, const Source<std::string>& source) {
  std::optional<std::string> next = source();
  if (!next) return false;
  if (text.empty()) {
    text = std::move(*next);
  } else {
    text += *next;
  }
  return true;
}

/// The source of f(item), in order, on the thread that pulls.
template <class In, class F>
auto mapped(Source<In> source, F f) {
  using Out = decltype(f(std::declval<In>()));
  return Source<Out>([source = std::move(source), f = std::move(f)]() mutable -> std::optional<Out> {
    std::optional<In> item = source();
    if (!item) return std::nullopt;
    return f(std::move(*item));
  });
}

/// Passes items on, each once it was seen.
template <class T, class F>
Source<T> observed(Source<T> source, F see) {
  return mapped(std::move(source), [see = std::move(see)](T item) mutable {
    see(item);
    return item;
  });
}

}  // namespace tcb
