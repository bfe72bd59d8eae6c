// A draw of a scene file that is made of polygons: an SVG file's, or one whose points stand in the scene file.
#include <array>

#include "scene/file/read_scene.hpp"
#include "scene/polygon/polygon_draw.hpp"
#include "scene/polygon/svg_points.hpp"

namespace rasterdiff {
namespace {

bool readFillRule(Reader& reader, const JsonValue& draw, FillRule& rule) {
  const auto value = draw.member("fillRule");
  if (!value) return true;
  std::string name;
  if (!reader.text(*value, name)) return false;
  if (name != "nonzero" && name != "evenodd") {
    static constexpr std::array<std::string_view, 2> kNames{"nonzero", "evenodd"};
    return reader.fail(*value, "'" + name + "' is no fillRule", Reader::suggest(name, kNames));
  }
  rule = name == "evenodd" ? FillRule::EvenOdd : FillRule::NonZero;
  return true;
}

bool readPoints(Reader& reader, const JsonValue& draw, std::vector<SvgPolygon>& out) {
  const JsonValue value = *draw.member("points");
  std::string points;
  SvgPolygon& polygon = out.emplace_back();
  if (!reader.text(value, points) || !readFillRule(reader, draw, polygon.fillRule)) return false;
  auto parsed = parsePolygonPoints(points);
  if (!parsed) {
    const PointsMistake& mistake = parsed.error();
    return reader.fail(reader.offsetInText(value, mistake.at), mistake.what, mistake.hint);
  }
  polygon.polygon = std::move(*parsed);
  return true;
}

bool readSvg(Reader& reader, const JsonValue& draw, const DrawContext& context, std::vector<SvgPolygon>& out) {
  const JsonValue file = *draw.member("svg");
  std::string path;
  if (!reader.text(file, path)) return false;
  if (!path.starts_with('/')) path = context.folder + path;
  Result<std::vector<SvgPolygon>> polygons = loadSvgPolygons(path);
  if (!polygons) {
    const Error& e = polygons.error();
    return reader.fail(file.offset(), fmt::format("{}: {}", e.where, e.what), e.hint, e.code);
  }
  out = std::move(*polygons);
  return true;
}

}  // namespace

bool readPolygon(Reader& reader, const JsonValue& value, const DrawContext& context, Draw& draw) {
  static constexpr std::array<std::string_view, 5> kSvgFields{"svg", "z", "viewportIndex", "varyings", "shaderSampleMaskBits"};
  static constexpr std::array<std::string_view, 6> kPointsFields{"points", "fillRule", "z", "viewportIndex", "varyings", "shaderSampleMaskBits"};
  static constexpr OfferedVaryings kOffered{"a polygon", kPolygonVaryings};
  const bool ofFile = value.member("svg").has_value();
  if (ofFile ? !reader.object(value, "SVG draw", kSvgFields) : !reader.object(value, "polygon draw", kPointsFields)) {
    return false;
  }
  if (context.scene.state.topology != PrimitiveTopology::TRIANGLE_LIST) {
    return reader.fail(value, "a polygon where the topology is not TRIANGLE_LIST", "polygons are drawn as triangles");
  }
  double z = 0;
  if (const auto v = value.member("z"); v && !reader.number(*v, z)) return false;
  std::vector<Varying> varyings;
  std::vector<SvgPolygon> polygons;
  if (!readViewportIndex(reader, value, context, draw) || !readVaryings(reader, value, &kOffered, false, varyings) ||
      !(ofFile ? readSvg(reader, value, context, polygons) : readPoints(reader, value, polygons))) {
    return false;
  }
  Result<Draw> drawn = polygonDraw(polygons, viewportOf(context, draw), z, varyings);
  if (!drawn) return reader.fail(*value.member(ofFile ? "svg" : "points"), drawn.error().what, drawn.error().hint);
  drawn->viewportIndex = draw.viewportIndex;
  draw = std::move(*drawn);
  return true;
}

}  // namespace rasterdiff
