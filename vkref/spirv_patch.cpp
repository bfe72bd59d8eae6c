// Reads just enough SPIR-V to find input variables and their locations, and inserts one instruction for each.
#include "vkref/spirv_patch.hpp"

#include <algorithm>

namespace rasterdiff::vkref {
namespace {

constexpr size_t kHeaderWords = 5;
// Opcodes, decorations and storage class as the SPIR-V specification numbers them.
constexpr uint32_t kOpVariable = 59, kOpDecorate = 71;
constexpr uint32_t kNoPerspective = 13, kFlat = 14, kLocation = 30;
constexpr uint32_t kInput = 1;

uint32_t opcode(uint32_t word) { return word & 0xffff; }
uint32_t length(uint32_t word) { return word >> 16; }

/// Calls visit(instruction) for each instruction; a module of ours is well-formed, a zero length would end the walk.
template <class Visit>
void forEachInstruction(std::span<const uint32_t> module, const Visit& visit) {
  for (size_t at = kHeaderWords; at < module.size();) {
    const size_t words = length(module[at]);
    if (words == 0 || at + words > module.size()) return;
    visit(module.subspan(at, words));
    at += words;
  }
}

}  // namespace

std::vector<uint32_t> withInterpolations(std::span<const uint32_t> module,
                                         std::span<const Interpolation> interpolations) {
  std::vector<uint32_t> inputs;
  forEachInstruction(module, [&](std::span<const uint32_t> instruction) {
    // OpVariable: type, id, storage class
    if (opcode(instruction[0]) == kOpVariable && instruction[3] == kInput) inputs.push_back(instruction[2]);
  });

  std::vector<uint32_t> patched(module.begin(), module.begin() + kHeaderWords);
  forEachInstruction(module, [&](std::span<const uint32_t> instruction) {
    patched.insert(patched.end(), instruction.begin(), instruction.end());
    // OpDecorate: target, decoration, literal
    if (opcode(instruction[0]) != kOpDecorate || instruction[2] != kLocation) return;
    const uint32_t variable = instruction[1], location = instruction[3];
    const bool input = std::find(inputs.begin(), inputs.end(), variable) != inputs.end();
    if (!input || location >= interpolations.size() || interpolations[location] == Interpolation::smooth) return;
    const uint32_t decoration = interpolations[location] == Interpolation::flat ? kFlat : kNoPerspective;
    patched.insert(patched.end(), {(3U << 16) | kOpDecorate, variable, decoration});
  });
  return patched;
}

}  // namespace rasterdiff::vkref
