#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <sstream>
#include <unistd.h>

#include "engine/files/atomic_file.h"
#include "engine/rail/catalogue.h"
#include "engine/rail/outline.h"

namespace vignole {
namespace {

namespace fs = std::filesystem;

constexpr double kDegree = std::numbers::pi / 180;

class Import : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("vignole_import_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  Expected<Section> import(const std::string& fileName, const std::string& text) {
    EXPECT_TRUE(writeFile(folder_ / fileName, text));
    return importSection(folder_ / fileName, "MINE");
  }
  fs::path folder_;
};

std::string number(double v) {
  std::ostringstream s;
  s.precision(12);
  s << v;
  return s.str();
}

std::string group(int code, const std::string& value) { return std::to_string(code) + "\n" + value + "\n"; }
std::string group(int code, double value) { return group(code, number(value)); }

std::string dxf(const std::string& entities, const std::string& header = "") {
  return group(0, "SECTION") + group(2, "HEADER") + header + group(0, "ENDSEC") + group(0, "SECTION") +
         group(2, "ENTITIES") + entities + group(0, "ENDSEC") + group(0, "EOF");
}

std::string lineEntity(const Point2& a, const Point2& b) {
  return group(0, "LINE") + group(8, "0") + group(10, a.x()) + group(20, a.y()) + group(30, 0) + group(11, b.x()) +
         group(21, b.y()) + group(31, 0);
}

/// A DXF arc always runs counter-clockwise.
std::string arcEntity(const Arc& arc) {
  const double a = arc.startAngleRad, b = a + arc.sweepRad;
  return group(0, "ARC") + group(8, "0") + group(10, arc.centre.x()) + group(20, arc.centre.y()) + group(30, 0) +
         group(40, arc.radiusMm) + group(50, (arc.sweepRad > 0 ? a : b) / kDegree) +
         group(51, (arc.sweepRad > 0 ? b : a) / kDegree);
}

std::string entity(const Primitive& shape, bool backwards) {
  if (const auto* arc = std::get_if<Arc>(&shape)) return arcEntity(*arc);
  return backwards ? lineEntity(endPoint(shape), startPoint(shape)) : lineEntity(startPoint(shape), endPoint(shape));
}

std::string shuffledEntities(const Section& section, const Transform2& moved, unsigned seed) {
  std::vector<std::string> entities;
  std::mt19937 random(seed);
  for (const NamedPrimitive& p : section.primitives)
    entities.push_back(entity(transformed(moved, p.shape), random() % 2 == 0));
  std::shuffle(entities.begin(), entities.end(), random);
  std::string all;
  for (const std::string& e : entities) all += e;
  return all;
}

std::string polylineEntity(const Section& section) {
  std::string text = group(0, "LWPOLYLINE") + group(100, "AcDbPolyline") +
                     group(90, std::to_string(section.primitives.size())) + group(70, "1");
  for (const NamedPrimitive& p : section.primitives) {
    const Point2 a = startPoint(p.shape);
    text += group(10, a.x()) + group(20, a.y());
    if (const auto* arc = std::get_if<Arc>(&p.shape)) text += group(42, std::tan(arc->sweepRad / 4));
  }
  return text;
}

/// Same names in the same order, same shapes.
void expectSame(const Section& read, const Section& written) {
  ASSERT_EQ(read.primitives.size(), written.primitives.size()) << written.name;
  const std::size_t shift = *written.find("SBB");
  for (std::size_t i = 0; i < read.primitives.size(); ++i) {
    const NamedPrimitive& a = read.primitives[i];
    const NamedPrimitive& b = written.primitives[(i + shift) % written.primitives.size()];
    EXPECT_EQ(a.name, b.name) << written.name;
    EXPECT_NEAR((startPoint(a.shape) - startPoint(b.shape)).norm(), 0, 2e-5) << written.name << " " << b.name;
    EXPECT_NEAR(curvature(a.shape), curvature(b.shape), 1e-4) << written.name << " " << b.name;
    EXPECT_NEAR(length(a.shape), length(b.shape), 1e-4) << written.name << " " << b.name;
  }
}

TEST_F(Import, DxfOfEverySectionInAnyOrderComesBackWithItsNames) {
  unsigned seed = 1;
  for (const std::string& name : catalogueNames()) {
    if (name == "ASYM54" || name == "115RE") continue;  // below
    const Section section = *findSection(name);
    const auto read = import("a.dxf", dxf(shuffledEntities(section, {123, -45, 0}, seed++)));
    ASSERT_TRUE(read) << name << ": " << read.error().message();
    EXPECT_EQ(read->name, "MINE");
    expectSame(*read, section);
    EXPECT_NEAR(read->axisFromFootMiddleMm, 0, 1e-9);
    EXPECT_EQ(read->standing, SectionStanding::Approximate);
  }
}

TEST_F(Import, AsymmetricRailKeepsItsAxis) {
  const Section section = *findSection("ASYM54");
  const auto read = import("a.dxf", dxf(shuffledEntities(section, {}, 5)));
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_NEAR(read->axisFromFootMiddleMm, 10.5, 1e-4);
  EXPECT_NEAR(startPoint(read->primitives[*read->find("SBR")].shape).x(), 73.5, 1e-4) << "origin at mid-foot";
  EXPECT_NEAR(read->parameters.rfhFromAxisMm.left, 33.68, 0.01) << "25 is not on both surfaces";
  EXPECT_EQ(read->parameters.rfhFromAxisMm.right, 25);
  for (std::size_t i = 0; i < section.primitives.size(); ++i)
    EXPECT_EQ(read->primitives[i].name, section.primitives[i].name);
}

TEST_F(Import, WebOfOneArcIsOnePrimitive) {
  // In the catalogue 115RE's web is two arcs of one circle, named apart.
  const auto read = import("a.dxf", dxf(shuffledEntities(*findSection("115RE"), {}, 5)));
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->primitives.size(), 26U);
  for (const char* name : {"AWR", "AWL", "AWBR", "AWTL", "ABTR1", "SWBR", "AHTR2"})
    EXPECT_TRUE(read->find(name)) << name;
  EXPECT_NEAR(properties(*read).areaMm2, properties(*findSection("115RE")).areaMm2, 0.01);
}

TEST_F(Import, DxfPolylineWithBulgesAndUnits) {
  const Section section = *findSection("60E1");
  const auto lightweight = import("a.dxf", dxf(polylineEntity(section)));
  ASSERT_TRUE(lightweight) << lightweight.error().message();
  expectSame(*lightweight, section);

  Section inches = section;
  for (NamedPrimitive& p : inches.primitives) {
    if (auto* s = std::get_if<Segment>(&p.shape)) {
      s->start /= 25.4;
      s->end /= 25.4;
    } else {
      auto& a = std::get<Arc>(p.shape);
      a.centre /= 25.4;
      a.radiusMm /= 25.4;
    }
  }
  const auto read = import("b.dxf", dxf(shuffledEntities(inches, {}, 3), group(9, "$INSUNITS") + group(70, "1")));
  ASSERT_TRUE(read) << read.error().message();
  expectSame(*read, section);
}

TEST_F(Import, HalvesOfOneLineOrArcAreJoined) {
  const Section section = *findSection("60E1");
  std::string entities;
  for (const NamedPrimitive& p : section.primitives) {
    if (p.name == "SBB") {
      entities += lineEntity(startPoint(p.shape), {0, 0}) + lineEntity({0, 0}, endPoint(p.shape));
    } else if (p.name == "AHT") {
      Arc half = std::get<Arc>(p.shape);
      half.sweepRad /= 2;
      entities += arcEntity(half);
      half.startAngleRad += half.sweepRad;
      entities += arcEntity(half) + arcEntity(half);  // and one of them twice
    } else {
      entities += entity(p.shape, false);
    }
  }
  const auto read = import("a.dxf", dxf(entities));
  ASSERT_TRUE(read) << read.error().message();
  expectSame(*read, section);
}

std::string messageOf(const Expected<Section>& section) { return section ? "accepted" : section.error().message(); }

TEST_F(Import, RefusesDxfThatDoesNotClose) {
  Section open = *findSection("60E1");
  open.primitives.erase(open.primitives.begin() + static_cast<std::ptrdiff_t>(*open.find("SHR")));
  const std::string message = messageOf(import("a.dxf", dxf(shuffledEntities(open, {}, 2))));
  EXPECT_NE(message.find("does not close"), std::string::npos) << message;
  EXPECT_NE(message.find("21 mm away"), std::string::npos) << "the length of SHR: " << message;
}

TEST_F(Import, RefusesDxfThatIsMoreOrLessThanAnOutline) {
  const std::string whole = shuffledEntities(*findSection("60E1"), {}, 2);
  const auto refused = [&](const std::string& text, const std::string& why) {
    const std::string message = messageOf(import("a.dxf", text));
    EXPECT_NE(message.find(why), std::string::npos) << message;
  };
  const std::string spline = group(0, "ELLIPSE") + group(8, "0") + group(10, 0) + group(20, 0) + group(11, 5) +
                             group(21, 0) + group(40, 0.5) + group(41, 0) + group(42, 3);
  refused(dxf(whole + spline), "ELLIPSE");
  refused(dxf(whole + group(0, "CIRCLE") + group(10, 0) + group(20, 70) + group(40, 10)), "CIRCLE");
  refused(dxf(whole + lineEntity({0, -10}, {0, 200})), "ends free");
  refused(
      dxf(whole + lineEntity({200, 0}, {210, 0}) + lineEntity({210, 0}, {200, 10}) + lineEntity({200, 10}, {200, 0})),
      "not alone");
  refused(dxf(""), "holds no");
  refused(dxf(whole, group(9, "$INSUNITS") + group(70, "3")), "INSUNITS");
  std::string text = dxf(whole);
  refused(text.substr(0, text.size() / 2), "not a complete DXF");
  refused("just text", "not a complete DXF");
  const std::size_t at = text.find("40\n13\n");
  ASSERT_NE(at, std::string::npos);
  refused(std::string(text).replace(at, 6, "40\nthirteen\n"), "thirteen");
  refused(std::string(text).replace(at, 6, "40\nnan\n"), "nan");
}

TEST_F(Import, RefusesARailOnItsSide) {
  const std::string message = messageOf(import("a.dxf", dxf(shuffledEntities(*findSection("60E1"), {0, 0, 0.2}, 2))));
  EXPECT_NE(message.find("foot bottom"), std::string::npos) << message;
  EXPECT_FALSE(import("b.dxf", dxf(shuffledEntities(*findSection("60E1"), {0, 0, std::numbers::pi}, 2))));
}

std::string miniprof(const Section& section) {
  std::string text = "ProgramName=test\r\n";
  int i = 0;
  for (const NamedPrimitive& p : section.primitives) {
    text += "MPD" + std::to_string(++i) + "=";
    if (const auto* a = std::get_if<Arc>(&p.shape)) {
      double from = a->startAngleRad / kDegree, to = (a->startAngleRad + a->sweepRad) / kDegree;
      if (from > to) std::swap(from, to);
      text += "A " + number(a->centre.x()) + " " + number(a->centre.y()) + " " + number(a->radiusMm) + " " +
              number(from) + " " + number(to) + "\r\n";
    } else {
      text += "L " + number(startPoint(p.shape).x()) + " " + number(startPoint(p.shape).y()) + " " +
              number(endPoint(p.shape).x()) + " " + number(endPoint(p.shape).y()) + "\r\n";
    }
  }
  return text + "XYPoints=1\r\n\r\n0 0\r\n";
}

TEST_F(Import, MiniprofDesignOfAWholeRail) {
  const Section section = *findSection("54E1");
  const std::string text = miniprof(section);
  const auto read = import("a.ban", text);
  ASSERT_TRUE(read) << read.error().message();
  expectSame(*read, section);
  std::string bad = text;
  bad.replace(bad.find("MPD3=L"), 6, "MPD3=Q");
  const std::string message = messageOf(import("b.ban", bad));
  EXPECT_NE(message.find("b.ban:4: MPD3"), std::string::npos) << message;
}

TEST_F(Import, MiniprofHeadsAreOpenAndSayWhere) {
  const fs::path file = fs::path(VIGNOLE_SHARED_DATA) / "profiles" / "guard_rail_test.ban";
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not here";
  const std::string message = messageOf(importSection(file, "G"));
  EXPECT_NE(message.find("MPD1 ends free"), std::string::npos) << message;
  EXPECT_NE(message.find("MPD11"), std::string::npos) << message;
  EXPECT_FALSE(importSection(file.parent_path() / "MBench_UIC60_v3.ban", "G")) << "points, no design";
}

TEST_F(Import, JsonAndUnknownKinds) {
  const auto read = import("a.json", toJson(*findSection("60E2")));
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->name, "MINE");
  EXPECT_FALSE(import("a.step", "x"));
  EXPECT_FALSE(importSection(folder_ / "missing.dxf", "MINE"));
}

}  // namespace
}  // namespace vignole
