#include "rasterizer/methods/svg_polygon.hpp"

#include <fmt/format.h>

#include <cmath>

#include "rasterizer/methods/polygon_triangulation.hpp"
#include "rasterizer/methods/svg_markup.hpp"
#include "scene/camera/screen.hpp"

namespace rasterdiff::rasterizer {
namespace {

Result<SvgPolygon> polygonOf(std::string_view svg, const SvgTag& tag) {
  const SvgAttribute* points = tag.find("points");
  if (points == nullptr) {
    return fail(ErrorCode::BadInput, svgPlace(svg, tag.at), "a polygon without points", "add points=\"x,y x,y x,y\"");
  }
  SvgPolygon result;
  if (const SvgAttribute* rule = tag.find("fill-rule"); rule != nullptr) {
    if (rule->value != "evenodd" && rule->value != "nonzero") {
      return fail(ErrorCode::BadInput, svgPlace(svg, rule->at), "an unknown fill-rule", "write evenodd or nonzero");
    }
    result.fillRule = rule->value == "evenodd" ? FillRule::EvenOdd : FillRule::NonZero;
  }
  const auto placed = [&](Error error) {
    error.where = fmt::format("{} ({})", svgPlace(svg, points->at), error.where);
    return tl::unexpected<Error>(std::move(error));
  };
  const Result<std::vector<SvgPoint>> list = parseSvgPoints(points->value);
  if (!list) return placed(list.error());
  Result<Polygon> polygon = polygonFromPoints(*list);
  if (!polygon) return placed(polygon.error());
  result.polygon = std::move(*polygon);
  return result;
}

}  // namespace

Result<Polygon> polygonFromPoints(std::span<const SvgPoint> points) {
  Polygon polygon;
  polygon.vertices.reserve(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    const double x = std::nearbyint(points[i].x * kSubpixelOne), y = std::nearbyint(points[i].y * kSubpixelOne);
    if (!(std::fabs(x) <= kMaxPolygonCoordinate && std::fabs(y) <= kMaxPolygonCoordinate)) {
      return fail(ErrorCode::BadInput, fmt::format("point {}", i), "a coordinate is out of range",
                  fmt::format("keep within ±{} pixels", kMaxPolygonCoordinate / kSubpixelOne));
    }
    polygon.vertices.push_back({static_cast<int32_t>(x), static_cast<int32_t>(y)});
  }
  if (auto ok = checkPolygon(polygon, 1, 1); !ok) return tl::unexpected(ok.error());
  return polygon;
}

Result<std::vector<SvgPolygon>> parseSvgPolygons(std::string_view svg) {
  const Result<std::vector<SvgTag>> tags = svgTags(svg);
  if (!tags) return tl::unexpected(tags.error());
  std::vector<SvgPolygon> polygons;
  for (const SvgTag& tag : *tags) {
    for (const std::string_view moving : {"transform", "viewBox"}) {
      if (const SvgAttribute* found = tag.find(moving); found != nullptr) {
        return fail(ErrorCode::BadInput, svgPlace(svg, found->at), fmt::format("'{}' is not understood", moving),
                    "write the polygon in pixels");
      }
    }
    if (tag.name != "polygon") continue;
    Result<SvgPolygon> polygon = polygonOf(svg, tag);
    if (!polygon) return tl::unexpected(polygon.error());
    polygons.push_back(std::move(*polygon));
  }
  return polygons;
}

Result<Scene> polygonScene(std::span<const SvgPolygon> polygons, uint32_t width, uint32_t height, uint32_t samples) {
  Scene scene;
  scene.name = "polygon";
  scene.target.width = width;
  scene.target.height = height;
  scene.target.samples = samples;
  scene.viewport.width = static_cast<float>(width);
  scene.viewport.height = static_cast<float>(height);
  for (size_t i = 0; i < polygons.size(); ++i) {
    const Result<Triangulation> parts = triangulate(polygons[i].polygon, polygons[i].fillRule);
    if (!parts) return tl::unexpected(parts.error());
    if (parts->triangles.empty()) {
      return fail(ErrorCode::BadInput, fmt::format("polygon {}", i), "it covers no area", "give three points apart");
    }
    Draw& draw = scene.draws.emplace_back();
    draw.positions.reserve(parts->triangles.size() * 3);
    for (const SnappedTriangle& triangle : parts->triangles) {
      for (const SubpixelPosition& v : triangle.v) {
        constexpr double kUnit = 1.0 / kSubpixelOne;
        draw.positions.push_back(clipFromPixels(scene.viewport, {v.x * kUnit, v.y * kUnit, 0.5, 1}));
      }
    }
  }
  if (auto ok = validate(scene); !ok) return tl::unexpected(ok.error());
  return scene;
}

}  // namespace rasterdiff::rasterizer
