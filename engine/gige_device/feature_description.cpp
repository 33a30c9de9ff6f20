#include "engine/gige_device/feature_description.h"

#include <initializer_list>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/gige_device/registers.h"

namespace vignole::gige_device {

namespace {

using reg::Address;

std::string hex(std::uint32_t value) {
  std::ostringstream out;
  out << std::hex << value;
  return out.str();
}

enum class Access { ReadOnly, ReadWrite, WriteOnly };

/// How a feature is told about; nodes follow the order of elements that GenApi's schema wants.
struct Words {
  std::string_view toolTip, display;
  bool lockedWhileAcquiring = false;
};

class Description {
 public:
  Description(int widthPx, int heightPx) {
    out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<RegisterDescription ModelName=\"Genie_HM1400\" VendorName=\"DALSA\" ToolTip=\"Simulated camera of "
            "Vignole's virtual rig\" StandardNameSpace=\"GEV\" SchemaMajorVersion=\"1\" SchemaMinorVersion=\"1\" "
            "SchemaSubMinorVersion=\"0\" MajorVersion=\"1\" MinorVersion=\"0\" SubMinorVersion=\"0\" "
            "ProductGuid=\"6E1F0C52-8F43-4D5B-9C0E-3B6E0C1A7D11\" "
            "VersionGuid=\"A1B9D3C4-52E7-4F08-8D26-7E9F41C0B812\" "
            "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
            "xmlns=\"http://www.genicam.org/GenApi/Version_1_1\" "
            "xsi:schemaLocation=\"http://www.genicam.org/GenApi/Version_1_1 GenApiSchema_Version_1_1.xsd\">\n";
    device();
    image(widthPx, heightPx);
    acquisition();
    counters();
    chunks();
    transport();
    categories();
    out_ << "<Integer Name=\"TLParamsLocked\"><Visibility>Invisible</Visibility><Value>0</Value><Min>0</Min><Max>1"
            "</Max></Integer>\n<Port Name=\"Device\"></Port>\n</RegisterDescription>\n";
  }
  [[nodiscard]] std::string text() const { return out_.str(); }

 private:
  void begin(std::string_view type, std::string_view name, const Words& words) {
    out_ << '<' << type << " Name=\"" << name << "\" NameSpace=\"Standard\">";
    if (!words.toolTip.empty()) out_ << "<ToolTip>" << words.toolTip << "</ToolTip>";
    if (!words.display.empty()) out_ << "<DisplayName>" << words.display << "</DisplayName>";
    out_ << "<Visibility>Beginner</Visibility>";
    if (words.lockedWhileAcquiring) out_ << "<pIsLocked>TLParamsLocked</pIsLocked>";
  }
  void end(std::string_view type) { out_ << "</" << type << ">\n"; }
  void list(std::string_view feature) { listed_.back().second.emplace_back(feature); }
  void category(std::string_view name) { listed_.emplace_back(name, std::vector<std::string>()); }

  void place(Address address, std::uint32_t bytes, Access access, bool cached, std::string_view port = "Device") {
    out_ << "<Address>0x" << hex(address) << "</Address><Length>" << bytes << "</Length><AccessMode>"
         << (access == Access::ReadOnly    ? "RO"
             : access == Access::WriteOnly ? "WO"
                                           : "RW")
         << "</AccessMode><pPort>" << port << "</pPort>";
    if (!cached) out_ << "<Cachable>NoCache</Cachable>";
  }
  void integerRegister(const std::string& name, Address address, std::uint32_t bytes, Access access, bool cached) {
    out_ << "<IntReg Name=\"" << name << "\"><Visibility>Invisible</Visibility>";
    place(address, bytes, access, cached);
    out_ << "<Sign>Unsigned</Sign><Endianess>BigEndian</Endianess></IntReg>\n";
  }
  /// Bits from `lsb` down to `msb`, counted as GenICam does in big-endian registers: 31 is the last.
  void maskedRegister(const std::string& name, Address address, int lsb, int msb, Access access) {
    out_ << "<MaskedIntReg Name=\"" << name << "\"><Visibility>Invisible</Visibility>";
    place(address, 4, access, false);
    out_ << "<LSB>" << lsb << "</LSB><MSB>" << msb << "</MSB><Sign>Unsigned</Sign><Endianess>BigEndian</Endianess>"
         << "</MaskedIntReg>\n";
  }

  /// The register must be there as NAMEReg.
  void integerOf(std::string_view name, const Words& words, std::string_view bounds) {
    begin("Integer", name, words);
    out_ << "<pValue>" << name << "Reg</pValue>" << bounds;
    end("Integer");
    list(name);
  }
  void integer(std::string_view name, const Words& words, Address address, Access access, std::string_view bounds = {},
               std::uint32_t bytes = 4) {
    integerOf(name, words, bounds);
    integerRegister(std::string(name) + "Reg", address, bytes, access, access == Access::ReadWrite);
  }
  void real(std::string_view name, const Words& words, Address address, double min, double max, std::string_view unit) {
    begin("Float", name, words);
    out_ << "<pValue>" << name << "Reg</pValue><Min>" << min << "</Min><Max>" << max << "</Max><Unit>" << unit
         << "</Unit>";
    end("Float");
    list(name);
    out_ << "<FloatReg Name=\"" << name << "Reg\"><Visibility>Invisible</Visibility>";
    place(address, 4, Access::ReadWrite, true);
    out_ << "<Endianess>BigEndian</Endianess></FloatReg>\n";
  }
  void text(std::string_view name, const Words& words, Address address, std::uint32_t bytes, Access access) {
    begin("StringReg", name, words);
    place(address, bytes, access, access == Access::ReadOnly);
    end("StringReg");
    list(name);
  }
  void enumeration(std::string_view name, const Words& words, Address address,
                   std::initializer_list<std::string_view> entries, std::string_view selects = {},
                   std::uint32_t firstValue = 0) {
    begin("Enumeration", name, words);
    std::uint32_t value = firstValue;
    for (const std::string_view entry : entries)
      out_ << "<EnumEntry Name=\"" << entry << "\" NameSpace=\"Standard\"><Value>" << value++ << "</Value></EnumEntry>";
    out_ << "<pValue>" << name << "Reg</pValue>";
    if (!selects.empty()) out_ << "<pSelected>" << selects << "</pSelected>";
    end("Enumeration");
    list(name);
    integerRegister(std::string(name) + "Reg", address, 4, Access::ReadWrite, true);
  }
  void boolean(std::string_view name, const Words& words) {
    begin("Boolean", name, words);
    out_ << "<pValue>" << name << "Reg</pValue><OnValue>1</OnValue><OffValue>0</OffValue>";
    end("Boolean");
    list(name);
  }
  void command(std::string_view name, const Words& words, std::string_view registerName, std::uint32_t value) {
    begin("Command", name, words);
    out_ << "<pValue>" << registerName << "</pValue><CommandValue>" << value << "</CommandValue>";
    end("Command");
    list(name);
  }
  void command(std::string_view name, const Words& words, Address address) {
    command(name, words, std::string(name) + "Reg", 1);
    integerRegister(std::string(name) + "Reg", address, 4, Access::WriteOnly, false);
  }

  void device() {
    category("DeviceControl");
    text("DeviceVendorName", {"Who made the camera", "Vendor"}, reg::kVendor, 32, Access::ReadOnly);
    text("DeviceModelName", {"Model of the camera", "Model"}, reg::kModel, 32, Access::ReadOnly);
    text("DeviceVersion", {"Version of the camera", "Version"}, reg::kDeviceVersion, 32, Access::ReadOnly);
    text("DeviceManufacturerInfo", {"What the maker says", "Information"}, reg::kManufacturerInfo, 48,
         Access::ReadOnly);
    text("DeviceSerialNumber", {"Serial number", "Serial number"}, reg::kSerial, 16, Access::ReadOnly);
    text("DeviceID", {"Serial number", "Device ID"}, reg::kSerial, 16, Access::ReadOnly);
    text("DeviceUserID", {"Name given by the user", "User name"}, reg::kUserName, 16, Access::ReadWrite);
  }

  void image(int widthPx, int heightPx) {
    const std::string step = std::to_string(kRegionStep);
    const auto bounds = [&](int min, std::string_view max) {
      return "<Min>" + std::to_string(min) + "</Min><pMax>" + std::string(max) + "</pMax><Inc>" + step + "</Inc>";
    };
    const auto formula = [&](std::string_view name, std::string_view offset, int sensor) {
      out_ << "<IntSwissKnife Name=\"" << name << "\"><Visibility>Invisible</Visibility><pVariable Name=\"OTHER\">"
           << offset << "</pVariable><Formula>" << sensor << " - OTHER</Formula></IntSwissKnife>\n";
    };
    category("ImageFormatControl");
    integer("SensorWidth", {"Columns of the sensor", "Sensor width"}, reg::kSensorWidth, Access::ReadOnly);
    integer("SensorHeight", {"Rows of the sensor", "Sensor height"}, reg::kSensorHeight, Access::ReadOnly);
    integer("WidthMax", {"Columns of the sensor", "Width max"}, reg::kSensorWidth, Access::ReadOnly);
    integer("HeightMax", {"Rows of the sensor", "Height max"}, reg::kSensorHeight, Access::ReadOnly);
    integer("Width", {"Columns of the region", "Width", true}, reg::kWidth, Access::ReadWrite, bounds(4, "WidthRoom"));
    integer("Height", {"Rows of the region", "Height", true}, reg::kHeight, Access::ReadWrite, bounds(4, "HeightRoom"));
    integer("OffsetX", {"First column of the region", "Offset X", true}, reg::kOffsetX, Access::ReadWrite,
            bounds(0, "OffsetXRoom"));
    integer("OffsetY", {"First row of the region", "Offset Y", true}, reg::kOffsetY, Access::ReadWrite,
            bounds(0, "OffsetYRoom"));
    formula("WidthRoom", "OffsetXReg", widthPx);
    formula("HeightRoom", "OffsetYReg", heightPx);
    formula("OffsetXRoom", "WidthReg", widthPx);
    formula("OffsetYRoom", "HeightReg", heightPx);
    enumeration("PixelFormat", {"8 bits a pixel, grey", "Pixel format", true}, reg::kPixelFormat, {"Mono8"}, {},
                reg::kMono8);
    integer("PayloadSize", {"Bytes of a frame with its chunks", "Payload size"}, reg::kPayloadSize, Access::ReadOnly);
  }

  void acquisition() {
    category("AcquisitionControl");
    enumeration("AcquisitionMode", {"How many frames", "Acquisition mode", true}, reg::kAcquisitionMode,
                {"Continuous", "SingleFrame", "MultiFrame"});
    integer("AcquisitionFrameCount", {"Frames of MultiFrame", "Frame count", true}, reg::kAcquisitionFrames,
            Access::ReadWrite, "<Min>1</Min><Max>65535</Max>");
    command("AcquisitionStart", {"Frames may come", "Start"}, reg::kAcquisitionStart);
    command("AcquisitionStop", {"No more frames", "Stop"}, reg::kAcquisitionStop);
    real(feature::kFrameRateHz, {"Frames a second while TriggerMode is Off", "Frame rate"}, reg::kFrameRate,
         kMinFrameRateHz, kMaxFrameRateHz, "Hz");
    real(feature::kExposureTimeUs, {"A trigger before its end is ignored", "Exposure time"}, reg::kExposureTime,
         kMinExposureUs, kMaxExposureUs, "us");
    real(feature::kGain, {"Kept, but changes no picture", "Gain"}, reg::kGain, 0, kMaxGainDb, "dB");
    enumeration("TriggerSelector", {"What a trigger does", "Trigger selector"}, reg::kTriggerSelector, {"FrameStart"},
                "TriggerMode");
    enumeration("TriggerMode", {"Off: frames at the frame rate", "Trigger mode"}, reg::kTriggerMode, {"Off", "On"});
    enumeration("TriggerSource",
                {"Line1: the encoder; Line2: a rail that enters; Software: the command", "Trigger source"},
                reg::kTriggerSource, {"Line1", "Line2", "Software"});
    enumeration("TriggerActivation", {"Edge of the line", "Trigger activation"}, reg::kTriggerActivation,
                {"RisingEdge", "FallingEdge"});
    command("TriggerSoftware", {"Trigger, if its source is Software", "Software trigger"}, reg::kTriggerSoftware);
  }

  void counters() {
    category("CounterAndLineControl");
    enumeration("TimestampCounter", {"What the timestamp of a frame counts", "Timestamp counter"},
                reg::kTimestampCounter, {"InternalClock", "Line1"});
    command("TimestampReset", {"The timestamp begins at 0 again", "Timestamp reset"}, "TimestampControlReg",
            reg::kTimestampReset);
    integer("LineStatusAll", {"Bit 0: Line1, the encoder. Bit 1: Line2, a rail is in the rig", "Line status"},
            reg::kLineStatusAll, Access::ReadOnly);
    integer("EncoderTriggerCount", {"Triggers that the encoder has issued", "Encoder triggers"}, reg::kEncoderCount,
            Access::ReadOnly, {}, 8);
    integer("EncoderPosition", {"Micrometres that the encoder has travelled", "Encoder position"},
            reg::kEncoderPosition, Access::ReadOnly, {}, 8);
  }

  void chunks() {
    category("ChunkDataControl");
    boolean("ChunkModeActive", {"Frames carry chunks", "Chunk mode", true});
    integerRegister("ChunkModeActiveReg", reg::kChunkModeActive, 4, Access::ReadWrite, true);
    begin("Enumeration", "ChunkSelector", {"The chunk that ChunkEnable is of", "Chunk selector"});
    for (std::size_t i = 0; i < kChunks.size(); ++i)
      out_ << "<EnumEntry Name=\"" << kChunks[i].entry << "\" NameSpace=\"Standard\"><Value>" << i
           << "</Value></EnumEntry>";
    out_ << "<pValue>ChunkSelectorReg</pValue><pSelected>ChunkEnable</pSelected>";
    end("Enumeration");
    list("ChunkSelector");
    integerRegister("ChunkSelectorReg", reg::kChunkSelector, 4, Access::ReadWrite, false);
    boolean("ChunkEnable", {"The selected chunk is carried", "Chunk enable", true});
    out_ << "<IntReg Name=\"ChunkEnableReg\"><Visibility>Invisible</Visibility><pAddress>ChunkEnableAddress</pAddress>"
            "<Length>4</Length><AccessMode>RW</AccessMode><pPort>Device</pPort><Cachable>NoCache</Cachable>"
            "<Sign>Unsigned</Sign><Endianess>BigEndian</Endianess></IntReg>\n"
            "<IntSwissKnife Name=\"ChunkEnableAddress\"><Visibility>Invisible</Visibility><pVariable Name=\"SEL\">"
            "ChunkSelectorReg</pVariable><Formula>"
         << reg::kChunkEnable << " + SEL * 4</Formula></IntSwissKnife>\n";
    for (const ChunkFeature& chunk : kChunks) {
      if (chunk.node == nullptr) continue;
      const std::string port = std::string(chunk.node) + "Port";
      out_ << "<Port Name=\"" << port << "\"><Visibility>Invisible</Visibility><ChunkID>"
           << hex(static_cast<std::uint32_t>(chunk.id)) << "</ChunkID></Port>\n<IntReg Name=\"" << chunk.node
           << "Reg\">"
           << "<Visibility>Invisible</Visibility>";
      place(0, chunk.bytes, Access::ReadOnly, false, port);
      out_ << "<Sign>Unsigned</Sign><Endianess>BigEndian</Endianess></IntReg>\n<Integer Name=\"" << chunk.node
           << "\"><Visibility>Beginner</Visibility><pValue>" << chunk.node << "Reg</pValue></Integer>\n";
    }
  }

  void transport() {
    category("TransportLayerControl");
    const auto packetBounds = "<Min>" + std::to_string(kMinPacketSize) + "</Min><Max>" +
                              std::to_string(kMaxPacketSize) + "</Max><Inc>4</Inc><Unit>B</Unit>";
    const auto heartbeatBounds = "<Min>" + std::to_string(kMinHeartbeatMs) + "</Min><Max>" +
                                 std::to_string(kMaxHeartbeatMs) +
                                 "</Max>"
                                 "<Unit>ms</Unit>";
    integerOf("GevSCPSPacketSize", {"Bytes of a packet of the stream, with its IP header", "Packet size", true},
              packetBounds);
    maskedRegister("GevSCPSPacketSizeReg", reg::kPacketSize, 31, 16, Access::ReadWrite);
    boolean("GevSCPSDoNotFragment", {"Packets are not to be cut", "Do not fragment"});
    maskedRegister("GevSCPSDoNotFragmentReg", reg::kPacketSize, 1, 1, Access::ReadWrite);
    command("GevSCPSFireTestPacket", {"Sends one packet of the packet size", "Fire test packet"},
            "GevSCPSFireTestPacketReg", 1);
    maskedRegister("GevSCPSFireTestPacketReg", reg::kPacketSize, 0, 0, Access::ReadWrite);
    integer("GevSCPD", {"Ticks of the timestamp between two packets", "Packet delay"}, reg::kPacketDelay,
            Access::ReadWrite, "<Min>0</Min><Max>10000000</Max>");
    integerOf("GevSCPHostPort", {"Port that the stream goes to", "Stream port", true}, {});
    maskedRegister("GevSCPHostPortReg", reg::kStreamPort, 31, 16, Access::ReadWrite);
    integer("GevSCDA", {"Address that the stream goes to", "Stream address", true}, reg::kStreamAddress,
            Access::ReadWrite);
    integer("GevHeartbeatTimeout", {"The controller is given up when it has been silent so long", "Heartbeat timeout"},
            reg::kHeartbeatTimeout, Access::ReadWrite, heartbeatBounds);
    text("GevSerialNumber", {"Serial number", "Serial number"}, reg::kSerial, 16, Access::ReadOnly);
    integer("GevCurrentIPAddress", {"Address of the camera", "Address"}, reg::kIpAddress, Access::ReadOnly);
    integer("GevTimestampTickFrequency", {"Ticks of the timestamp a second", "Tick frequency"}, reg::kTickFrequencyHigh,
            Access::ReadOnly, {}, 8);
    command("GevTimestampControlReset", {"The timestamp begins at 0 again", "Timestamp reset"}, "TimestampControlReg",
            reg::kTimestampReset);
    command("GevTimestampControlLatch", {"Keeps the timestamp in GevTimestampValue", "Timestamp latch"},
            "TimestampControlReg", reg::kTimestampLatch);
    integerRegister("TimestampControlReg", reg::kTimestampControl, 4, Access::WriteOnly, false);
    integer("GevTimestampValue", {"The timestamp when it was latched", "Timestamp"}, reg::kTimestampHigh,
            Access::ReadOnly, {}, 8);
    enumeration("GevGVSPExtendedIDMode", {"Frame ids of 64 bits", "Extended ids", true}, reg::kExtendedIds,
                {"Off", "On"});
  }

  void categories() {
    out_ << "<Category Name=\"Root\" NameSpace=\"Standard\">";
    for (const auto& [name, features] : listed_) out_ << "<pFeature>" << name << "</pFeature>";
    out_ << "</Category>\n";
    for (const auto& [name, features] : listed_) {
      out_ << "<Category Name=\"" << name << "\" NameSpace=\"Standard\">";
      for (const std::string& f : features) out_ << "<pFeature>" << f << "</pFeature>";
      out_ << "</Category>\n";
    }
  }

  std::ostringstream out_;
  std::vector<std::pair<std::string, std::vector<std::string>>> listed_;
};

}  // namespace

std::string featureDescription(int widthPx, int heightPx) {
  std::string text = Description(widthPx, heightPx).text();
  text.resize((text.size() + 3) / 4 * 4, '\n');
  return text;
}

}  // namespace vignole::gige_device
