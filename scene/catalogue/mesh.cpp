// A mesh that nobody here wrote: the Stanford bunny, whole, and so close that triangles cross the near plane.
#include <glm/mat4x4.hpp>

#include "scene/camera/look_at.hpp"
#include "scene/camera/projection.hpp"
#include "scene/catalogue/build.hpp"
#include "scene/mesh/obj.hpp"

namespace rasterdiff::families {
namespace {

struct View {
  glm::dvec3 eye, target;  ///< model units; the bunny fills -1..1
  double fovY, near, far;
};

constexpr View kWhole{{0.4, 0.45, 3.6}, {0.0, -0.02, 0.0}, 42, 0.1, 10};
/// Beside the chest, looking along the flank: the near plane cuts the body, a tenth of it is behind the eye.
constexpr View kNear{{0.24, 0.08, 0.45}, {-0.71, -0.17, -0.55}, 102, 0.372, 10};

/// Read once a process.
const Result<Mesh>& bunnyMesh() {
  static const Result<Mesh> mesh = findBunny().and_then([](const std::string& path) { return loadObj(path); });
  return mesh;
}

enum class Inputs : uint8_t { None, Normals };

Result<Scene> bunny(const View& view, uint32_t samples, Inputs inputs) {
  constexpr uint32_t kWidth = 1920, kHeight = 1080;
  const Result<Mesh>& mesh = bunnyMesh();
  if (!mesh) return tl::unexpected(mesh.error());
  const Result<glm::dmat4> camera = lookAt(view.eye, view.target, glm::dvec3(0, 1, 0));
  if (!camera) return tl::unexpected(camera.error());
  const Result<glm::dmat4> projection =
      perspective(view.fovY, double{kWidth} / kHeight, view.near, view.far, Convention::Vulkan);
  if (!projection) return tl::unexpected(projection.error());
  Scene scene = target(kWidth, kHeight, samples);
  useDepth(scene);
  const Varying normal{.name = "normal", .components = 3};
  scene.draws.push_back(meshDraw(*mesh, *projection * *camera, {&normal, inputs == Inputs::Normals ? size_t{1} : size_t{0}}));
  return scene;
}

}  // namespace

void addMesh(Entries& entries) {
  Family family(entries, "mesh");
  for (uint32_t samples : {1u, 4u}) {
    const std::string n = samples == 1 ? "-1x" : "-4x";
    family.addFallible("bunny" + n, "the Stanford bunny, 69,666 triangles at 1920 x 1080",
                       {"R1", "R12", "R14", "R15", "R21", "R22", "R38", "R50"},
                       [samples] { return bunny(kWhole, samples, Inputs::Normals); });
    family.addFallible(
        "bunny-near" + n, "the bunny from so near that its triangles cross the near plane and go behind the eye",
        {"R1", "R3", "R9", "R14", "R15", "R21", "R22", "R38", "R50"}, [samples] { return bunny(kNear, samples, Inputs::Normals); });
  }
  family.addFallible("bunny-depth-1x", "the bunny with nothing but coverage and depth, which is then all that is drawn, read back and compared",
                     {"R1", "R12", "R14", "R15", "R22", "R38"}, [] { return bunny(kWhole, 1, Inputs::None); });
  family.addFallible("bunny-near-depth-1x", "the same from so near that triangles are cut",
                     {"R1", "R3", "R14", "R15", "R22", "R38"}, [] { return bunny(kNear, 1, Inputs::None); });
}

}  // namespace rasterdiff::families
