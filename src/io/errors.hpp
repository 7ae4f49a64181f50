// Errors of files: reading, decompressing, writing, and lists of inputs with their outputs.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "error.hpp"

namespace tcb {

// Reading. `reason` is the operating system's.
Error cannot_open(std::string_view reason);
Error cannot_read(std::string_view reason);
Error input_is_folder();
Error input_changed();

// Decompressing. `compression` is its name, such as "gzip".
Error compressed_data_damaged(std::string_view compression);
Error compressed_data_cut(std::string_view compression);
Error zstandard_window_too_large();
/// In a build without libzstd.
Error no_zstandard();

// Writing.
Error cannot_write(std::string_view reason);
Error cannot_create_folder(std::string_view reason);
Error cannot_create_temporary(std::string_view reason);
Error cannot_read_temporary(std::string_view reason);

// Lists of inputs, and their outputs.
Error nul_in_list();
Error empty_name_in_list();
Error long_name_in_list(std::size_t most);
Error empty_list();
Error cannot_read_folder(std::string_view reason);
Error no_inputs_in_folders(std::uint64_t other_files, std::span<const std::string_view> endings);
Error same_output(std::string_view output, std::string_view other_input);
Error output_is_input(std::string_view output);
Error standard_input_without_name();

}  // namespace tcb
