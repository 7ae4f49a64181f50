// Errors of files of products: their tracks, and what cannot be read from them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"

namespace tcb {

// Tracks.
Error empty_file();
Error no_tracks();
Error only_constant_tracks(const std::vector<std::string>& tracks);
Error no_such_track(std::string_view pattern, const std::vector<std::string>& tracks);
Error tracks_differ(std::string_view first, std::string_view other);
Error channel_without_key(std::string_view channel);
Error times_of_track_repeat(std::string_view time);
Error track_number_too_large(std::string_view number);
Error number_of_track_not_finite();
Error step_too_short();

// Texts.
Error file_ends_early();
Error number_of_file_expected(std::string_view found);
Error count_of_file_expected(std::string_view found);

// Files of 3D Studio.
Error chunk_too_short();

// ASCII exports of 3ds Max.
Error not_an_ase();
Error bezier_controller();

// Scenes of LightWave.
Error not_a_scene();
Error scene_word_expected(std::string_view word, std::string_view found);
Error scene_key_count(std::size_t found, std::size_t expected);
Error no_such_span(std::size_t number);
Error bezier_2d_span();
Error no_such_behavior(std::size_t number);

// FBX.
Error not_an_fbx();
Error no_such_fbx_version(std::int64_t version);
Error unexpected_text_in_fbx(std::string_view text);
Error too_many_levels_in_fbx(std::size_t most);
Error missing_in_fbx(std::string_view node);
Error fbx_arrays_differ();
Error fbx_curves_repeat();
Error no_fbx_interpolation(std::uint32_t flags);
Error fbx_tangents_with_weights();
Error fbx_slope_after_tcb();
Error fbx_bias_too_large(int most);
Error no_old_fbx_tangent(std::string_view letter);

}  // namespace tcb
