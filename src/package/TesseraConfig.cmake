# find_package(Tessera): the target Tessera::matching. It needs no other package.
include(${CMAKE_CURRENT_LIST_DIR}/TesseraTargets.cmake)
