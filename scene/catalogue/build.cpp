#include "scene/catalogue/build.hpp"

#include <fmt/format.h>

#include "scene/camera/screen.hpp"

namespace rasterdiff::families {

void Family::addFallible(const std::string& name, std::string what, std::vector<std::string> rules,
                         std::function<Result<Scene>()> make, std::string link) {
  std::string full = prefix_ + "/" + name;
  auto named = [full, make = std::move(make)]() -> Result<Scene> {
    Result<Scene> scene = make();
    if (!scene) return scene;
    scene->name = full;
    if (auto ok = validate(*scene); !ok) return tl::unexpected(ok.error());
    return scene;
  };
  entries_.push_back({std::move(full), std::move(what), std::move(rules), std::move(link), std::move(named), {}});
}

void Family::add(const std::string& name, std::string what, std::vector<std::string> rules, std::function<Scene()> make,
                 std::string link) {
  addFallible(
      name, std::move(what), std::move(rules), [make = std::move(make)]() -> Result<Scene> { return make(); },
      std::move(link));
}

void Family::addRandom(const std::string& name, std::string what, std::vector<std::string> rules, uint64_t seed,
                       uint32_t primitives, std::function<Scene(uint64_t, uint32_t)> make) {
  add(name, std::move(what), std::move(rules), [seed, primitives, make] { return make(seed, primitives); });
  entries_.back().remake = [full = entries_.back().name, make = std::move(make)](uint64_t s, uint32_t n) -> Result<Scene> {
    Scene scene = make(s, n);
    scene.name = full;
    return scene;
  };
}

Scene target(uint32_t width, uint32_t height, uint32_t samples) {
  Scene scene;
  scene.target.width = width;
  scene.target.height = height;
  scene.target.samples = samples;
  scene.viewport.width = static_cast<float>(width);
  scene.viewport.height = static_cast<float>(height);
  return scene;
}

Draw& draw(Scene& scene, const std::vector<Px>& vertices) {
  Draw& draw = scene.draws.emplace_back();
  draw.positions.reserve(vertices.size());
  for (const Px& p : vertices) draw.positions.push_back(clipFromPixels(scene.viewport, {p.x, p.y, p.z, p.w}));
  return draw;
}

Draw& drawClip(Scene& scene, std::vector<ClipPosition> vertices) {
  Draw& draw = scene.draws.emplace_back();
  draw.positions = std::move(vertices);
  return draw;
}

std::vector<Px> rectangle(double x0, double y0, double x1, double y1, double z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

void useDepth(Scene& scene, CompareOp op, bool write, float clear) {
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.target.depthClearValue = clear;
  scene.state.depthTestEnable = true;
  scene.state.depthWriteEnable = write;
  scene.state.depthCompareOp = op;
}

void useLines(Scene& scene, LineRasterizationMode mode, float width, PrimitiveTopology topology) {
  scene.state.topology = topology;
  scene.state.lineRasterizationMode = mode;
  scene.state.lineWidth = width;
}

void usePoints(Scene& scene, float size) {
  scene.state.topology = PrimitiveTopology::POINT_LIST;
  scene.state.pointSize = size;
}

std::string issue(const std::string& repository, int number) {
  return fmt::format("https://github.com/{}/issues/{}", repository, number);
}

void addVarying(Scene& scene, const std::string& name, Interpolation interpolation, uint32_t components) {
  uint32_t step = 0;
  for (Draw& draw : scene.draws) {
    Varying& varying =
        draw.varyings.emplace_back(Varying{.name = name, .interpolation = interpolation, .components = components});
    for (size_t i = 0; i < draw.positions.size() * components; ++i) {
      step = (step * 29 + 17) % 1009;  // a prime modulus: neighbours differ, no value repeats for long
      varying.values.push_back(static_cast<float>(step) / 1009.0f - 0.25f);
    }
  }
}

}  // namespace rasterdiff::families
