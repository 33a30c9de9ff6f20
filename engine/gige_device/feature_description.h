#pragma once
// The GenICam description of a camera: which features there are and in which registers they are.

#include <array>
#include <string>

#include "engine/gige_device/camera_contract.h"

namespace vignole::gige_device {

/// A chunk as ChunkSelector lists it; its place in kChunks is the entry's value.
struct ChunkFeature {
  ChunkId id;
  const char* entry;  ///< in ChunkSelector
  const char* node;   ///< reads it; none for the image
  std::uint32_t bytes;
};
inline constexpr std::array<ChunkFeature, 5> kChunks = {
    {{ChunkId::Image, "Image", nullptr, 0},
     {ChunkId::EncoderCount, "CounterValue", "ChunkCounterValue", 8},
     {ChunkId::EncoderPosition, "EncoderValue", "ChunkEncoderValue", 8},
     {ChunkId::LineStatus, "LineStatusAll", "ChunkLineStatusAll", 4},
     {ChunkId::Clock, "Timestamp", "ChunkTimestamp", 8}}};

inline constexpr int kMinPacketSize = 576, kMaxPacketSize = 9000;
inline constexpr int kMinHeartbeatMs = 500, kMaxHeartbeatMs = 65000;
inline constexpr double kMinExposureUs = 10, kMaxExposureUs = 1e6, kMaxGainDb = 24, kMinFrameRateHz = 0.1,
                        kMaxFrameRateHz = 200;
inline constexpr int kRegionStep = 4;

/// XML, its size a multiple of 4 (padded with line ends), for a sensor of that size.
[[nodiscard]] std::string featureDescription(int widthPx, int heightPx);

}  // namespace vignole::gige_device
