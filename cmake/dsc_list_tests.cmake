# SPDX-License-Identifier: GPL-3.0-or-later
# Run after a test binary is built: asks it for its test cases and writes a file of add_test commands for ctest.
# Catch2 2.13 lists names without their tags, so each label is one query by tag; `-w NoTests` makes a name that finds
# no test case a failure.
cmake_minimum_required(VERSION 3.25)

set(script "")
function(add_cases spec labels cost)
  execute_process(COMMAND "${BINARY}" "${spec}" --list-test-names-only OUTPUT_VARIABLE names
                  ERROR_VARIABLE problem RESULT_VARIABLE count)
  if(NOT count MATCHES "^[0-9]+$")
    message(FATAL_ERROR "${BINARY} could not list its tests: ${count}\n${problem}")
  endif()
  # Line by line, not as a CMake list: names have semicolons and half-open intervals.
  while(names MATCHES "^([^\n]*)\n(.*)$")
    set(name "${CMAKE_MATCH_1}")
    set(names "${CMAKE_MATCH_2}")
    if(name STREQUAL "")
      continue()
    endif()
    # These four mean something in a Catch2 test specification, and these at its beginning.
    string(REGEX REPLACE "([][,\\])" "\\\\\\1" filter "${name}")
    string(REGEX REPLACE "^[-~\"]" "\\\\\\0" filter "${filter}")
    string(APPEND script
      "add_test([==[${PREFIX}: ${name}]==] [==[${BINARY}]==] [==[${filter}]==] -w NoTests)\n"
      "set_tests_properties([==[${PREFIX}: ${name}]==] PROPERTIES LABELS [==[${labels}]==] TIMEOUT ${TIMEOUT} "
      "COST ${cost} "
      "SKIP_REGULAR_EXPRESSION [==[SKIPPED: ]==])\n")
  endwhile()
  set(script "${script}" PARENT_SCOPE)
endfunction()

# ctest begins with what costs most, so that no processor waits in the end for a long test on another.
add_cases("~[slow]~[shared]~[.]" "${LABELS}" 0)
add_cases("[shared]~[slow]~[.]" "shared" 1)
add_cases("[slow]~[.]" "slow" 2)
file(WRITE "${LIST_FILE}" "${script}")
