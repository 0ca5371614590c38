#include "RasterFile.h"
#include "TextFiles.h"

#include "bathymetry/Settings.h"
#include "bathymetry/TextFile.h"

#include <gmock/gmock.h>

#include <chrono>
#include <cmath>

using namespace swellray;
using namespace swellray::test;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

std::vector<double> allNumbers(const std::string& text)
{
  NumberScanner scanner(text);
  std::vector<double> values;
  double value = 0.0;
  while (scanner.next(value))
  {
    values.push_back(value);
  }
  return values;
}

}

TEST(TextFile, NumbersAsFortranWritesThem)
{
  EXPECT_THAT(allNumbers(" 1, -2.5\t+3e2\n4.D+01 5d-1,,3*0.25\r\n.5 6."),
    ElementsAre(1.0, -2.5, 300.0, 40.0, 0.5, 0.25, 0.25, 0.25, 0.5, 6.0));
  EXPECT_TRUE(allNumbers("").empty());
  EXPECT_TRUE(allNumbers(" \n , \n").empty());
  EXPECT_EQ(allNumbers("1e999").front(), HUGE_VAL);
  EXPECT_EQ(allNumbers("-1e-999").front(), 0.0);
  EXPECT_TRUE(std::isnan(allNumbers("nan").front()));
}

TEST(TextFile, WordsThatAreNoNumbersAreNamedWithTheirLine)
{
  for (const std::string word :
    { "deep", "1.5.2", "--1", "+-1", "1e", "2*", "0*1", "-3*1", "1*2*3", "1d", "12m", "1,x" })
  {
    EXPECT_THAT(failureOf([&] { allNumbers("1\n2\n" + word); }), HasSubstr("line 3: '")) << word;
  }
  EXPECT_THAT(failureOf([] { allNumbers(std::string(100000, '1')); }), HasSubstr("is no number"));
  EXPECT_EQ(failureOf([] { allNumbers("\x1b[31m\xff"); }), "line 1: '?[31m?' is no number");
}

TEST(TextFile, ALineIsLeftWhereItsRestIsNotWanted)
{
  NumberScanner scanner("1 2 3\n4 5 6\n7 8 9\n");
  double value = 0.0;
  scanner.startLine();
  scanner.next(value);
  EXPECT_EQ(value, 1.0) << "nothing of the line was read yet";
  scanner.startLine();
  scanner.next(value);
  EXPECT_EQ(value, 4.0);
  scanner.skipLines(1);
  scanner.next(value);
  EXPECT_EQ(value, 7.0);
}

TEST(TextFile, AClaimedSizeTakesNoMemory)
{
  const auto read = [](std::size_t columns, std::size_t rows)
  {
    return failureOf(
      [=]
      {
        NumberScanner scanner("1 2 3 4 5");
        readNodes(scanner, columns, rows, false, "depth");
      });
  };
  EXPECT_EQ(read(10000, 10000), "it ends after 5 of 100000000 values of depth (10000 x 10000)");
  EXPECT_THAT(read(1000000000, 1000000000), HasSubstr("the limit is 100 million"));
  EXPECT_THAT(read(SIZE_MAX, SIZE_MAX), HasSubstr("the limit is 100 million"));
  EXPECT_THAT(read(0, 5), HasSubstr("cannot be read"));
}

TEST(TextFile, MatrixHasEqualRows)
{
  const Matrix matrix = readMatrix("# remark\n1 2 3\n\n% other\n4,5,6\n");
  EXPECT_EQ(matrix.columns, 3u);
  EXPECT_EQ(matrix.rows, 2u);
  EXPECT_THAT(matrix.values, ElementsAre(1.0, 2.0, 3.0, 4.0, 5.0, 6.0));
  EXPECT_EQ(failureOf([] { readMatrix("1 2 3\n4 5\n"); }), "line 2 has 2 numbers, the first has 3");
  EXPECT_EQ(failureOf([] { readMatrix("\n\n"); }), "it holds no numbers");
  EXPECT_EQ(failureOf([] { readMatrix("1 2\n3 deep\n"); }), "line 2 holds a word that is no number");
}

TEST(TextFile, BinaryMissingAndOverlongFilesAreRefusedAtOnce)
{
  const Folder files;
  EXPECT_THAT(failureOf([&] { readTextFile(files.file("none.bot")); }), HasSubstr("missing: no such file"));
  EXPECT_THAT(failureOf([&] { readTextFile(files.file("")); }), HasSubstr("not a file"));
  writeText(files.file("binary.bot"), std::string("1 2 3\0 4", 8));
  EXPECT_THAT(failureOf([&] { readTextFile(files.file("binary.bot")); }), HasSubstr("is no text: byte 6 is zero"));
  {
    // 2 GB long, of which only the last byte is on disk.
    std::ofstream stream(files.file("long.bot"), std::ios::binary);
    stream.seekp(2000000000);
    stream << '1';
  }
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THAT(failureOf([&] { readTextFile(files.file("long.bot")); }), HasSubstr("longer than 1000 million bytes"));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

TEST(Settings, NamelistsAndParameters)
{
  const Settings settings("&grid\n  x0 = 1.5D2,\n  DEP = \"a, b.dep\",\n  name = 'grid' ! remark\n/\n% posdwn = 5\n"
                          "# nx = 7\n  posdwn   = -1\nFilcco = #x y.grd#\nnonsense\nposdwn=0\r\n = 3\n");
  EXPECT_EQ(settings.number("x0"), 150.0);
  EXPECT_EQ(settings.word("dep"), "a, b.dep");
  EXPECT_EQ(settings.word("name"), "grid");
  EXPECT_EQ(settings.word("filcco"), "x y.grd");
  EXPECT_EQ(settings.number("posdwn"), 0.0) << "the last counts";
  EXPECT_FALSE(settings.has("nx"));
  EXPECT_EQ(settings.number("nx", 3.0), 3.0);
  EXPECT_EQ(failureOf([&] { settings.number("nx"); }), "it does not set nx");
  EXPECT_EQ(failureOf([&] { settings.number("name"); }), "its setting name = grid is no number");
}
