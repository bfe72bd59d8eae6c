#include "scene/polygon/triangulation.hpp"

#include <GL/glu.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <deque>
#include <memory>

namespace rasterdiff {
namespace {

/// What the library's callbacks build; vertices are handed to it by address.
struct Collector {
  std::deque<SubpixelPosition> vertices;
  std::vector<const SubpixelPosition*> corners;
  uint32_t rounded = 0;
  GLenum error = 0;
};

void onVertex(void* vertex, void* collector) {
  static_cast<Collector*>(collector)->corners.push_back(static_cast<const SubpixelPosition*>(vertex));
}

/// Asked for, it makes the library emit separate triangles instead of fans and strips.
void onEdgeFlag(GLboolean, void*) {}

void onCombine(GLdouble position[3], void* /*neighbours*/[4], GLfloat /*weights*/[4], void** made, void* collector) {
  auto* self = static_cast<Collector*>(collector);
  const double x = std::nearbyint(position[0]), y = std::nearbyint(position[1]);
  if (x != position[0] || y != position[1]) ++self->rounded;
  self->vertices.push_back({static_cast<int32_t>(x), static_cast<int32_t>(y)});
  *made = &self->vertices.back();
}

void onError(GLenum error, void* collector) { static_cast<Collector*>(collector)->error = error; }

using AnyCallback = void (*)();
template <class Function>
AnyCallback asCallback(Function* function) {
  return reinterpret_cast<AnyCallback>(function);
}

/// // Q20.8 × Q20.8, differences ≤ 2^29, products ≤ 2^58
bool hasArea(SubpixelPosition a, SubpixelPosition b, SubpixelPosition c) {
  return (int64_t{b.x} - a.x) * (int64_t{c.y} - a.y) != (int64_t{b.y} - a.y) * (int64_t{c.x} - a.x);
}

struct TessellatorDeleter {
  void operator()(GLUtesselator* tessellator) const { gluDeleteTess(tessellator); }
};

}  // namespace

Result<Triangulation> triangulate(const Polygon& polygon, FillRule rule) {
  if (auto ok = checkPolygon(polygon); !ok) return tl::unexpected(ok.error());
  const std::unique_ptr<GLUtesselator, TessellatorDeleter> tessellator(gluNewTess());
  if (!tessellator) return fail(ErrorCode::BadInput, "polygon", "the tessellator could not be made");
  gluTessCallback(tessellator.get(), GLU_TESS_VERTEX_DATA, asCallback(onVertex));
  gluTessCallback(tessellator.get(), GLU_TESS_EDGE_FLAG_DATA, asCallback(onEdgeFlag));
  gluTessCallback(tessellator.get(), GLU_TESS_COMBINE_DATA, asCallback(onCombine));
  gluTessCallback(tessellator.get(), GLU_TESS_ERROR_DATA, asCallback(onError));
  gluTessProperty(tessellator.get(), GLU_TESS_WINDING_RULE,
                  rule == FillRule::EvenOdd ? GLU_TESS_WINDING_ODD : GLU_TESS_WINDING_NONZERO);
  gluTessNormal(tessellator.get(), 0, 0, 1);  // the plane is known: coordinates stay the integers that they are

  Collector collector;
  gluTessBeginPolygon(tessellator.get(), &collector);
  gluTessBeginContour(tessellator.get());
  for (const SubpixelPosition vertex : polygon.vertices) {
    collector.vertices.push_back(vertex);
    std::array<GLdouble, 3> position = {static_cast<double>(vertex.x), static_cast<double>(vertex.y), 0};
    gluTessVertex(tessellator.get(), position.data(), &collector.vertices.back());
  }
  gluTessEndContour(tessellator.get());
  gluTessEndPolygon(tessellator.get());
  if (collector.error != 0) {
    return fail(ErrorCode::BadInput, "polygon", fmt::format("the tessellator gave up (error {})", collector.error),
                "draw it with the scanline method");
  }

  Triangulation result;
  result.roundedVertices = collector.rounded;
  for (size_t i = 0; i + 2 < collector.corners.size(); i += 3) {
    const SubpixelPosition a = *collector.corners[i], b = *collector.corners[i + 1], c = *collector.corners[i + 2];
    if (hasArea(a, b, c)) result.triangles.push_back({a, b, c});
  }
  return result;
}

}  // namespace rasterdiff
