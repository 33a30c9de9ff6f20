#include "engine/site/site.h"

#include <gtest/gtest.h>

namespace vignole {
namespace {

const char* const kFour =
    "[[range_finder]]\nserial = \"A1\"\naddress = \"192.168.1.11\"\n"
    "[[range_finder]]\nserial = \"A2\"\naddress = \"192.168.2.11\"\nexposure_ms = 9.5\n"
    "[[range_finder]]\nserial = \"A3\"\n"
    "[[range_finder]]\nserial = \"A4\"\naddress = \"192.168.4.11\"\n";

std::string siteText(const std::string& head, const std::string& finders = kFour) {
  return "format = 1\n" + head + finders;
}
std::string refusal(const std::string& text) {
  const auto site = parseSite(text, "line.toml");
  return site ? "" : site.error().message();
}

TEST(Site, NamesFourCamerasAndTheRestIsAsUsual) {
  const auto site = parseSite(siteText("calibration = \"rig.toml\"\n"), "/etc/mill/line.toml");
  ASSERT_TRUE(site) << site.error().message();
  EXPECT_EQ(site->cameras[0].serial, "A1");
  EXPECT_EQ(site->cameras[1].address, "192.168.2.11");
  EXPECT_EQ(site->cameras[1].exposureMs, 9.5);
  EXPECT_FALSE(site->cameras[0].exposureMs);
  EXPECT_TRUE(site->cameras[2].address.empty());
  EXPECT_EQ(site->calibration, "/etc/mill/rig.toml");
  EXPECT_DOUBLE_EQ(site->spacingMm(), 15);
  EXPECT_EQ(site->cameras[3].buffers, 66);
  EXPECT_EQ(site->cameras[3].frameRetentionMs, 35);
  EXPECT_EQ(site->cameras[3].socketBufferBytes, 4194304);
  EXPECT_TRUE(site->cameras[3].resend);
}

TEST(Site, EverySettingIsReadAndWrittenBackTheSame) {
  const auto site = parseSite(
      siteText("name = \"south\"\ncalibration = \"rig.toml\"\n[trigger]\nline = \"Line2\"\ncount = \"chunk\"\n"
               "mm_per_encoder_count = 0.025\nencoder_divider = 400\n[camera]\nexposure_ms = 12\ngain = 2\nx_px = 8\n"
               "y_px = 4\nwidth_px = 1000\nheight_px = 800\npacket_bytes = 1500\nsocket_buffer_bytes = 2097152\n"
               "frame_retention_ms = 50\nresend = false\nbuffers = 80\npacket_socket = true\nheartbeat_ms = 1500\n"
               "extra = [\"CounterSelector=Timestamp\", \"CounterEventSource=Line2\"]\n[features]\n"
               "exposure = \"ExposureTimeRaw\"\nline_chunk = \"Lines\"\n[rails]\ntold_by = \"line\"\nline_bit = 3\n"
               "begin_after = 4\nend_after = 9\ncontrast_dn = 20\npixels = 50\n[watch]\nsilent_triggers = 5\n"
               "silent_s = 0.1\nlost_triggers = 20\nlost_s = 2\n"),
      "south.toml");
  ASSERT_TRUE(site) << site.error().message();
  const GigeCameraSettings& c = site->cameras[3];
  EXPECT_EQ(c.triggerLine, "Line2");
  EXPECT_EQ(c.count, CountSource::Chunk);
  EXPECT_EQ(c.features.exposure, FeatureNames::Names{"ExposureTimeRaw"});
  EXPECT_EQ(c.features.lineChunk, "Lines");
  EXPECT_EQ(c.railLine, 3);
  EXPECT_EQ(c.extra.size(), 2u);
  EXPECT_DOUBLE_EQ(site->spacingMm(), 10);
  EXPECT_EQ(site->watch.lostTriggers, 20u);
  const std::string text = toToml(*site);
  const auto again = parseSite(text, "south.toml");
  ASSERT_TRUE(again) << again.error().message() << "\n" << text;
  EXPECT_EQ(toToml(*again), text);
  EXPECT_EQ(again->cameras[1].exposureMs, 9.5);
  EXPECT_EQ(again->cameras[0].exposureMs, 12);
}

TEST(Site, RefusesWhatCannotBe) {
  EXPECT_NE(refusal(siteText("[camera]\nexposure = 1\n")).find("camera.exposure: is not known here"),
            std::string::npos);
  EXPECT_NE(refusal(siteText("[trigger]\ncount = \"clock\"\n")).find("give auto, timestamp, chunk or frame-id"),
            std::string::npos);
  EXPECT_NE(refusal(siteText("[rails]\ntold_by = \"luck\"\n")).find("give pictures or line"), std::string::npos);
  EXPECT_NE(refusal(siteText("[camera]\npacket_bytes = 100\n")).find("576"), std::string::npos);
  EXPECT_NE(refusal(siteText("[camera]\nextra = [\"Nothing\"]\n")).find("Feature=Value"), std::string::npos);
  EXPECT_NE(refusal(siteText("", "[[range_finder]]\nserial = \"A\"\n")).find("four times"), std::string::npos);
  std::string twice = kFour;
  twice.replace(twice.find("A2"), 2, "A1");
  EXPECT_NE(refusal(siteText("", twice)).find("given twice"), std::string::npos);
  std::string same = kFour;
  same.replace(same.find("192.168.4.11"), 12, "192.168.1.11");
  EXPECT_NE(refusal(siteText("", same)).find("192.168.1.11 is given twice"), std::string::npos);
  std::string bad = kFour;
  bad.replace(bad.find("192.168.4.11"), 12, "camera-4.mil");
  EXPECT_NE(refusal(siteText("", bad)).find("no IPv4 address"), std::string::npos);
  EXPECT_NE(refusal(siteText("", bad)).find("line.toml:"), std::string::npos) << "says where";
}

TEST(Site, FromAnAddressAreFourInARow) {
  const auto site = siteFrom("127.0.0.11");
  ASSERT_TRUE(site);
  EXPECT_EQ(site->cameras[0].address, "127.0.0.11");
  EXPECT_EQ(site->cameras[3].address, "127.0.0.14");
  EXPECT_TRUE(site->cameras[3].serial.empty());
  EXPECT_FALSE(siteFrom("127.0.0"));
  EXPECT_FALSE(siteFrom("127.0.0.254"));
}

TEST(Site, ACalibrationOfOtherCamerasIsRefused) {
  RigCalibration calibration;
  for (std::size_t c = 0; c < 4; ++c) calibration.rangeFinders[c].serial = "A" + std::to_string(c + 1);
  EXPECT_TRUE(checkBelongs(calibration, {"A1", "A2", "A3", "A4"}, "rig.toml"));
  EXPECT_TRUE(checkBelongs(calibration, {"A1", "", "A3", "A4"}, "rig.toml")) << "a camera without a number";
  const auto swapped = checkBelongs(calibration, {"A1", "A3", "A2", "A4"}, "rig.toml");
  ASSERT_FALSE(swapped);
  EXPECT_EQ(swapped.error().message(),
            "rig.toml: camera 2 is A3, which was calibrated as camera 3; swap the cables back or calibrate again");
  const auto other = checkBelongs(calibration, {"A1", "A2", "A3", "B9"}, "rig.toml");
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().what.find("camera 4 is B9 but the calibration is of A4"), std::string::npos);
}

}  // namespace
}  // namespace vignole
