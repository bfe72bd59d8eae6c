# Compiler settings that every room shares, as one interface target.
option(RASTERDIFF_TESTS "Build the tests" ON)
option(RASTERDIFF_SANITIZE "Address and undefined-behaviour sanitizers" OFF)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

add_library(rasterdiff_options INTERFACE)
target_include_directories(rasterdiff_options INTERFACE ${PROJECT_SOURCE_DIR})
# Values are compared bit by bit: no contraction, no fast-math.
target_compile_options(rasterdiff_options INTERFACE
  -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor)
if(RASTERDIFF_SANITIZE)
  target_compile_options(rasterdiff_options INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer)
  target_link_options(rasterdiff_options INTERFACE -fsanitize=address,undefined)
endif()

# rasterdiff_room(NAME LIBS...): a static library of all sources below the calling folder.
function(rasterdiff_room name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  add_library(rasterdiff_${name} STATIC ${sources})
  target_link_libraries(rasterdiff_${name} PUBLIC rasterdiff_options ${ARGN})
endfunction()
