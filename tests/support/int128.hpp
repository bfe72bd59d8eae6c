// 128-bit integers of the compiler, for tests that check 64-bit arithmetic.
#pragma once

namespace rasterdiff::testing {

__extension__ typedef __int128 Int128;

}  // namespace rasterdiff::testing
