# SPDX-License-Identifier: BSD-3-Clause
# Testing/Benchmark/run sets CMAKE_PROJECT_FeatureHex_INCLUDE to this file: adds today's micro-benchmarks to
# the sources of any revision, after their own targets.
cmake_language(EVAL CODE "cmake_language(DEFER DIRECTORY [[${CMAKE_SOURCE_DIR}]]
  CALL include [[${CMAKE_CURRENT_LIST_DIR}/MicroBenchmarks.cmake]])")
