// Sampled procedural pictures against their true means: pixel by pixel (aliasing) and from afar (moiré).
#include "rasterizer/methods/measure_row.hpp"
#include "rasterizer/methods/procedural.hpp"
#include "rasterizer/methods/sampling_methods.hpp"

namespace rasterdiff::rasterizer {

void measureAliasing(const MethodTableOptions&, std::vector<MethodRow>& rows) {
  std::vector<MethodRow> moire;
  for (const ProceduralPicture& picture : proceduralPictures()) {
    const GrayImage truth = meanPicture(picture);
    for (const SamplingMethod& method : samplingMethods()) {
      const PictureError error = comparePictures(samplePicture(picture, method.points), truth);
      const std::string inputs(picture.name);
      rows.push_back(measuredRow("aliasing", method.name, true, inputs, error.pixels, error.wrongPixels));
      moire.push_back(measuredRow("moire", method.name, true, inputs, error.blocks, error.wrongBlocks));
    }
  }
  rows.insert(rows.end(), moire.begin(), moire.end());
}

}  // namespace rasterdiff::rasterizer
