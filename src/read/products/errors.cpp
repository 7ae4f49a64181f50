// Errors of files of products: their tracks, and what cannot be read from them.
#include "read/products/errors.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {

Error empty_file() { return {Exit::data, "the file is empty; expected an object with keys; copy the file again"}; }

Error no_tracks() { return {Exit::data, "the file has no tracks; expected an object with keys"}; }

Error only_constant_tracks(const std::vector<std::string>& tracks) {
  return {Exit::data,
          fmt::format("no track has more than one key; expected one that changes; choose one of {} with {} to "
                      "read it all the same",
                      listed(tracks), option::only)};
}

Error no_such_track(std::string_view pattern, const std::vector<std::string>& tracks) {
  return Error(Exit::usage, fmt::format("no object or track is {}; expected one of {}; correct it, where * is any text "
                                        "and ? any character",
                                        in_quotes(pattern), listed(tracks)))
      .about(option::only);
}

Error tracks_differ(std::string_view first, std::string_view other) {
  return Error(Exit::usage,
               fmt::format("{} has other channels than {}; expected tracks with the same channels; choose one "
                           "kind, such as */position",
                           in_quotes(other), in_quotes(first)))
      .about(option::only);
}

Error channel_without_key(std::string_view channel) {
  return {Exit::data,
          fmt::format("channel {} has no key at this time, where other channels have one; expected a key in "
                      "every channel; give {} skip-cell",
                      in_quotes(channel), option::missing)};
}

Error times_of_track_repeat(std::string_view time) {
  return {Exit::data, fmt::format("the key at {} seconds is not after the one before it; expected increasing times; "
                                  "correct the file",
                                  time)};
}

Error track_number_too_large(std::string_view number) {
  return {
      Exit::data,
      fmt::format("{} is beyond the range of doubles; expected less than 1.8e308 in size; correct the file", number)};
}

Error number_of_track_not_finite() {
  return {Exit::data, "a number of a key is infinite or no number; expected finite numbers; export the file again"};
}

Error step_too_short() {
  return {Exit::data,
          "the step to the key is shorter than doubles can distinguish; expected keys that are farther apart; "
          "remove one of them"};
}

Error file_ends_early() {
  return {Exit::data, "the file ends within an object; expected the rest; copy the file again"};
}

Error number_of_file_expected(std::string_view found) {
  return {Exit::data,
          fmt::format("{} is no number of a key or a rate; expected a number; correct the file", in_quotes(found))};
}

Error count_of_file_expected(std::string_view found) {
  return {Exit::data, fmt::format("{} is no count; expected a whole number; correct the file", in_quotes(found))};
}

Error chunk_too_short() {
  return {Exit::data,
          "a chunk of the file is longer or shorter than its content; expected a whole .3ds file; copy or export "
          "it again"};
}

Error not_an_ase() {
  return {Exit::data,
          fmt::format("the text is no ASCII export of 3ds Max; expected *3DSMAX_ASCIIEXPORT in its first line; "
                      "give another {}",
                      option::input_format)};
}

Error bezier_controller() {
  return {Exit::data,
          "the controller has Bezier keys, whose tangents have no documented unit; expected TCB or linear keys, or "
          "samples; change the controller in 3ds Max, or export samples"};
}

Error not_a_scene() {
  return {Exit::data,
          fmt::format("the text is no scene of LightWave; expected LWSC or LWMO in its first line; give another "
                      "{}",
                      option::input_format)};
}

Error scene_word_expected(std::string_view word, std::string_view found) {
  return {Exit::data, fmt::format("{} is here; expected {}, as in a motion of LightWave; correct the file",
                                  in_quotes(found), in_quotes(word))};
}

Error scene_key_count(std::size_t found, std::size_t expected) {
  return {Exit::data, fmt::format("there are {} keys or values; expected {}, the count above them; correct the file",
                                  found, expected)};
}

Error no_such_span(std::size_t number) {
  return {Exit::data,
          fmt::format("the span of the key is of type {}; expected 0 to 4 (TCB, Hermite, Bezier 1D, linear, "
                      "stepped), in version 2 no Hermite; correct the file",
                      number)};
}

Error bezier_2d_span() {
  return {Exit::data,
          "the span of the key is a Bezier 2D curve, which is no cubic in time; expected TCB, Hermite, Bezier "
          "1D, linear or stepped; change the key's curve in LightWave"};
}

Error no_such_behavior(std::size_t number) {
  return {
      Exit::data,
      fmt::format("the behavior of the envelope is of type {}; expected 0 to 5 (reset, constant, repeat, oscillate, "
                  "offset repeat, linear); correct the file",
                  number)};
}

Error not_an_fbx() {
  return {
      Exit::data,
      fmt::format("the text is no FBX file; expected the node FBXHeaderExtension with an FBXVersion; give another {}",
                  option::input_format)};
}

Error no_such_fbx_version(std::int64_t version) {
  return {Exit::data,
          fmt::format("the FBX file is of version {}; expected 6000 to 7999; export it as FBX 7.4", version)};
}

Error unexpected_text_in_fbx(std::string_view text) {
  return {
      Exit::data,
      fmt::format("{} is here; expected the name of a node and a colon, or the end of a node; export the file again",
                  in_quotes(text))};
}

Error too_many_levels_in_fbx(std::size_t most) {
  return {Exit::data, fmt::format("nodes are within more than {} others; expected fewer; export the file again", most)};
}

Error missing_in_fbx(std::string_view node) {
  return {Exit::data, fmt::format("the node has no child {}; expected one; export the file again", in_quotes(node))};
}

Error fbx_arrays_differ() {
  return {Exit::data,
          "the numbers of keys, values, flags and tangents of the animation curve differ; expected as many as there "
          "are keys; export the file again"};
}

Error fbx_curves_repeat() {
  return {Exit::data,
          "the animation curves have so many connections that their keys are more than the bytes of the file; expected "
          "one connection of each curve; export the file again"};
}

Error no_fbx_interpolation(std::uint32_t flags) {
  return {Exit::data,
          fmt::format("the interpolation of the key has the flags 0x{:x}; expected constant (0x2), linear (0x4) or "
                      "cubic (0x8); change it in the program that made the file",
                      flags)};
}

Error fbx_tangents_with_weights() {
  return {Exit::data,
          "the tangents of the key have weights, so the curve is no cubic in time; expected tangents without weights; "
          "remove them in the program that made the file, or bake the animation and export it again"};
}

Error fbx_slope_after_tcb() {
  return {Exit::data,
          "the key follows a TCB key, so the file has no slope for its left side; expected a TCB or an automatic "
          "tangent; change one of the two keys"};
}

Error fbx_bias_too_large(int most) {
  return {Exit::data,
          fmt::format("the bias of the automatic tangent is beyond {} percent; expected no more; change the tangent to "
                      "a user tangent",
                      most)};
}

Error no_old_fbx_tangent(std::string_view letter) {
  return {Exit::data,
          fmt::format("the key has the type {}, which is not documented; expected TCB, user, linear and constant keys; "
                      "export the file as FBX 7",
                      in_quotes(letter))};
}

}  // namespace tcb
