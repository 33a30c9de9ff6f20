#pragma once
// How a GigE Vision camera is driven.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vignole {

/// Where the trigger's count is read. Auto: the first that the camera can, in this order.
enum class CountSource {
  Auto,
  Timestamp,  ///< the camera's timestamp counts the pulses of the trigger line
  Chunk,      ///< a chunk of the frame carries the count
  FrameId     ///< only frames are counted: a trigger that the camera missed cannot be told
};
[[nodiscard]] const char* name(CountSource source);

/// Names of features: of several the first that the camera has. An empty list: not used.
struct FeatureNames {
  using Names = std::vector<std::string>;
  Names exposure = {"ExposureTime", "ExposureTimeAbs", "ExposureTimeRaw"};  ///< microseconds
  Names gain = {"Gain", "GainAbs", "GainRaw"};
  Names timestampCounter = {"TimestampCounter"};  ///< what the timestamp counts; the trigger line is its value
  Names timestampReset = {"TimestampReset", "GevTimestampControlReset"};
  Names timestampLatch = {"TimestampLatch", "GevTimestampControlLatch"};
  Names timestampValue = {"TimestampLatchValue", "GevTimestampValue"};
  Names serial = {"DeviceSerialNumber", "DeviceID", "GevSerialNumber"};
  Names heartbeat = {"GevHeartbeatTimeout"};
  std::string countChunk = "CounterValue";            ///< entry of ChunkSelector
  std::string countChunkValue = "ChunkCounterValue";  ///< feature that reads it
  std::string lineChunk = "LineStatusAll";
  std::string lineChunkValue = "ChunkLineStatusAll";
};

struct GigeCameraSettings {
  std::string address;                     ///< IPv4
  std::string serial;                      ///< what must answer there; empty: any camera
  int xPx = 0, yPx = 0;                    ///< first pixel of the region
  int widthPx = 1400, heightPx = 1024;     ///< of the region
  std::optional<double> exposureMs, gain;  ///< empty: as the camera has it
  std::string triggerLine = "Line1";       ///< empty: runs free at the camera's own rate
  CountSource count = CountSource::Auto;
  std::optional<int> railLine;      ///< bit of the line status that says that a rail is there; empty: unused
  int packetBytes = 8192;           ///< with IP header; smaller if the way does not carry it. 0: the largest
  int socketBufferBytes = 4 << 20;  ///< FIXED; the system's own is far too small
  int frameRetentionMs = 35;        ///< a frame whose packets are missing is waited for so long
  bool resend = true;               ///< missing packets are asked for again
  int buffers = 66;                 ///< frames
  bool packetSocket = false;        ///< halves the cost, adds 3 ms, needs a privilege
  int heartbeatMs = 3000;           ///< after which the camera forgets a controller that died
  FeatureNames features;
  std::vector<std::string> extra;  ///< "Feature=Value", written before the trigger is armed
};

/// What answered.
struct GigeIdentity {
  std::string address, serial, vendor, model, userName, manufacturerInfo;
};

}  // namespace vignole
