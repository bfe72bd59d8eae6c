// Compiles volk, which finds the Vulkan loader at run time instead of linking it.
#define VOLK_IMPLEMENTATION
#include <volk.h>
