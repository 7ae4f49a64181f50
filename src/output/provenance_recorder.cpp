// The recorder of provenance: checksums and counts of the inputs, keys and rows that pass.
#include <deque>

#include "error.hpp"
#include "io/sha256.hpp"
#include "output/provenance.hpp"

namespace tcb {

/// What has passed.
struct ProvenanceRecorder::Tally {
  Provenance provenance;
  Sha256 sha256;
  Source<std::string> bytes;  ///< of the current input
  Source<KeyBlock> keys;      ///< of the current curve
};

namespace {

/// All bytes, read ahead. Throws: Error (data) where they have another SHA-256.
Source<std::string> verified(const Source<std::string>& bytes, const std::string& expected, const std::string& from) {
  std::deque<std::string> parts;
  Sha256 sha256;
  while (std::optional<std::string> more = bytes()) {
    sha256.add(*more);
    parts.push_back(std::move(*more));
  }
  if (std::string digest = sha256.digest(); digest != expected) {
    throw Error(Exit::data, ErrorCode::other_checksum, {std::move(digest), expected, from});
  }
  return [parts = std::move(parts)]() mutable -> std::optional<std::string> {
    if (parts.empty()) return std::nullopt;
    std::string next = std::move(parts.front());
    parts.pop_front();
    return next;
  };
}

Error other_number_of_inputs(ErrorCode code, const ProvenanceRequest& request) {
  return {Exit::usage, code, {request.from, std::uint64_t{request.earlier.inputs.size()}}};
}

}  // namespace

ProvenanceRecorder::ProvenanceRecorder(const std::optional<ProvenanceRequest>& request)
    : request_(request), tally_(request ? std::make_shared<Tally>() : nullptr) {
  if (tally_ != nullptr) tally_->provenance = request->meta;
}

Source<std::string> ProvenanceRecorder::observe_bytes(const std::string& name, Source<std::string> bytes) {
  if (tally_ == nullptr) return bytes;
  auto& inputs = tally_->provenance.inputs;
  const auto& earlier = request_->earlier.inputs;
  if (!earlier.empty()) {
    if (inputs.size() == earlier.size()) throw other_number_of_inputs(ErrorCode::made_from_fewer_inputs, *request_);
    const auto& [first_name, digest] = earlier[inputs.size()];
    bytes = verified(bytes, digest, request_->from);
    inputs.emplace_back(first_name, "");  // the file may have another name now
  } else {
    inputs.emplace_back(name, "");
  }
  tally_->bytes = mapped(std::move(bytes), [tally = tally_.get()](std::string part) {
    tally->sha256.add(part);
    return part;
  });
  return [tally = tally_.get()] { return tally->bytes(); };
}

Source<KeyBlock> ProvenanceRecorder::observe_keys(Source<KeyBlock> keys) {
  if (tally_ == nullptr) return keys;
  ++tally_->provenance.curves;
  tally_->keys = mapped(std::move(keys), [tally = tally_.get()](KeyBlock block) {
    tally->provenance.keys += block.size();
    return block;
  });
  return [tally = tally_.get()] { return tally->keys(); };
}

Source<SampleBlock> ProvenanceRecorder::observe_rows(Source<SampleBlock> rows) {
  if (tally_ == nullptr) return rows;
  return mapped(std::move(rows), [tally = tally_.get()](SampleBlock block) {
    tally->provenance.rows += block.rows();
    return block;
  });
}

void ProvenanceRecorder::set_rules(Facts rules) {
  if (tally_ != nullptr) tally_->provenance.rules = std::move(rules);
}

void ProvenanceRecorder::end_curve() {
  while (tally_ != nullptr && tally_->keys()) {
  }
}

void ProvenanceRecorder::end_input() {
  if (tally_ == nullptr) return;
  while (tally_->bytes()) {
  }
  tally_->provenance.inputs.back().second = tally_->sha256.digest();
}

std::string ProvenanceRecorder::before_rows(FormatId format) const {
  return tally_ == nullptr ? "" : text_before_rows(tally_->provenance, format);
}

std::string ProvenanceRecorder::after_rows(FormatId format) const {
  if (tally_ == nullptr) return "";
  if (tally_->provenance.inputs.size() < request_->earlier.inputs.size()) {
    throw other_number_of_inputs(ErrorCode::made_from_more_inputs, *request_);
  }
  return text_after_rows(tally_->provenance, format);
}

}  // namespace tcb
