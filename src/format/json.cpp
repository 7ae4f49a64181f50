// JSON: from the text of key objects to keys.
#include "format/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "error.hpp"
#include "format/json_events.hpp"
#include "format/json_split.hpp"
#include "format/number.hpp"

namespace tcb::format {
namespace {

using Member = JsonColumns::Member;

/// Turns events into keys.
class KeyBuilder : public JsonEvents {
 public:
  KeyBuilder(const Chunk& chunk, const JsonColumns& columns, const spline::Tcb<double>& tcb)
      : JsonEvents(chunk), columns_(columns), tcb_(tcb), seen_(columns.members.size()) {
    block_.keys.channels = columns.columns.channels.size();
    timed_ = columns.columns.has(Role::time);
    eased_ = columns.columns.has(Role::ease_in) || columns.columns.has(Role::ease_out);
  }
  KeyBlock take() { return std::move(block_); }

 private:
  bool on_key_start() override {
    spline::Keys<double>& keys = block_.keys;
    if (timed_) keys.times.emplace_back();
    if (eased_) keys.eases.emplace_back();
    keys.tcbs.push_back(tcb_);
    keys.positions.resize(keys.positions.size() + keys.channels);
    block_.lines.push_back(line());
    seen_.assign(seen_.size(), false);
    expected_ = 0;
    return true;
  }

  bool on_member(const std::string& name) override {
    const auto& members = columns_.members;
    if (expected_ == members.size() || members[expected_].name != name) {
      expected_ = static_cast<std::size_t>(std::ranges::find(members, name, &Member::name) - members.begin());
    }
    current_ = expected_ < members.size() ? &members[expected_] : nullptr;
    if (current_ == nullptr) return true;
    if (seen_[expected_]) fail(fmt::format("{}: a second time in one key; expected once; take one out", path()));
    seen_[expected_++] = true;
    return true;
  }

  bool on_number(const spline::Time<double>& value) override {
    if (current_ == nullptr) {
      if (in_array()) return true;
      fail(fmt::format("{}: not in the first key; expected the same members in every key; add it there", path()));
    }
    if (current_->cells == 0) return true;
    if (current_->array != in_array()) refuse_shape();
    const std::size_t index = in_array() ? element() : 0;
    if (index < current_->cells) store(columns_.columns.cells[current_->cell + index], value);
    return true;
  }

  bool on_other(std::string_view text) override {
    if (current_ == nullptr || current_->cells == 0) return true;
    if (text == "null")
      fail(fmt::format("{}: null where a number was expected; fill it in, or take the key out", path()));
    fail(fmt::format("{}: \"{}\" is not a number; expected one without quotes; correct it", path(), text));
  }

  bool on_array_end() override {
    if (current_ == nullptr || current_->cells == 0) return true;
    if (!current_->array) refuse_shape();
    if (element() == current_->cells) return true;
    fail(fmt::format("{}: an array of {}; expected {} numbers, as in the first key; correct it", path(), element(),
                     current_->cells));
  }

  bool on_key_end() override {
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const Member& member = columns_.members[i];
      if (seen_[i] || !member.required) continue;
      fail_key(fmt::format("a key without \"{}\"; expected the members of the first key; add it", member.name));
    }
    return true;
  }

  void store(Columns::Column column, const spline::Time<double>& value) {
    spline::Keys<double>& keys = block_.keys;
    switch (column.role) {
      case Role::left_out: break;
      case Role::time: keys.times.back() = value; break;
      case Role::position: keys.positions[keys.positions.size() - keys.channels + column.channel] = value.hi; break;
      case Role::tension: keys.tcbs.back().tension = value.hi; break;
      case Role::continuity: keys.tcbs.back().continuity = value.hi; break;
      case Role::bias: keys.tcbs.back().bias = value.hi; break;
      case Role::ease_in: keys.eases.back().in = value.hi; break;
      case Role::ease_out: keys.eases.back().out = value.hi; break;
    }
  }

  [[noreturn]] void refuse_shape() {
    fail(fmt::format("{}: expected {}, as in the first key; correct it", path(),
                     current_->array ? "an array of numbers" : "a number"));
  }

  const JsonColumns& columns_;
  const spline::Tcb<double>& tcb_;
  std::vector<bool> seen_;
  bool timed_ = false, eased_ = false;
  std::size_t expected_ = 0;  ///< the member that comes next if all keys look alike
  const Member* current_ = nullptr;
  KeyBlock block_;
};

/// Reads what stands beside the keys in the object around them.
class Envelope : public JsonEvents {
 public:
  using JsonEvents::JsonEvents;
  std::vector<std::string> channels;
  CurveSettings settings;
  std::vector<std::pair<std::string, Place>> places;

 private:
  bool on_member(const std::string& name) override {
    member_ = name;
    return true;
  }
  bool on_number(const spline::Time<double>& value) override {
    if (member_ == "channels") fail("channels: a number; expected names in quotes; correct it");
    return on_other(time_text(value));
  }
  bool on_other(std::string_view text) override {
    const std::string value(text);
    places.emplace_back(member_, here());
    if (member_ == "channels" && in_array()) channels.push_back(value);
    if (member_ == "preset") settings.preset = value;
    if (member_ == "tangents") settings.tangents = value;
    if (member_ == "ends") settings.ends = settings.ends && in_array() ? *settings.ends + "," + value : value;
    if (member_ == "period") settings.period = value;
    if (member_ == "closed") {
      if (text != "true" && text != "false")
        fail(fmt::format("closed: \"{}\"; expected true or false; correct it", text));
      settings.closed = text == "true";
    }
    return true;
  }

  std::string member_;
};

}  // namespace

KeyBlock parse_json(const Chunk& chunk, const JsonColumns& columns, const spline::Tcb<double>& tcb) {
  KeyBuilder builder(chunk, columns, tcb);
  builder.parse();
  return builder.take();
}

Input open_json(Source<std::string> bytes, const InputOptions& options) {
  if (options.delimiter || options.header) {
    throw Error(
        Exit::usage,
        "--delimiter, --header and --no-header have no effect on JSON; take them out, or give the format with -i");
  }
  const auto splitter = std::make_shared<JsonSplitter>(std::move(bytes));
  Source<Chunk> chunks = [splitter] { return splitter->next(); };
  std::vector<std::string> channels;
  CurveSettings settings;
  std::vector<std::pair<std::string, Place>> places;
  auto first = chunks();
  if (splitter->wrapped()) {
    // The settings may stand behind the keys, so all of the text is read before the first key is used.
    std::vector<Chunk> kept;
    for (; first; first = chunks()) kept.push_back(std::move(*first));
    if (splitter->list_closed()) {
      Envelope envelope(splitter->envelope());
      envelope.parse_object();
      channels = envelope.channels;
      settings = envelope.settings;
      places = std::move(envelope.places);
    }
    chunks = [kept = std::move(kept), next = std::size_t{0}]() mutable -> std::optional<Chunk> {
      return next < kept.size() ? std::optional(std::move(kept[next++])) : std::nullopt;
    };
    first = chunks();
  }
  if (!first) throw Error(Exit::data, "no keys: the input is empty; expected an object for each key; see --help");
  const auto columns = std::make_shared<const JsonColumns>(find_members(*first, options, channels));
  const auto parse = [columns, tcb = options.tcb](const Chunk& chunk) { return parse_json(chunk, *columns, tcb); };
  const Columns& meaning = columns->columns;
  return {true,
          meaning.has(Role::time),
          meaning.time,
          meaning.channels,
          settings,
          ordered_map(preceded_by(std::move(*first), std::move(chunks)), parse, options.threads),
          std::move(places)};
}

}  // namespace tcb::format
