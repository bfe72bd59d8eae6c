// The vertices of a draw, in clip, world or pixel space, from the scene file itself or from a .npy file, as clip positions.
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/camera/projection.hpp"
#include "scene/camera/screen.hpp"
#include "scene/file/npy.hpp"
#include "scene/file/read_scene.hpp"

namespace rasterdiff {
namespace {

enum class Space { Clip, World, Pixels };

struct Coordinates {
  uint32_t least, most;  ///< numbers a vertex
  const char* what;
};
constexpr std::array<Coordinates, 3> kCoordinates{{{4, 4, "a position of clip space ([x, y, z, w])"},
                                                   {3, 3, "a position in world space"},
                                                   {2, 4, "a position in pixels"}}};

bool readSpace(Reader& reader, const JsonValue& draw, const DrawContext& context, Space& space) {
  const auto value = draw.member("space");
  if (!value) return true;
  static constexpr std::array<std::string_view, 3> kNames{"clip", "world", "pixels"};
  std::string name;
  if (!reader.text(*value, name)) return false;
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return reader.fail(*value, "'" + name + "' is no space", Reader::suggest(name, kNames));
  space = static_cast<Space>(found - kNames.begin());
  if (space == Space::World && !context.clipFromWorld) {
    return reader.fail(*value, "world space without a camera", "add a camera to the scene");
  }
  return true;
}

bool clipPosition(Reader& reader, const JsonValue& value, bool allowNonFinite, ClipPosition& out) {
  if (!reader.array(value, "a position")) return false;
  if (value.size() != 4) {
    return reader.fail(value, fmt::format("a position of {} numbers", value.size()), "[x, y, z, w] in clip space");
  }
  JsonValue number = value.first();
  for (float* to : {&out.x, &out.y, &out.z, &out.w}) {
    if (!reader.float32(number, *to, allowNonFinite)) return false;
    number = number.next();
  }
  return true;
}

/// `n` holds as many numbers as kCoordinates wants of world space or pixels.
ClipPosition transformed(Space space, const DrawContext& context, const Viewport& viewport, const std::vector<double>& n) {
  if (space == Space::World) return toClip(*context.clipFromWorld, n[0], n[1], n[2]);
  return clipFromPixels(viewport, {n[0], n[1], n.size() > 2 ? n[2] : 0, n.size() > 3 ? n[3] : 1});
}

bool readListed(Reader& reader, const JsonValue& value, Space space, const DrawContext& context, Draw& draw) {
  if (!reader.array(value, "positions")) return false;
  draw.positions.resize(value.size());
  JsonValue vertex = value.first();
  std::vector<double> n;
  const Coordinates& wanted = kCoordinates[static_cast<size_t>(space)];
  for (ClipPosition& position : draw.positions) {
    if (space == Space::Clip) {
      if (!clipPosition(reader, vertex, context.scene.allowNonFinite, position)) return false;
    } else {
      if (!reader.numbers(vertex, wanted.what, wanted.least, wanted.most, n)) return false;
      position = transformed(space, context, viewportOf(context, draw), n);
    }
    vertex = vertex.next();
  }
  return true;
}

/// Fails at the path in the scene file; rows and columns count from 0, as in NumPy.
bool readNpy(Reader& reader, const JsonValue& value, Space space, const DrawContext& context, Draw& draw) {
  std::string path = value.text();
  if (!path.starts_with('/')) path = context.folder + path;
  const Result<NpyMatrix> matrix = loadNpy(path);
  if (!matrix) {
    const Error& e = matrix.error();
    return reader.fail(value.offset(), fmt::format("{}: {}", e.where, e.what), e.hint, e.code);
  }
  const Coordinates& wanted = kCoordinates[static_cast<size_t>(space)];
  const size_t columns = matrix->columns();
  if (columns < wanted.least || columns > wanted.most) {
    return reader.fail(value, fmt::format("{}: {} columns for {}", path, columns, wanted.what),
                       wanted.least == wanted.most ? fmt::format("{} columns", wanted.least)
                                                   : fmt::format("{} to {} columns", wanted.least, wanted.most));
  }
  if (matrix->rows() == 0) return reader.fail(value, path + ": no rows", "one row a vertex");
  const bool nonFinite = space == Space::Clip && context.scene.allowNonFinite;
  draw.positions.resize(matrix->rows());
  std::vector<double> n(columns);
  for (size_t row = 0; row < matrix->rows(); ++row) {
    ClipPosition& position = draw.positions[row];
    const std::array<float*, 4> to{&position.x, &position.y, &position.z, &position.w};
    for (size_t column = 0; column < columns; ++column) {
      n[column] = matrix->at(row, column);
      if (space == Space::Clip) *to[column] = matrix->float32(row, column);
      const bool tooLarge = std::isfinite(n[column]) && std::isinf(static_cast<float>(n[column]));
      if (tooLarge || (!nonFinite && !std::isfinite(n[column]))) {
        return reader.fail(value, fmt::format("{}: row {}, column {}: {} is {}", path, row, column, n[column],
                                              tooLarge ? "beyond float32" : "not finite"),
                           tooLarge || space != Space::Clip
                               ? "" : "\"allowNonFinite\": true lets it through in positions and varyings");
      }
    }
    if (space != Space::Clip) position = transformed(space, context, viewportOf(context, draw), n);
  }
  return true;
}

}  // namespace

const Viewport& viewportOf(const DrawContext& context, const Draw& draw) {
  const auto& further = context.scene.furtherViewports;
  return draw.viewportIndex == 0 ? context.scene.viewport : further[draw.viewportIndex - 1].viewport;
}

bool readPositions(Reader& reader, const JsonValue& draw, const DrawContext& context, Draw& out) {
  Space space = Space::Clip;
  if (!readSpace(reader, draw, context, space)) return false;
  const JsonValue positions = *draw.member("positions");
  return positions.kind() == JsonKind::String ? readNpy(reader, positions, space, context, out)
                                              : readListed(reader, positions, space, context, out);
}

}  // namespace rasterdiff
