// The same work for several threads, the first of them the caller's.
#pragma once

#include <thread>
#include <vector>

namespace rasterdiff::rasterizer {

/// Calls work(k) for each k < threads at the same time, and returns when all have.
template <class Work>
void inParallel(unsigned threads, const Work& work) {
  std::vector<std::thread> others;
  for (unsigned k = 1; k < threads; ++k) others.emplace_back([&work, k] { work(k); });
  work(0U);
  for (std::thread& other : others) other.join();
}

}  // namespace rasterdiff::rasterizer
