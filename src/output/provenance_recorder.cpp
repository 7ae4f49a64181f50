// The recorder: what an output's provenance says of the inputs that go by, and where it stands in the output.
#include "output/provenance_recorder.hpp"

#include <fmt/format.h>

#include <deque>

#include "error.hpp"

namespace tcb {

/// What went by.
struct ProvenanceRecorder::Tally {
  Provenance meta;
  Sha256 sha256;
  Source<std::string> bytes;  ///< of the input at hand
  Source<KeyBlock> keys;      ///< of the curve at hand
};

namespace {

/// Throws: Error (data) where the bytes have another SHA-256.
Source<std::string> required(const Source<std::string>& bytes, const std::string& expected, const std::string& from) {
  std::deque<std::string> kept;
  Sha256 sha256;
  while (std::optional<std::string> more = bytes()) {
    sha256.add(*more);
    kept.push_back(std::move(*more));
  }
  if (const std::string digest = sha256.digest(); digest != expected) {
    throw Error(Exit::data, fmt::format("its SHA-256 is {}; expected {}, that of the keys that {} was made from; give "
                                        "that file",
                                        digest, expected, from));
  }
  return [kept = std::move(kept)]() mutable -> std::optional<std::string> {
    if (kept.empty()) return std::nullopt;
    std::string next = std::move(kept.front());
    kept.pop_front();
    return next;
  };
}

}  // namespace

ProvenanceRecorder::ProvenanceRecorder(const std::optional<ProvenanceRequest>& request)
    : request_(request), tally_(request ? std::make_shared<Tally>() : nullptr) {
  if (tally_ != nullptr) tally_->meta = request->meta;
}

Source<std::string> ProvenanceRecorder::bytes(const std::string& name, Source<std::string> bytes) {
  if (tally_ == nullptr) return bytes;
  auto& inputs = tally_->meta.inputs;
  const auto& earlier = request_->earlier.inputs;
  if (!earlier.empty()) {
    if (inputs.size() == earlier.size()) {
      throw Error(Exit::usage, fmt::format("{} was made from fewer files of keys, {}; give as many", request_->from,
                                           earlier.size()));
    }
    const auto& [first_name, digest] = earlier[inputs.size()];
    bytes = required(bytes, digest, request_->from);
    inputs.emplace_back(first_name, "");  // whatever it is called now
  } else {
    inputs.emplace_back(name, "");
  }
  tally_->bytes = mapped(std::move(bytes), [tally = tally_.get()](std::string part) {
    tally->sha256.add(part);
    return part;
  });
  return [tally = tally_.get()] { return tally->bytes(); };
}

Source<KeyBlock> ProvenanceRecorder::keys(Source<KeyBlock> keys) {
  if (tally_ == nullptr) return keys;
  ++tally_->meta.curves;
  tally_->keys = mapped(std::move(keys), [tally = tally_.get()](KeyBlock block) {
    tally->meta.keys += block.lines.size();
    return block;
  });
  return [tally = tally_.get()] { return tally->keys(); };
}

Source<SampleBlock> ProvenanceRecorder::rows(Source<SampleBlock> rows) {
  if (tally_ == nullptr) return rows;
  return mapped(std::move(rows), [tally = tally_.get()](SampleBlock batch) {
    tally->meta.rows += batch.rows();
    return batch;
  });
}

void ProvenanceRecorder::end_curve() {
  while (tally_ != nullptr && tally_->keys()) {
  }
}

void ProvenanceRecorder::end_input() {
  if (tally_ == nullptr) return;
  while (tally_->bytes()) {
  }
  tally_->meta.inputs.back().second = tally_->sha256.digest();
}

std::string ProvenanceRecorder::head(const Format& format, Facts rules, const std::string& frame, bool nested) {
  if (tally_ == nullptr) return frame;
  format_ = &format;
  nested_ = nested;
  tally_->meta.rules = std::move(rules);
  if (format.has_header) return meta_head(tally_->meta) + frame;
  return format.nests && !nested ? "{\"rows\":" + frame : frame;
}

std::string ProvenanceRecorder::tail(const std::string& frame) const {
  if (tally_ == nullptr || format_ == nullptr) return frame;
  if (tally_->meta.inputs.size() < request_->earlier.inputs.size()) {
    throw Error(Exit::usage, fmt::format("{} was made from more files of keys, {}; give as many", request_->from,
                                         request_->earlier.inputs.size()));
  }
  if (format_->has_header) return frame + meta_tail(tally_->meta);
  const std::string object = "\"meta\":" + meta_object(tally_->meta);
  if (!format_->nests) return frame + "{" + object + "}\n";
  return frame.substr(0, frame.find_last_of(nested_ ? '}' : ']') + (nested_ ? 0 : 1)) + ",\n" + object + "}\n";
}

}  // namespace tcb
