// Large pages for planes: a frame of a large target is written once, and faulting in small pages costs more than that.
#pragma once

#include <cstddef>

namespace rasterdiff::vkref {

/// Asks the kernel to back `bytes` at `memory` by large pages where it can; does nothing for small or special memory.
void adviseHugePages(void* memory, size_t bytes);

}  // namespace rasterdiff::vkref
