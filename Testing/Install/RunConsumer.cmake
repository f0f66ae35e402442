# SPDX-License-Identifier: BSD-3-Clause
# Installs the build tree BINARY_DIR into WORK_DIR, moves the result elsewhere (an install tree must
# not remember its place), and configures, builds and runs the consumer project against it.

function (run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nfailed: ${result}")
  endif ()
endfunction ()

file(REMOVE_RECURSE "${WORK_DIR}")
run("${CMAKE_COMMAND}" --install "${BINARY_DIR}" --prefix "${WORK_DIR}/first")
file(RENAME "${WORK_DIR}/first" "${WORK_DIR}/prefix")
run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}/Testing/Install/Consumer" -B "${WORK_DIR}/consumer"
  -G "${GENERATOR}" -DCMAKE_BUILD_TYPE=${BUILD_TYPE} "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  "-DFeatureHex_DIR=${WORK_DIR}/prefix/lib/cmake/FeatureHex"
  "-DPython3_EXECUTABLE=${PYTHON}" -Wno-dev --log-level=WARNING)
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/consumer")
run("${WORK_DIR}/consumer/consumer" "${SOURCE_DIR}/Data/blob.obj" "${WORK_DIR}/blob.vtu")
