#include "prs/record/record.h"
#include "prs/losses/slip_analysis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "prs/loads/load_analysis.h"
#include "prs/record/record_table.h"
#include "prs/run/analyses.h"
#include "prs/run/document_schema.h"
#include "prs/study/response.h"
#include "support/sample_result.h"
#include "support/sample_slip.h"

namespace prs {

namespace sample {

struct Inner {
  double angle = 0.5;
  std::vector<double> loads;
};

struct Outer {
  std::optional<double> length;
  Inner inner;
  std::optional<Inner> absent;
  bool good = true;
  int count = 3;
  std::string text = "a";
};

constexpr Quantity<Inner> kInner[] = {
    {"angle", of<&Inner::angle>, "takes the unit of the key above"},
    {"loads_N", of<&Inner::loads>, "one per thread"},
};

constexpr Quantity<Outer> kOuter[] = {
    {"length_mm", of<&Outer::length>, "a length", "a paper", "how long"},
    {"inner_deg", of<&Outer::inner>},
    {"absent", of<&Outer::absent>},
    {"good", of<&Outer::good>},
    {"count", of<&Outer::count>},
    {"text", of<&Outer::text, [](const Outer& o) { return o.good; }>},
    {"", of<[](const Outer& o) -> const Inner& { return o.inner; }>},
};

/// Values under keys, and objects without a type of their own.
struct Mapped {
  ByKey<double> numbers;
  ByKey<Inner> records;
  std::vector<std::size_t> counts;
  std::vector<Inner> items;
  double share_percent = 30.0;

  std::string_view note = {};
};

constexpr Quantity<Inner> kItem[] = {
    {"angle_deg", always<&Inner::angle>},
};

constexpr Quantity<Mapped> kPart[] = {
    {"counts", always<&Mapped::counts>},
    {"note", filled<&Mapped::note>},
};

constexpr Quantity<Mapped> kMapped[] = {
    {"lengths_mm", always<&Mapped::numbers>},
    {"records", of<&Mapped::records>},
    {"items", always_table<kItem, &Mapped::items>},
    {"part", of_table<kPart>},
    as_shown<Mapped>({"share_percent", of<&Mapped::share_percent>}),
    {"", of_table<kPart>},
};

}  // namespace sample

Record<sample::Mapped> record_of(Type<sample::Mapped>) { return {"Mapped", "Of a test.", sample::kMapped}; }

Record<sample::Inner> record_of(Type<sample::Inner>) { return {"Inner", "Of a test.", sample::kInner}; }
Record<sample::Outer> record_of(Type<sample::Outer>) { return {"Outer", "Of a test.", sample::kOuter}; }

namespace {

using sample::Inner;
using sample::Outer;

const Outer kSample{0.002, {0.5, {1.0, 4.0}}, {}, true, 3, "a"};

TEST(Record, DocumentHasWhatIsDefinedInTheUnitOfItsKey) {
  const auto json = object_of(kSample);
  EXPECT_EQ(json.at("length_mm"), 2.0);
  EXPECT_DOUBLE_EQ(json.at("inner_deg").at("angle"), 0.5 * 180.0 / std::numbers::pi);
  EXPECT_EQ(json.at("inner_deg").at("loads_N"), nlohmann::ordered_json({1.0, 4.0}));
  EXPECT_FALSE(json.contains("absent"));
  EXPECT_EQ(json.at("good"), true);
  EXPECT_EQ(json.at("count"), 3);
  EXPECT_EQ(json.at("text"), "a");
  EXPECT_EQ(json.at("angle"), 0.5);  // The record without a key has it.
}

TEST(Record, WhatIsNotFiniteOrGuardedIsAbsent) {
  Outer outer = kSample;
  outer.length = std::numeric_limits<double>::infinity();
  outer.good = false;
  const auto json = object_of(outer);
  EXPECT_FALSE(json.contains("length_mm"));
  EXPECT_FALSE(json.contains("text"));
}

TEST(Record, ReaderAgreesWithTheDocument) {
  const auto read = [](std::string_view path) {
    const auto reader = reader_of<Outer>(path);
    return reader ? reader->read(kSample) : std::nullopt;
  };
  EXPECT_EQ(read("length_mm"), 2.0);
  EXPECT_DOUBLE_EQ(*read("inner_deg.angle"), 0.5 * 180.0 / std::numbers::pi);
  EXPECT_EQ(read("inner_deg.loads_N.max"), 4.0);
  EXPECT_EQ(read("inner_deg.loads_N.mean"), 2.5);
  EXPECT_EQ(read("inner_deg.loads_N[0]"), 1.0);
  EXPECT_EQ(read("loads_N.min"), 1.0);
  for (const char* path : {"inner_deg.loads_N[2]", "absent.angle", "length_mm.max", "text", "inner_deg",
                           "inner_deg.loads_N", "length", "loads_N[1", "loads_N[1]x"})
    EXPECT_FALSE(read(path)) << path;
}

TEST(Record, RowsAreDescribedWithThoseOfRecordsWithoutKey) {
  const RecordInfo& info = describe<Outer>();
  ASSERT_EQ(info.quantities.size(), 8);
  EXPECT_EQ(info.quantities[0].title, "how long");
  EXPECT_EQ(info.quantities[0].unit, "mm");
  EXPECT_EQ(info.quantities[1].kind, Kind::record);
  EXPECT_EQ(info.quantities[1].record().name, "Inner");
  EXPECT_EQ(info.quantities[1].title, "inner");
  EXPECT_EQ(info.quantities[7].kind, Kind::series);
}

TEST(Record, ValuesByKeyAndTablesStandWhereTheyAreDescribed) {
  const sample::Mapped mapped{{{"b", 0.002}, {"a", 0.001}, {"c", std::numeric_limits<double>::quiet_NaN()}},
                              {{"x", {0.5, {1.0}}}},
                              {4, 5},
                              {{std::numbers::pi, {}}}};
  EXPECT_EQ(object_of(mapped).dump(),
            R"({"lengths_mm":{"b":2.0,"a":1.0},"records":{"x":{"angle":0.5,"loads_N":[1.0]}},)"
            R"("items":[{"angle_deg":180.0}],"part":{"counts":[4,5]},"share_percent":30.0,)"
            R"("counts":[4,5]})");
  EXPECT_FALSE(reader_of<sample::Mapped>("part.counts.max"));

  const std::vector<QuantityInfo>& rows = describe<sample::Mapped>().quantities;
  ASSERT_EQ(rows.size(), 7);
  EXPECT_TRUE(rows[0].form.by_key && rows[0].form.required && rows[0].kind == Kind::number);
  EXPECT_TRUE(rows[1].form.by_key && !rows[1].form.required && rows[1].kind == Kind::record);
  EXPECT_TRUE(rows[2].form.required && rows[2].kind == Kind::records);
  EXPECT_TRUE(rows[2].record().name.empty() && rows[2].record().quantities[0].form.required);
  EXPECT_TRUE(rows[5].form.whole && !rows[5].form.required);
}

/// Every number that documents show as a response equals the one that studies read without them.
TEST(Record, ResponsesWithoutADocumentAreThoseOfTheDocument) {
  LoadCaseResult load_case = test::solved_case("a", 45e3, Direction::tension);
  load_case.slip = test::sample_slip(load_case);
  Result result;
  result.load_cases = {load_case};
  const auto document = document_of(slip_analysis(), result, {});
  std::size_t read = 0;
  for (const std::string& path : response_paths(document)) {
    const std::optional<ResultNumber> number = result_number(path);
    if (!number) continue;
    ++read;
    EXPECT_EQ(number->value({result.contacts, &result.load_cases[0]}), response(document, path)) << path;
  }
  EXPECT_GT(read, 60);
}

TEST(ResultsSchema, SaysEveryQuantityWithAMeaning) {
  const auto schema = results_schema();
  const auto& records = schema.at("records");
  for (const auto& [name, record] : records.items())
    for (const auto& q : record.at("quantities")) {
      EXPECT_TRUE(!q.contains("record") || records.contains(q.at("record"))) << q;
      const bool needs_none = name.starts_with("Per") || name == "Threads";
      EXPECT_TRUE(needs_none || q.contains("meaning")) << name << q;
    }
}

TEST(ResultsSchema, SaysTheClassAndThePlacesOfEveryAnalysis) {
  const auto schema = results_schema();
  std::set<std::string> classes;
  for (const auto& analysis : schema.at("analyses")) {
    EXPECT_FALSE(analysis.at("help").empty());
    EXPECT_TRUE(classes.insert(analysis.at("class")).second) << analysis;
  }
  EXPECT_EQ(classes.size(), analyses().size() + other_files().size());
  EXPECT_TRUE(classes.contains("SolveResult") && classes.contains("OptimizationResult"));
  const auto& slip = schema.at("analyses").at(4);
  EXPECT_EQ(slip.at("name"), "slip");
  EXPECT_THAT(slip.at("places"), testing::Contains("load_cases[].slip"));
}

}  // namespace
}  // namespace prs
