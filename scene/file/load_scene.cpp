// The scene file as a whole: reads its parts in the order of their dependencies, then has the scene validated.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "scene/file/read_file.hpp"
#include "scene/file/read_scene.hpp"
#include "scene/file/scene_file.hpp"

namespace rasterdiff {
namespace {

/// The value that `path` ("draws[1].indices[7]") leads to, or the deepest one on the way that the file has.
JsonValue locate(JsonValue at, std::string_view path) {
  while (!path.empty()) {
    std::optional<JsonValue> next;
    size_t used = 0;
    if (path[0] == '[') {
      used = path.find(']') + 1;
      uint32_t index = 0;
      std::from_chars(path.data() + 1, path.data() + used, index);
      next = at.element(index);
    } else {
      if (path[0] == '.') path.remove_prefix(1);
      used = std::min(path.find_first_of(".["), path.size());
      next = at.member(path.substr(0, used));
    }
    if (!next) break;
    at = *next;
    path.remove_prefix(used);
  }
  return at;
}

std::string folderOf(const std::string& fileName) { return fileName.substr(0, fileName.rfind('/') + 1); }

std::string stemOf(const std::string& fileName) {
  const std::string base = fileName.substr(fileName.rfind('/') + 1);
  return base.substr(0, base.find('.'));
}

bool readDraws(Reader& reader, const JsonValue& value, const DrawContext& context, std::vector<Draw>& draws) {
  if (!reader.array(value, "draws")) return false;
  JsonValue draw = value.first();
  for (uint32_t i = 0; i < value.size(); ++i, draw = draw.next()) {
    if (!readDraw(reader, draw, context, draws.emplace_back())) return false;
  }
  return true;
}

/// Reports what validate() finds, at the field in the file; `ignoreDraws` for a scene whose draws are not read yet.
bool checkScene(Reader& reader, const JsonValue& root, const Scene& scene, bool ignoreDraws) {
  const Result<void> valid = validate(scene);
  if (valid || (ignoreDraws && valid.error().where == "draws")) return true;
  const Error& e = valid.error();
  return reader.fail(locate(root, e.where), e.where + ": " + e.what, e.hint);
}

bool readScene(Reader& reader, const JsonValue& root, const std::string& fileName, Scene& scene) {
  static constexpr std::array<std::string_view, 11> kFields{
      "$schema", "name",  "target",   "viewport", "scissor",       "furtherViewports",
      "camera",  "state", "builtIns", "draws",    "allowNonFinite"};
  if (!reader.object(root, "scene", kFields, {"target", "draws"})) return false;
  std::string ignored;
  if (const auto v = root.member("$schema"); v && !reader.text(*v, ignored)) return false;
  scene.name = stemOf(fileName);
  if (const auto v = root.member("name"); v && !reader.text(*v, scene.name)) return false;
  if (const auto v = root.member("allowNonFinite"); v && !reader.boolean(*v, scene.allowNonFinite)) return false;
  if (!readTarget(reader, *root.member("target"), scene.target)) return false;
  scene.viewport.width = static_cast<float>(scene.target.width);
  scene.viewport.height = static_cast<float>(scene.target.height);
  if (const auto v = root.member("viewport"); v && !readViewport(reader, *v, scene.viewport)) return false;
  if (const auto v = root.member("scissor"); v && !readScissor(reader, *v, scene.scissor.emplace())) return false;
  if (const auto v = root.member("furtherViewports"); v && !readFurtherViewports(reader, *v, scene.furtherViewports)) {
    return false;
  }
  if (const auto v = root.member("builtIns"); v && !readBuiltIns(reader, *v, scene.builtIns)) return false;
  if (const auto v = root.member("state"); v && !readState(reader, *v, scene.state)) return false;
  if (!checkScene(reader, root, scene, true)) return false;
  DrawContext context{scene, std::nullopt, folderOf(fileName)};
  if (const auto v = root.member("camera")) {
    const double aspect = double{scene.viewport.width} / std::fabs(double{scene.viewport.height});
    if (!readCamera(reader, *v, aspect, scene.state.negativeOneToOne, context.clipFromWorld.emplace())) return false;
  }
  return readDraws(reader, *root.member("draws"), context, scene.draws) && checkScene(reader, root, scene, false);
}

}  // namespace

Result<Scene> parseScene(std::string_view text, const std::string& fileName) {
  const Result<JsonDocument> document = JsonDocument::parse(text, fileName);
  if (!document) return tl::unexpected(document.error());
  Reader reader(text, fileName);
  Scene scene;
  if (!readScene(reader, document->root(), fileName, scene)) return tl::unexpected(reader.error());
  return scene;
}

Result<Scene> loadScene(const std::string& path) {
  const Result<std::string> text = readFile(path);
  if (!text) return tl::unexpected(text.error());
  return parseScene(*text, path);
}

}  // namespace rasterdiff
