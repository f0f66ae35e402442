# SPDX-License-Identifier: BSD-3-Clause
# The micro-benchmarks, where Google Benchmark is installed. Included by CMakeLists.txt, and at the end of
# any revision's configuration by AddBenchmarks.cmake.
find_package(benchmark QUIET)
if (benchmark_FOUND)
  add_executable(MicroBenchmarks "${CMAKE_CURRENT_LIST_DIR}/MicroBenchmarks.cxx")
  target_link_libraries(MicroBenchmarks PRIVATE
    FeatureHexCompileOptions FeatureHex::FeatureHexCore benchmark::benchmark)
  target_include_directories(MicroBenchmarks PRIVATE "${PROJECT_SOURCE_DIR}/Filters/Core")
else ()
  message(STATUS "No micro-benchmarks: Google Benchmark is missing (Wrapping/setup benchmark)")
endif ()
