# The GL utility library, for its polygon tessellator (Debian: libglu1-mesa-dev). No GL context is ever made.
find_path(GLU_INCLUDE_DIR GL/glu.h REQUIRED)
find_library(GLU_LIBRARY GLU REQUIRED)
target_include_directories(rasterdiff_scene SYSTEM PRIVATE ${GLU_INCLUDE_DIR})
target_link_libraries(rasterdiff_scene PRIVATE ${GLU_LIBRARY})
