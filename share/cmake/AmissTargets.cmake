# Options of the project and the functions that declare its libraries and tests.

option(AMISS_BUILD_TESTS "Build the tests" ON)
option(AMISS_BUILD_FUZZERS "Build the libFuzzer targets (needs clang)" OFF)
option(AMISS_WERROR "Treat warnings as errors" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "" FORCE)
endif()
# -O2 everywhere; a floating point expression must not depend on what the compiler fuses.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g1 -DNDEBUG")
add_compile_options(-ffp-contract=off)
add_compile_options($<$<CONFIG:Debug>:-D_GLIBCXX_ASSERTIONS>)
add_compile_options($<$<CONFIG:Debug>:-DEIGEN_INITIALIZE_MATRICES_BY_NAN>)
if(AMISS_BUILD_FUZZERS)
  add_compile_options(-fsanitize=fuzzer-no-link,address)
  add_link_options(-fsanitize=address)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

set(AMISS_WARNINGS
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wfloat-conversion -Wdouble-promotion
    -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast -Wcast-qual -Wnull-dereference -Wimplicit-fallthrough
    -Wformat=2 -Wswitch-enum)
if(AMISS_WERROR)
  list(APPEND AMISS_WARNINGS -Werror)
endif()

# amiss_library(NAME DEPENDS core robot LINKS Foo::foo SYSTEM_INCLUDES dir)
# All .cpp files of the folder and of its internal/ become the static library amiss_NAME.
# DEPENDS: libraries of ours (public). LINKS: third party (private, its headers stay in .cpp files).
function(amiss_library name)
  cmake_parse_arguments(arg "" "" "DEPENDS;LINKS;SYSTEM_INCLUDES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/internal/*.cpp)
  add_library(amiss_${name} STATIC ${sources})
  target_include_directories(amiss_${name} PUBLIC ${CMAKE_SOURCE_DIR}/libs)
  target_include_directories(amiss_${name} SYSTEM PRIVATE ${arg_SYSTEM_INCLUDES})
  target_compile_options(amiss_${name} PRIVATE ${AMISS_WARNINGS})
  list(TRANSFORM arg_DEPENDS PREPEND amiss_)
  target_link_libraries(amiss_${name} PUBLIC ${arg_DEPENDS} PRIVATE ${arg_LINKS})
endfunction()

# amiss_test(NAME DEPENDS mapping world): every *_test.cpp of tests/NAME becomes one GoogleTest program. Under ctest
# RapidCheck draws from a fixed seed; a program called by itself draws anew (tests/README.md).
function(amiss_test name)
  cmake_parse_arguments(arg "" "TIMEOUT" "DEPENDS;LINKS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/${name}/*.cpp)
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  add_executable(${name}_test ${sources})
  target_include_directories(${name}_test PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  target_compile_options(${name}_test PRIVATE ${AMISS_WARNINGS})
  target_compile_definitions(${name}_test PRIVATE AMISS_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  list(TRANSFORM arg_DEPENDS PREPEND amiss_)
  target_link_libraries(${name}_test PRIVATE ${arg_DEPENDS} ${arg_LINKS} GTest::gtest_main rapidcheck)
  add_test(NAME ${name} COMMAND ${name}_test WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
  set_tests_properties(${name} PROPERTIES TIMEOUT ${arg_TIMEOUT} ENVIRONMENT "RC_PARAMS=seed=1")
endfunction()
