// The words that the families of the catalogue are written in: targets, draws in pixels, varyings, depth.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/catalogue/catalogue.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::families {

using Entries = std::vector<CatalogueEntry>;

/// A vertex in pixels; z is depth before the viewport's depth range, 0 near .. 1 far.
struct Px {
  double x = 0, y = 0, z = 0.5, w = 1;
};

/// A family: every entry's name is prefix/name.
class Family {
 public:
  Family(Entries& entries, std::string prefix) : entries_(entries), prefix_(std::move(prefix)) {}

  /// `link` is the report the scene comes from, or empty.
  void add(const std::string& name, std::string what, std::vector<std::string> rules, std::function<Scene()> make,
           std::string link = {});
  void addFallible(const std::string& name, std::string what, std::vector<std::string> rules,
                   std::function<Result<Scene>()> make, std::string link = {});
  /// A random family: `make(seed, primitives)` gives another scene of its kind for every seed.
  void addRandom(const std::string& name, std::string what, std::vector<std::string> rules, uint64_t seed,
                 uint32_t primitives, std::function<Scene(uint64_t seed, uint32_t primitives)> make);

 private:
  Entries& entries_;
  std::string prefix_;
};

/// A target of one colour-less pixel rectangle with a viewport over all of it.
[[nodiscard]] Scene target(uint32_t width, uint32_t height, uint32_t samples = 1);
[[nodiscard]] inline Scene square(uint32_t extent, uint32_t samples = 1) { return target(extent, extent, samples); }

/// Appends a draw of vertices in pixels (under the scene's viewport as it is now) or in clip space.
Draw& draw(Scene& scene, const std::vector<Px>& vertices);
Draw& drawClip(Scene& scene, std::vector<ClipPosition> vertices);

/// The rectangle x0..x1 × y0..y1 as a list of two triangles.
[[nodiscard]] std::vector<Px> rectangle(double x0, double y0, double x1, double y1, double z = 0.5);

/// Adds a D32_SFLOAT attachment and the depth state.
void useDepth(Scene& scene, CompareOp op = CompareOp::LESS, bool write = true, float clear = 1);

/// The state for lines, and for points.
void useLines(Scene& scene, LineRasterizationMode mode, float width = 1,
              PrimitiveTopology topology = PrimitiveTopology::LINE_LIST);
void usePoints(Scene& scene, float size = 1);

/// The address of an issue (or pull request) on GitHub.
[[nodiscard]] std::string issue(const std::string& repository, int number);

/// Gives every vertex of every draw of the scene a different value in each component.
void addVarying(Scene& scene, const std::string& name, Interpolation interpolation, uint32_t components = 4);

// One function a family, each in its own file.
void addFill(Entries& entries);
void addSharedEdge(Entries& entries);
void addStrip(Entries& entries);
void addFan(Entries& entries);
void addIndexed(Entries& entries);
void addFacing(Entries& entries);
void addClip(Entries& entries);
void addNearPlane(Entries& entries);
void addViewport(Entries& entries);
void addScissor(Entries& entries);
void addDepth(Entries& entries);
void addVaryings(Entries& entries);
void addSamples(Entries& entries);
void addOverlap(Entries& entries);
void addOrder(Entries& entries);
void addSliver(Entries& entries);
void addTiny(Entries& entries);
void addFar(Entries& entries);
void addRandom(Entries& entries);
void addSampleLocations(Entries& entries);
void addLineSmooth(Entries& entries);
void addPolygon(Entries& entries);
void addMesh(Entries& entries);
void addPoint(Entries& entries);
void addPointClip(Entries& entries);
void addLineRect(Entries& entries);
void addLineBresenham(Entries& entries);
void addLineWide(Entries& entries);
void addLineStipple(Entries& entries);
void addLineStrip(Entries& entries);
void addPolygonMode(Entries& entries);
void addRestart(Entries& entries);
void addDepthClip(Entries& entries);
void addDepthFormat(Entries& entries);
void addDepthBias(Entries& entries);
void addDepthPrecision(Entries& entries);
void addClipDistance(Entries& entries);
void addCullDistance(Entries& entries);
void addViewports(Entries& entries);
void addSampleMask(Entries& entries);
void addShaderMask(Entries& entries);
void addSampleShading(Entries& entries);
void addCentroid(Entries& entries);
void addOffset(Entries& entries);
void addAlphaToCoverage(Entries& entries);
void addBuiltIns(Entries& entries);
void addResolve(Entries& entries);
void addSupersample(Entries& entries);
void addRandomLines(Entries& entries);
void addRandomPoints(Entries& entries);
void addCrowd(Entries& entries);
void addFound(Entries& entries);
void addRandomStrips(Entries& entries);
void addRandomOutlines(Entries& entries);
void addRandomCuts(Entries& entries);
void addRandomDepth(Entries& entries);

}  // namespace rasterdiff::families
