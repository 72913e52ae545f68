// A study's table as comma-separated values.
#include <gtest/gtest.h>

#include <limits>

#include "tools/store/study_csv.h"

namespace hyrax {
namespace {

TEST(CsvText, HeadsNameTheirUnits) {
  const StudyTable table{"t",
                         "",
                         {{"speed", "px/s", "", std::vector<double>{}},
                          {"energy", "px2/s2", "", std::vector<double>{}},
                          {"order", "1", "", std::vector<double>{}},
                          {"method", "", "", std::vector<std::string>{}}}};
  EXPECT_EQ(csv_text(table), "speed_px_per_s,energy_px2_per_s2,order,method\n");
}

TEST(CsvText, NumbersAreShortestRoundTripAndWhatDoesNotExistIsEmpty) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const StudyTable table{"t",
                         "",
                         {{"a", "s", "", std::vector<double>{0.1, nan, infinity}},
                          {"n", "1", "", std::vector<std::int64_t>{-7, 0, 1'000'000'000'000}}}};
  EXPECT_EQ(csv_text(table), "a_s,n\n0.1,-7\n,0\ninf,1000000000000\n");
}

TEST(CsvText, TextIsQuotedWhereItMustBe) {
  const StudyTable table{
      "t", "", {{"words", "", "", std::vector<std::string>{"plain", "a, b", "the \"step\"", "two\nlines"}}}};
  EXPECT_EQ(csv_text(table), "words\nplain\n\"a, b\"\n\"the \"\"step\"\"\"\n\"two\nlines\"\n");
}

}  // namespace
}  // namespace hyrax
