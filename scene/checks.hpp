// The parts of validate(): each checks one part of a scene and names the field that is wrong.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace rasterdiff::checks {

using Check = Result<void>;

[[nodiscard]] tl::unexpected<Error> bad(std::string where, std::string what, std::string hint = {});

[[nodiscard]] Check checkName(const std::string& name);
[[nodiscard]] Check checkTarget(const Target& target);
/// Viewport and scissor 0 and all further ones, at their size after supersampling.
[[nodiscard]] Check checkViewports(const Scene& scene);
/// State, what it asks of target, draws and built-ins.
[[nodiscard]] Check checkState(const Scene& scene);
[[nodiscard]] Check checkBuiltIns(const Scene& scene);
/// Draw `index`: its arrays, and that it is like draw 0.
[[nodiscard]] Check checkDraw(const Scene& scene, size_t index);

}  // namespace rasterdiff::checks
