# The packages of Debian that a program for Windows is compiled with: their headers, in a folder without those of
# Debian's C library.
set(headers ${CMAKE_CURRENT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(folder boost CLI fast_float fmt nlohmann)
  if(NOT EXISTS /usr/include/${folder})
    message(FATAL_ERROR "there is no /usr/include/${folder}; .ci/setup windows installs what is needed")
  endif()
  file(CREATE_LINK /usr/include/${folder} ${headers}/${folder} SYMBOLIC)
endforeach()
foreach(target Boost::headers CLI11::CLI11 FastFloat::fast_float fmt::fmt nlohmann_json::nlohmann_json)
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} SYSTEM INTERFACE ${headers})
endforeach()
