// Under the leak sanitizer: the validation layer of Debian 12 keeps a few kilobytes for each device it has seen.
#include <dlfcn.h>

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libVkLayer_khronos_validation\n"; }

namespace {

// Leaks are told apart by the library they come from, which has to stay loaded until the end for that.
[[maybe_unused]] void* const kLayer = dlopen("libVkLayer_khronos_validation.so", RTLD_LAZY | RTLD_NODELETE);

}  // namespace
