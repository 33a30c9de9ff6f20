#include "engine/files/toml_reader.h"

#include <gtest/gtest.h>

namespace vignole {
namespace {

TomlReader read(const std::string& text) {
  auto reader = TomlReader::parse("format = 1\n" + text, "test.toml");
  EXPECT_TRUE(reader) << (reader ? "" : reader.error().message());
  return std::move(*reader);
}

std::string errorOf(TomlReader& reader) {
  const auto done = reader.finish();
  return done ? "" : done.error().message();
}

TEST(TomlReader, ReadsEveryKindOfValue) {
  TomlReader r = read("a = 1.5\nb = 2\nc = true\nd = 'x'\ne = [1, 2.5]\nf = ['p', 'q']\n[t.u]\nv = 7\n[[s]]\nw = 1\n[[s]]\nw = 2\n");
  EXPECT_EQ(r.number("a", 0, 2), 1.5);
  EXPECT_EQ(r.number("b", 0, 2), 2.0) << "a whole number is a number";
  EXPECT_TRUE(r.boolean("c"));
  EXPECT_EQ(r.text("d"), "x");
  EXPECT_EQ(r.numbers("e", 2), (std::vector<double>{1, 2.5}));
  EXPECT_EQ(r.texts("f"), (std::vector<std::string>{"p", "q"}));
  EXPECT_EQ(r.integer("t.u.v", 0, 9), 7);
  EXPECT_EQ(r.keys("t"), std::vector<std::string>{"u"});
  ASSERT_EQ(r.size("s"), 2U);
  EXPECT_EQ(r.integer("s.0.w", 0, 9), 1);
  EXPECT_EQ(r.integer("s.1.w", 0, 9), 2);
  EXPECT_TRUE(r.has("t.u"));
  EXPECT_FALSE(r.has("nothing"));
  EXPECT_EQ(errorOf(r), "");
}

TEST(TomlReader, ReadsAListOfAnyLengthOneByOne) {
  TomlReader r = read("[[f]]\nlevels = [1, 2.5]\n[[f]]\nlevels = ['x', 'y', 'z']\n");
  ASSERT_EQ(r.size("f"), 2U);
  ASSERT_EQ(r.listSize("f.0.levels"), 2U);
  EXPECT_EQ(r.number("f.0.levels.1", 0, 9), 2.5);
  ASSERT_EQ(r.listSize("f.1.levels"), 3U);
  EXPECT_EQ(r.text("f.1.levels.2"), "z");
  EXPECT_EQ(errorOf(r), "");

  TomlReader wrong = read("levels = 3\n");
  EXPECT_EQ(wrong.listSize("levels"), 0U);
  EXPECT_NE(errorOf(wrong).find("a list in brackets"), std::string::npos);
  TomlReader element = read("levels = [1,\n 'x']\n");
  EXPECT_EQ(element.listSize("levels"), 2U);
  EXPECT_EQ(element.number("levels.1", 0, 9), 0);
  EXPECT_NE(errorOf(element).find("test.toml:3:"), std::string::npos);
}

TEST(TomlReader, FallbackStandsInForWhatIsMissing) {
  TomlReader r = read("");
  EXPECT_EQ(r.number("a", 0, 2, 1.0), 1.0);
  EXPECT_EQ(r.integer("b", 0, 2, 1), 1);
  EXPECT_TRUE(r.boolean("c", true));
  EXPECT_EQ(r.text("d", "x"), "x");
  EXPECT_EQ(r.size("s"), 0U);
  EXPECT_EQ(errorOf(r), "");
}

TEST(TomlReader, NamesFileLineKeyAndRemedy) {
  TomlReader r = read("[stripe]\nsigma = 400\n");
  EXPECT_EQ(r.number("stripe.sigma", 0.5, 20, 3.0), 3.0);
  const std::string e = errorOf(r);
  EXPECT_NE(e.find("test.toml:3:"), std::string::npos) << e;
  EXPECT_NE(e.find("stripe.sigma"), std::string::npos) << e;
  EXPECT_NE(e.find("400"), std::string::npos) << e;
  EXPECT_NE(e.find("0.5 to 20"), std::string::npos) << e;
}

TEST(TomlReader, RefusesWrongKindsMissingKeysAndNotNumbers) {
  for (const char* text : {"a = 'x'", "a = true", "a = nan", "a = inf", "a = [1]", "", "a = 1979-05-27"}) {
    TomlReader r = read(text);
    EXPECT_EQ(r.number("a", -1e300, 1e300), 0) << text;
    EXPECT_NE(errorOf(r), "") << text;
  }
  TomlReader whole = read("a = 1.5");
  EXPECT_EQ(whole.integer("a", 0, 9), 0);
  EXPECT_NE(errorOf(whole), "");
  TomlReader list = read("a = [1, 'x']");
  EXPECT_EQ(list.numbers("a", 2), (std::vector<double>{0, 0}));
  EXPECT_NE(errorOf(list), "");
  TomlReader count = read("a = [1, 2, 3]");
  EXPECT_EQ(count.numbers("a", 2).size(), 2U);
  EXPECT_NE(errorOf(count).find("list of 3"), std::string::npos);
  TomlReader flag = read("a = 1");
  EXPECT_FALSE(flag.boolean("a"));
  EXPECT_NE(errorOf(flag), "");
  TomlReader word = read("a = 1");
  EXPECT_EQ(word.text("a"), "");
  EXPECT_NE(errorOf(word), "");
}

TEST(TomlReader, TheFirstErrorWins) {
  TomlReader r = read("a = 'x'\nb = 'y'\nc = 3\n");
  EXPECT_EQ(r.number("b", 0, 1), 0);
  EXPECT_EQ(r.number("a", 0, 1), 0);
  EXPECT_EQ(r.number("c", 0, 9, 4.0), 4.0) << "after an error only fallbacks";
  EXPECT_NE(errorOf(r).find(": b: "), std::string::npos);
}

TEST(TomlReader, UnknownKeysAreRefusedWithASuggestion) {
  TomlReader r = read("[stripe]\nsigma = 3\nsigna = 4\n");
  EXPECT_EQ(r.number("stripe.sigma", 0, 9), 3);
  const std::string e = errorOf(r);
  EXPECT_NE(e.find("test.toml:4:"), std::string::npos) << e;
  EXPECT_NE(e.find("stripe.signa"), std::string::npos) << e;
  EXPECT_NE(e.find("did you mean stripe.sigma"), std::string::npos) << e;
}

TEST(TomlReader, UnknownTablesAndElementsAreRefused) {
  TomlReader table = read("[strype]\nsigma = 3\n");
  EXPECT_EQ(table.number("stripe.sigma", 0, 9, 3.0), 3);
  EXPECT_NE(errorOf(table).find(": strype: "), std::string::npos);
  TomlReader empty = read("[nobody]\n");
  EXPECT_NE(errorOf(empty), "");
  TomlReader element = read("[[s]]\nw = 1\n[[s]]\nw = 2\nz = 3\n");
  ASSERT_EQ(element.size("s"), 2U);
  EXPECT_EQ(element.integer("s.0.w", 0, 9) + element.integer("s.1.w", 0, 9), 3);
  EXPECT_NE(errorOf(element).find("s.1.z"), std::string::npos);
  TomlReader array = read("a = [1, 2]\n");
  EXPECT_NE(errorOf(array), "");
}

TEST(TomlReader, CallersMayRefuse) {
  TomlReader r = read("low = 2\nhigh = 1\n");
  const double low = r.number("low", 0, 9), high = r.number("high", 0, 9);
  if (low > high) r.refuse("high", "is below low");
  EXPECT_NE(errorOf(r).find("test.toml:3:"), std::string::npos);
}

TEST(TomlReader, FormatAndSyntax) {
  EXPECT_FALSE(TomlReader::parse("", "x"));
  EXPECT_FALSE(TomlReader::parse("format = 2", "x"));
  EXPECT_FALSE(TomlReader::parse("format = '1'", "x"));
  const auto broken = TomlReader::parse("format = 1\na = = 2\n", "broken.toml");
  ASSERT_FALSE(broken);
  EXPECT_NE(broken.error().message().find("broken.toml:2:"), std::string::npos) << broken.error().message();
  EXPECT_FALSE(TomlReader::parse("format = 1\na = 1\na = 2\n", "x")) << "a key twice";
  EXPECT_FALSE(TomlReader::parse("format = 1\na = '\xff'\n", "x")) << "not UTF-8";
  EXPECT_FALSE(TomlReader::load("/no/such/file.toml"));
}

}  // namespace
}  // namespace vignole
