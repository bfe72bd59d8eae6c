// Parts that work without drawing: SPIR-V patching, plans for other limits, and proof that validation is listening.
#include <gtest/gtest.h>

#include "vkref/commands.hpp"
#include "vkref/device_impl.hpp"
#include "vkref/geometry.hpp"
#include "vkref/shader_code.hpp"
#include "vkref/spirv_patch.hpp"

namespace rasterdiff::vkref {
namespace {

/// How many OpDecorate instructions (3 words) carry `decoration`.
int decorations(const std::vector<uint32_t>& module, uint32_t decoration) {
  int found = 0;
  for (size_t at = 5; at < module.size(); at += module[at] >> 16) {
    found += module[at] == ((3U << 16) | 71U) && module[at + 2] == decoration;
  }
  return found;
}

TEST(SpirvPatch, DecoratesExactlyTheInputsThatAsk) {
  const std::span<const uint32_t> code = fragmentCode(PrimitiveSource::Builtin, 3, ShaderSampleMask::NONE);
  const std::vector<uint32_t> untouched(code.begin(), code.end());
  const auto patched = withInterpolations(
      code, std::vector<InputInterpolation>{{Interpolation::flat}, {}, {Interpolation::noperspective}});
  EXPECT_EQ(patched.size(), code.size() + 2 * 3);
  EXPECT_EQ(decorations(patched, 14), decorations(untouched, 14) + 1);  // Flat
  EXPECT_EQ(decorations(patched, 13), decorations(untouched, 13) + 1);  // NoPerspective
  const auto smooth = withInterpolations(code, std::vector<InputInterpolation>(3));
  EXPECT_EQ(smooth, untouched);
}

TEST(RenderPlan, FewAttachmentsMeanMorePassesAndNoPlaneTwice) {
  Scene scene;
  scene.target.width = scene.target.height = 8;
  scene.draws.emplace_back();
  for (int v = 0; v < 8; ++v) scene.draws.front().varyings.push_back({"v", Interpolation::smooth, 1, {}});
  Capabilities caps;
  for (const auto& [attachments, passes] : {std::pair{4U, 3U}, {8U, 2U}, {16U, 2U}}) {
    caps.vk.maxColorAttachments = caps.vk.maxFragmentOutputAttachments = attachments;
    const RenderPlan plan = planOf(scene, caps);
    EXPECT_EQ(plan.passes.size(), passes);
    uint32_t next = 0, varyings = 0;
    for (const PassPlan& pass : plan.passes) {
      EXPECT_EQ(pass.primitives, next == 0);
      EXPECT_LE(pass.attachments.size(), attachments);
      for (uint32_t attachment : pass.attachments) EXPECT_EQ(attachment, next++);
      for (uint32_t varying : pass.varyings) EXPECT_EQ(varying, varyings++);
    }
    EXPECT_EQ(next, 10U);
    EXPECT_EQ(varyings, 8U);
  }
}

class Validation : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Drivers, Validation, ::testing::Values("lavapipe", "swiftshader"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(Validation, ReportsAMissingBarrier) {
  Result<std::unique_ptr<Device>> device = openDevice({GetParam(), /*validate=*/true});
  ASSERT_TRUE(device.has_value()) << device.error().what;
  Device::Impl& impl = (*device)->impl();
  const Context& context = *impl.context;
  const auto buffer = acquireBuffer(*impl.buffers, 1024, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  ASSERT_TRUE(buffer.has_value());
  const auto commands = impl.submission->begin();
  ASSERT_TRUE(commands.has_value());
  context.vk.vkCmdFillBuffer(*commands, (*buffer)->buffer.get(), 0, 1024, 1);
  ASSERT_TRUE((*device)->validationMessages().empty());
  context.vk.vkCmdFillBuffer(*commands, (*buffer)->buffer.get(), 0, 1024, 2);  // no barrier: write after write
  ASSERT_TRUE(impl.submission->run().has_value());
  ASSERT_EQ((*device)->validationMessages().size(), 1U);
  EXPECT_NE((*device)->validationMessages().front().find("SYNC-HAZARD-WRITE-AFTER-WRITE"), std::string::npos);
}

}  // namespace
}  // namespace rasterdiff::vkref
