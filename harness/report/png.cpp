// PNG files in memory, by libpng.
#include <png.h>

#include <cstddef>

#include "harness/report/picture.hpp"

namespace rasterdiff::harness {

Result<std::string> encodePng(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = image.width;
  png.height = image.height;
  png.format = PNG_FORMAT_RGBA;
  png.flags = PNG_IMAGE_FLAG_FAST;
  std::string file(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t size = file.size();
  if (png_image_write_to_memory(&png, file.data(), &size, 0, image.rgba.data(), 0, nullptr) == 0) {
    return fail(ErrorCode::Io, "PNG", png.message, "render a smaller target");
  }
  file.resize(size);
  return file;
}

}  // namespace rasterdiff::harness
