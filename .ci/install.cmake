# What cmake --install installs besides the library: the program, its manual, its completions and the licence; and the
# targets that pack these: wheel, zip, and the packages of cpack.

# The program prints the pages of its manual that have its tables, its completions, and the tables themselves; a program
# for another machine needs an emulator for that. The other pages are files.
set(pages man/tcbsample-input.5 man/tcbsample-output.5 man/tcbsample-numerics.7)
if(NOT CMAKE_CROSSCOMPILING OR CMAKE_CROSSCOMPILING_EMULATOR)
  foreach(document tcbsample.1=man tcbsample-curves.7=man-curves completion.bash=bash completion.zsh=zsh
          completion.fish=fish tables.json=tables)
    string(REGEX MATCH "(.*)=(.*)" document ${document})
    set(document ${CMAKE_CURRENT_BINARY_DIR}/${CMAKE_MATCH_1})
    add_custom_command(OUTPUT ${document} COMMAND tcbsample --generate ${CMAKE_MATCH_2} > ${document} DEPENDS tcbsample
                       VERBATIM)
    list(APPEND documents ${document})
  endforeach()
  add_custom_target(documents ALL DEPENDS ${documents})
  list(GET documents 0 1 made_pages)
  list(APPEND pages ${made_pages})
  list(GET documents 2 3 4 completions)
  list(GET documents 5 tables)
endif()

install(TARGETS tcbsample COMPONENT program)
if(NOT TCBSAMPLE_PACKAGES)
  foreach(page ${pages})
    string(REGEX MATCH ".$" section ${page})
    install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man${section} COMPONENT program)
  endforeach()
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
endif()
if(completions)
  set(zsh_folder zsh/site-functions)
  if(TCBSAMPLE_PACKAGES)
    set(zsh_folder zsh/vendor-completions) # where Debian's zsh looks
  endif()
  set(data ${CMAKE_INSTALL_DATADIR})
  list(GET completions 0 bash)
  list(GET completions 1 zsh)
  list(GET completions 2 fish)
  install(FILES ${bash} DESTINATION ${data}/bash-completion/completions RENAME tcbsample COMPONENT program)
  install(FILES ${zsh} DESTINATION ${data}/${zsh_folder} RENAME _tcbsample COMPONENT program)
  install(FILES ${fish} DESTINATION ${data}/fish/vendor_completions.d RENAME tcbsample.fish COMPONENT program)
endif()

# The wheel for Python, of src/python: cmake --build BUILD --target wheel. It has the program without symbols.
find_program(TCBSAMPLE_PYTHON python3 HINTS /usr/bin) # Debian's, which has python3-wheel
set(make_wheel ${TCBSAMPLE_PYTHON} ${PROJECT_SOURCE_DIR}/src/python/make_wheel.py --program $<TARGET_FILE:tcbsample>
               --tables ${tables})
add_custom_target(wheel COMMAND ${make_wheel} --folder ${CMAKE_CURRENT_BINARY_DIR}/wheel
                                --license ${PROJECT_SOURCE_DIR}/LICENSE --strip=${CMAKE_STRIP}
                  DEPENDS tcbsample ${tables} VERBATIM)

# The zip for Windows, with the manual as text and as HTML: cmake --workflow --preset windows.
if(WIN32 AND TARGET documents)
  set(zip_name tcbsample-${PROJECT_VERSION}-windows-x86_64)
  set(zip_folder ${CMAKE_CURRENT_BINARY_DIR}/zip/${zip_name})
  foreach(page ${pages})
    cmake_path(ABSOLUTE_PATH page BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    cmake_path(GET page FILENAME name)
    list(APPEND manuals COMMAND sh -c "mandoc -Tutf8 ${page} | sed 's/.\\x08//g' > ${zip_folder}/${name}.txt"
                        COMMAND mandoc -Thtml ${page} > ${zip_folder}/${name}.html)
  endforeach()
  add_custom_target(zip VERBATIM DEPENDS tcbsample documents
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${CMAKE_CURRENT_BINARY_DIR}/zip
    COMMAND ${CMAKE_COMMAND} -E make_directory ${zip_folder}
    COMMAND ${CMAKE_STRIP} -o ${zip_folder}/tcbsample.exe $<TARGET_FILE:tcbsample>
    COMMAND ${CMAKE_COMMAND} -E copy ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${zip_folder}
    ${manuals}
    COMMAND ${CMAKE_COMMAND} -E chdir zip ${CMAKE_COMMAND} -E tar cf ${zip_name}.zip --format=zip ${zip_name})
  enable_testing()
  add_test(NAME windows COMMAND sh ${PROJECT_SOURCE_DIR}/tests/windows.sh $<TARGET_FILE:tcbsample>)
  set_tests_properties(windows PROPERTIES LABELS windows SKIP_RETURN_CODE 77)
endif()

if(TCBSAMPLE_PACKAGES)
  include(.ci/packages.cmake)
endif()
