# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the hidden test case that prints the bits of some expression metrics in ten processes: all outputs must agree.
cmake_minimum_required(VERSION 3.25)

foreach(run RANGE 1 10)
  execute_process(COMMAND "${BINARY}" "prints the bits of expression metrics" OUTPUT_VARIABLE bits
                  COMMAND_ERROR_IS_FATAL ANY)
  if(run EQUAL 1)
    set(first "${bits}")
  elseif(NOT bits STREQUAL first)
    message(FATAL_ERROR "run ${run} differs from run 1:\n${first}\n${bits}")
  endif()
endforeach()
if(NOT first MATCHES "bits [0-9a-f]+")
  message(FATAL_ERROR "no bits in the output:\n${first}")
endif()
