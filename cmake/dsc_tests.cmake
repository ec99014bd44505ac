# SPDX-License-Identifier: GPL-3.0-or-later
# How a test binary is declared: one per module, every Catch2 test case of it a test of its own in ctest.
include_guard()

# dsc_test_binary(NAME SOURCES ... LINKS ... [LABELS ...] [TIMEOUT seconds]):
# an executable with Catch2's main. A test case tagged [slow] or [shared] (one that reads the shared data folder) gets
# that label, every other one the LABELS (default: fast). `ctest -L fast` runs what the sanitizer build runs.
function(dsc_test_binary name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LINKS;LABELS" ${ARGN})
  if(NOT ARG_LABELS)
    set(ARG_LABELS fast)
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 600)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE dsc_test_main dsc_warnings ${ARG_LINKS})
  target_precompile_headers(${name} REUSE_FROM dsc_test_headers)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests/bin")

  set(list_file "${CMAKE_CURRENT_BINARY_DIR}/${name}_list.cmake")
  set(include_file "${CMAKE_CURRENT_BINARY_DIR}/${name}_include.cmake")
  add_custom_command(
    TARGET ${name} POST_BUILD
    BYPRODUCTS "${list_file}"
    COMMAND "${CMAKE_COMMAND}" -D "BINARY=$<TARGET_FILE:${name}>" -D "PREFIX=${name}" -D "LABELS=${ARG_LABELS}"
            -D "TIMEOUT=${ARG_TIMEOUT}" -D "LIST_FILE=${list_file}"
            -P "${PROJECT_SOURCE_DIR}/cmake/dsc_list_tests.cmake"
    VERBATIM)
  file(WRITE "${include_file}"
       "if(EXISTS \"${list_file}\")\n  include(\"${list_file}\")\nelse()\n  add_test(${name}_not_built ${name}_not_built)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${include_file}")
endfunction()
