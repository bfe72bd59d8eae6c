// Reads just enough SPIR-V to find variables, their locations and their loads, and rewrites those instructions.
#include "vkref/spirv_patch.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace rasterdiff::vkref {
namespace {

constexpr size_t kHeaderWords = 5, kBoundWord = 3;
// Opcodes, decorations, capabilities and storage classes as the SPIR-V specification numbers them.
constexpr uint32_t kOpExtInstImport = 11, kOpExtInst = 12, kOpCapability = 17, kOpTypeFloat = 22, kOpTypeVector = 23,
                   kOpConstant = 43, kOpConstantComposite = 44, kOpFunction = 54, kOpVariable = 59, kOpLoad = 61,
                   kOpDecorate = 71;
constexpr uint32_t kNoPerspective = 13, kFlat = 14, kCentroid = 16, kSample = 17, kLocation = 30;
constexpr uint32_t kSampleRateShading = 35, kInterpolationFunction = 52;
constexpr uint32_t kInput = 1, kOutput = 3;
constexpr uint32_t kInterpolateAtOffset = 78;  ///< of GLSL.std.450, the one set that our modules import

uint32_t opcode(uint32_t word) { return word & 0xffff; }
uint32_t length(uint32_t word) { return word >> 16; }
uint32_t head(uint32_t op, uint32_t words) { return (words << 16) | op; }

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

/// What the patches have to know of a module before they write.
struct Contents {
  std::vector<uint32_t> inputs, outputs;  ///< variables
  std::vector<std::array<uint32_t, 2>> located;  ///< variable and location
  uint32_t instructionSet = 0, float32 = 0, float32x2 = 0;  ///< 0: not declared

  explicit Contents(std::span<const uint32_t> module) {
    forEachInstruction(module, [this](std::span<const uint32_t> i) {
      const uint32_t op = opcode(i[0]);
      if (op == kOpVariable && i[3] == kInput) inputs.push_back(i[2]);
      if (op == kOpVariable && i[3] == kOutput) outputs.push_back(i[2]);
      if (op == kOpDecorate && i[2] == kLocation) located.push_back({i[1], i[3]});
      if (op == kOpExtInstImport) instructionSet = i[1];
      if (op == kOpTypeFloat && i[2] == 32) float32 = i[1];
      if (op == kOpTypeVector && i[2] == float32 && i[3] == 2) float32x2 = i[1];
    });
  }

  [[nodiscard]] bool isInput(uint32_t id) const { return std::find(inputs.begin(), inputs.end(), id) != inputs.end(); }
  [[nodiscard]] bool isOutput(uint32_t id) const {
    return std::find(outputs.begin(), outputs.end(), id) != outputs.end();
  }
};

/// The decoration of an interpolation; 0 for those that have none.
uint32_t decorationOf(Interpolation interpolation) {
  switch (interpolation) {
    case Interpolation::noperspective:
      return kNoPerspective;
    case Interpolation::flat:
      return kFlat;
    case Interpolation::centroid:
      return kCentroid;
    case Interpolation::sample:
      return kSample;
    case Interpolation::smooth:
    case Interpolation::offset:
      break;
  }
  return 0;
}

/// An input that is to be read at an offset, and the constant that holds the offset.
struct OffsetInput {
  uint32_t variable = 0, constant = 0;
  float x = 0, y = 0;
};

/// Declares the offsets of `inputs`, and the types that they need; new ids come from `bound`.
std::vector<uint32_t> offsetConstants(const Contents& contents, std::span<OffsetInput> inputs, uint32_t& bound) {
  std::vector<uint32_t> code;
  uint32_t vector = contents.float32x2;
  if (vector == 0 && !inputs.empty()) {
    vector = bound++;
    code.insert(code.end(), {head(kOpTypeVector, 4), vector, contents.float32, 2});
  }
  for (OffsetInput& input : inputs) {
    const uint32_t x = bound++, y = bound++;
    input.constant = bound++;
    code.insert(code.end(), {head(kOpConstant, 4), contents.float32, x, std::bit_cast<uint32_t>(input.x)});
    code.insert(code.end(), {head(kOpConstant, 4), contents.float32, y, std::bit_cast<uint32_t>(input.y)});
    code.insert(code.end(), {head(kOpConstantComposite, 5), vector, input.constant, x, y});
  }
  return code;
}

}  // namespace

std::vector<uint32_t> withInterpolations(std::span<const uint32_t> module,
                                         std::span<const InputInterpolation> interpolations) {
  const Contents contents(module);
  std::vector<OffsetInput> offsets;
  bool samples = false;
  for (const auto& [variable, location] : contents.located) {
    if (!contents.isInput(variable) || location >= interpolations.size()) continue;
    const InputInterpolation& asked = interpolations[location];
    samples |= asked.mode == Interpolation::sample;
    if (asked.mode == Interpolation::offset) offsets.push_back({variable, 0, asked.offsetX, asked.offsetY});
  }

  uint32_t bound = module[kBoundWord];
  std::vector<uint32_t> constants = offsetConstants(contents, offsets, bound);
  std::vector<uint32_t> patched(module.begin(), module.begin() + kHeaderWords);
  patched[kBoundWord] = bound;
  if (samples) patched.insert(patched.end(), {head(kOpCapability, 2), kSampleRateShading});
  if (!offsets.empty()) patched.insert(patched.end(), {head(kOpCapability, 2), kInterpolationFunction});
  forEachInstruction(module, [&](std::span<const uint32_t> i) {
    const uint32_t op = opcode(i[0]);
    if (op == kOpFunction) {
      patched.insert(patched.end(), constants.begin(), constants.end());
      constants.clear();
    }
    // OpLoad: type, id, pointer
    const auto input = std::find_if(offsets.begin(), offsets.end(), [&](const OffsetInput& offset) {
      return op == kOpLoad && i[3] == offset.variable;
    });
    if (input != offsets.end()) {
      patched.insert(patched.end(), {head(kOpExtInst, 7), i[1], i[2], contents.instructionSet, kInterpolateAtOffset,
                                     input->variable, input->constant});
      return;
    }
    patched.insert(patched.end(), i.begin(), i.end());
    // OpDecorate: target, decoration, literal
    if (op != kOpDecorate || i[2] != kLocation || !contents.isInput(i[1]) || i[3] >= interpolations.size()) return;
    const uint32_t decoration = decorationOf(interpolations[i[3]].mode);
    if (decoration != 0) patched.insert(patched.end(), {head(kOpDecorate, 3), i[1], decoration});
  });
  return patched;
}

std::vector<uint32_t> withOutputFirst(std::span<const uint32_t> module, uint32_t location) {
  const Contents contents(module);
  std::vector<uint32_t> patched(module.begin(), module.begin() + kHeaderWords);
  forEachInstruction(module, [&](std::span<const uint32_t> i) {
    patched.insert(patched.end(), i.begin(), i.end());
    if (opcode(i[0]) != kOpDecorate || i[2] != kLocation || !contents.isOutput(i[1]) || i[3] > location) return;
    patched.back() = i[3] == location ? 0 : i[3] + 1;
  });
  return patched;
}

}  // namespace rasterdiff::vkref
