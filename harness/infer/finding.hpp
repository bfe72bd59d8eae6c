// What experiments found out about a driver: one finding a choice, sample locations, measured errors.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rasterizer/choice_table.hpp"

namespace rasterdiff::harness {

/// How sure: what else was tried, and at how many samples or values it contradicted the driver.
struct Rival {
  uint32_t answer = 0;          ///< index into the choice's answers
  uint64_t contradictions = 0;  ///< 0: no experiment told it from the answer
};

struct Finding {
  enum class Status : uint8_t {
    Found,       ///< one answer agrees with the driver everywhere
    NoneFits,    ///< every candidate was contradicted: the choice stays open
    NotOffered,  ///< the device does not offer what the choice is about: it stays open
  };
  rasterizer::Choice choice{};
  Status status = Status::NotOffered;
  uint32_t answer = 0;          ///< Found: the answer; NoneFits: the last candidate to go
  std::vector<Rival> rivals{};  ///< Found: the other answers, all else being equal
  uint32_t scenes = 0;          ///< experiments that the answer agrees with
  uint64_t samples = 0;         ///< samples that were compared in them

  /// Contradictions of the best rival that was excluded; 0 if there is none.
  [[nodiscard]] uint64_t decidingEvents() const;
  /// Answers that no experiment told from the one found.
  [[nodiscard]] std::vector<uint32_t> alike() const;
};

/// Where the samples of one pixel are, in 1/256 pixel.
struct SampleFinding {
  uint32_t samples = 1;
  std::vector<rasterizer::SampleTables::Offset> offsets{};
  bool standard = false;
  uint64_t decidingEvents = 0;  ///< least contradictions met by moving one sample by 1/16 pixel
};

/// Distance of interpolated values from the exact ones.
struct ErrorMeasure {
  std::string name;  ///< "smooth", "noperspective", "depth"
  uint64_t values = 0, exact = 0;
  double maxUlp = 0, meanUlp = 0;
};

struct Inference {
  std::string driver, info;      ///< name and exact version of the subject
  uint32_t advertisedBits = 8;   ///< subPixelPrecisionBits
  rasterizer::Choices choices{};  ///< all that was found; nominal answers where a choice is open
  uint32_t openChoices = 0;       ///< bits by rasterizer::Choice
  std::vector<Finding> findings{};
  std::vector<SampleFinding> samples{};
  std::vector<ErrorMeasure> errors{};
  bool valuesDecided = false;     ///< choices.valuesOpen rests on experiments
  uint64_t valuesOutside = 0;     ///< values away from where closed rules have them evaluated
  uint32_t scenes = 0;            ///< experiments in all
  double seconds = 0;

  [[nodiscard]] const Finding& of(rasterizer::Choice choice) const;
};

}  // namespace rasterdiff::harness
