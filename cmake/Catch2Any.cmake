# The only place that knows which Catch2 is there: v3 (target Catch2::Catch2WithMain) or v2 (header only, own main).
find_package(Catch2 REQUIRED)
find_package(rapidcheck REQUIRED)
add_library(visibility_catch STATIC "${PROJECT_SOURCE_DIR}/tests/support/catch_main.cpp")
target_include_directories(visibility_catch PUBLIC "${PROJECT_SOURCE_DIR}/tests")
if(Catch2_VERSION VERSION_GREATER_EQUAL 3)
  target_link_libraries(visibility_catch PUBLIC Catch2::Catch2WithMain)
  target_compile_definitions(visibility_catch PUBLIC VISIBILITY_CATCH2_V3)
else()
  target_link_libraries(visibility_catch PUBLIC Catch2::Catch2)
endif()
target_link_libraries(visibility_catch PUBLIC rapidcheck)

# Catch2, RapidCheck and the number types, compiled once for all tests.
add_library(visibility_test_headers STATIC "${PROJECT_SOURCE_DIR}/tests/support/precompiled.cpp")
target_link_libraries(visibility_test_headers PRIVATE visibility_catch visibility_core visibility_developer)
target_precompile_headers(visibility_test_headers PRIVATE "${PROJECT_SOURCE_DIR}/include/visibility/kernel/arithmetic.hpp"
  "${PROJECT_SOURCE_DIR}/tests/support/catch.hpp")
include(Catch)
