// What the kernels need of Highway's library, for one instruction set: so that the program does not load the library, which reads a
// clock when it is loaded, by an instruction that valgrind does not know on every processor (RDTSCP).
#include <hwy/targets.h>

namespace hwy {

// AVX2: the best instruction set that valgrind knows.
int64_t SupportedTargets() { return HWY_AVX2; }

ChosenTarget& GetChosenTarget() {
  static ChosenTarget chosen;
  return chosen;
}

}  // namespace hwy
