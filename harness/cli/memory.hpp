// How a process that checks many scenes keeps its memory.
#pragma once

namespace rasterdiff::harness::cli {

/// Lets the allocator keep what a scene's planes took for the next scene's: giving pages back and faulting them in again costs
/// more than small scenes cost to draw. Does nothing where the C library offers no such choice.
void keepFreedMemory();

}  // namespace rasterdiff::harness::cli
