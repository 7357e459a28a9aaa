// Carries the headers that are compiled once for all tests: cmake/Catch2Any.cmake.
