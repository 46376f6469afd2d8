#include "registry/cases.h"

#include "base/error.h"
#include "structure/source_files.h"

#include <string>

#include <gtest/gtest.h>

using orbs::registry::load_case;
using orbs::registry::load_cases;
using orbs::structure::TestFolder;

namespace {

std::string case_text(
    const std::string& more,
    const std::string& scenes = R"([{"name": "1", "file": "1.json"}, {"name": "2", "file": "2.json"}])",
    const std::string& requirement = "M2") {
  return R"({"format": "orbs-case/2", "requirement": ")" + requirement +
         R"(", "title": "t", "tests": "t", "typical_mistake": "m",
"scenes": )" +
         scenes + more + "}";
}

std::string message_of(const std::string& text) {
  const TestFolder scratch("registry-case");
  scratch.write("m2/1.json", "{}");
  scratch.write("m2/2.json", "{}");
  scratch.write("m2/case.json", text);
  try {
    load_case(scratch.path() / "m2" / "case.json");
  } catch (const orbs::InputError& e) {
    const std::string what = e.what();
    const auto begin = what.find("case.json");
    return what.substr(begin, what.find('\n', begin) - begin);
  }
  return "no error";
}

// A folder of cases, each with the scenes of `case_text`.
class SuiteOfTwo {
 public:
  SuiteOfTwo(const std::string& first, const std::string& second) : scratch_("registry-suite") {
    for (const char* file : {"a/1.json", "a/2.json", "b/1.json", "b/2.json"}) scratch_.write(file, "{}");
    scratch_.write("a/case.json", first);
    scratch_.write("b/case.json", second);
  }
  orbs::registry::Suite suite() const { return {"s", scratch_.path(), scratch_.path() / "references"}; }

 private:
  TestFolder scratch_;
};

std::string suite_message(const SuiteOfTwo& folders) {
  try {
    load_cases(folders.suite());
  } catch (const orbs::InputError& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace

TEST(Cases, TheGatesAreThoseOfAllCasesUnlessTheCaseOverridesThem) {
  const TestFolder scratch("registry-gate");
  scratch.write("m2/1.json", "{}");
  const auto scene = R"([{"name": "1", "file": "1.json", "spp": 7}])";
  scratch.write("m2/case.json", case_text("", scene));
  const auto usual = load_case(scratch.path() / "m2" / "case.json");
  ASSERT_EQ(usual.gates.size(), 11U);
  EXPECT_EQ(usual.gates[0].metric, "psnr_srgb8");
  EXPECT_EQ(usual.gates[0].min, 35);
  EXPECT_EQ(usual.gates[0].max, std::nullopt);
  EXPECT_EQ(usual.gates[2].metric, "mean_ratio_g");
  EXPECT_EQ(usual.gates[2].min, -0.007);
  EXPECT_EQ(usual.gates[5].max, 0.2);
  EXPECT_EQ(usual.name, "m2");
  EXPECT_EQ(usual.scenes[0].spp, 7);
  scratch.write("m2/case.json", case_text(R"(, "gates": [{"metric": "local_bias", "max": 0.5, "reason": "r"},
    {"metric": "flip", "max": 0.1, "reason": "s"}])",
                                          scene));
  const auto own = load_case(scratch.path() / "m2" / "case.json");
  ASSERT_EQ(own.gates.size(), 12U);
  EXPECT_EQ(own.gates[0].min, 35);
  EXPECT_EQ(own.gates[4].metric, "local_bias");
  EXPECT_EQ(own.gates[4].max, 0.5);
  EXPECT_EQ(own.gates[4].reason, "r");
  EXPECT_EQ(own.gates[11].metric, "flip");
  EXPECT_TRUE(own.gates[11].place.ends_with("case.json:3")) << own.gates[6].place;
}

TEST(Cases, AGateHasALimitAReasonAndAMetricOfItsOwn) {
  const auto message = [](const std::string& gates) {
    return message_of(case_text(R"(, "gates": [)" + gates + "]"));
  };
  EXPECT_EQ(message(R"({"metric": "l1", "max": 1, "reason": "r"})"), "no error");
  EXPECT_NE(message(R"({"metric": "l1", "reason": "r"})").find("/gates/0: a gate needs 'min' or 'max'"),
            std::string::npos);
  EXPECT_NE(message(R"({"metric": "l1", "max": 1})").find("key 'reason' is missing"), std::string::npos);
  EXPECT_NE(message(R"({"metric": "l1", "max": 1, "reason": ""})").find("/gates/0/reason: must say why"),
            std::string::npos);
  EXPECT_NE(message(R"({"metric": "l1", "min": 2, "max": 1, "reason": "r"})")
                .find("/gates/0/max: must not be below 'min', which is 2"),
            std::string::npos);
  EXPECT_NE(message(R"({"metric": "l1", "min": 2, "reason": "r"}, {"metric": "l1", "max": 3, "reason": "r"})")
                .find("/gates/1/metric: 'l1' has an earlier gate in this case"),
            std::string::npos);
}

TEST(Cases, MistakesAreNamedWithTheirPlace) {
  EXPECT_NE(message_of(case_text("", R"([{"name": "1", "file": "3.json"}])"))
                .find("/scenes/0/file: there is no file"),
            std::string::npos);
  EXPECT_NE(message_of(case_text("", R"([{"name": "1", "file": "1.json"}, {"name": "1", "file": "2.json"}])"))
                .find("/scenes/1/name: '1' is the name of an earlier image"),
            std::string::npos);
  EXPECT_NE(message_of(case_text("", "[]")).find("/scenes: must hold at least one scene"), std::string::npos);
  EXPECT_NE(message_of(case_text(R"(, "masks": [{"scene": "3", "rectangles": [[0,0,1,1]], "reason": "r"}])"))
                .find("/masks/0/scene: no image of this case is called '3'"),
            std::string::npos);
  EXPECT_NE(message_of(case_text(R"(, "masks": [{"scene": "1", "rectangles": [[4,0,4,1]], "reason": "r"}])"))
                .find("holds no pixel"),
            std::string::npos);
  EXPECT_NE(message_of(case_text(R"(, "masks": [{"scene": "1", "rectangles": [[4,0,1]], "reason": "r"}])"))
                .find("/masks/0/rectangles/0: must be an array of 4 numbers"),
            std::string::npos);
  EXPECT_NE(message_of(case_text(R"(, "masks": [{"scene": "1", "rectangles": [[0,0,1,1]], "reason": ""}])"))
                .find("must say why"),
            std::string::npos);
  EXPECT_NE(message_of(case_text(R"(, "differences": [{"name": "d", "of": "1", "minus": "1"}])"))
                .find("is the same scene as 'of'"),
            std::string::npos);
  EXPECT_NE(message_of(case_text(R"(, "path_shares": [{"scene": "1", "class": "EDXL", "min_share": 0.1}])"))
                .find("'EDXL' is no path class"),
            std::string::npos);
  EXPECT_EQ(
      message_of(case_text(R"(, "path_shares": [{"scene": "1", "class": "EDSSL-T", "min_share": 0.1}])")),
      "no error");
  EXPECT_NE(message_of(case_text(R"(, "condition_map": {"max": 0.1, "reason": ""})"))
                .find("/condition_map/reason: must say how the limit was found"),
            std::string::npos);
  EXPECT_NE(
      message_of(case_text(R"(, "condition_map": {"max": -1, "reason": "r"})")).find("/condition_map/max"),
      std::string::npos);
  EXPECT_NE(message_of(case_text("", "[]", "2M")).find("/requirement: '2M' is no requirement"),
            std::string::npos);
}

TEST(Cases, ARequirementThatDoesNotExistIsRefused) {
  for (const char* wrong : {"M11", "Z9", "G6", "E7", "S8"}) {
    const auto message = message_of(case_text("", R"([{"name": "1", "file": "1.json"}])", wrong));
    EXPECT_NE(
        message.find(
            std::string("/requirement: there is no requirement ") + wrong +
            "; there are G1 to G5, M1 to M8, L1 to L4, A1 to A4, B1 to B9, C1 to C5, D1 to D6, E1 to E6, N1 to N6, V1, S1 to S7, T1 to T3, I1 to I2"),
        std::string::npos)
        << message;
  }
}

TEST(Cases, AFolderWithoutItsCaseIsNamedAndHiddenOnesAreNotLookedAt) {
  const TestFolder scratch("registry-folders");
  scratch.write("a/1.json", "{}");
  scratch.write("a/2.json", "{}");
  scratch.write("a/case.json", case_text(""));
  scratch.write(".git/config", "");
  EXPECT_EQ(load_cases({"s", scratch.path(), scratch.path()}).size(), 1U);
  scratch.write("notes/read.me", "");
  try {
    load_cases({"s", scratch.path(), scratch.path()});
    ADD_FAILURE();
  } catch (const orbs::InputError& e) {
    EXPECT_NE(std::string(e.what()).find("notes: is a folder of suite 's' without case.json"),
              std::string::npos)
        << e.what();
  }
}

TEST(Cases, ALinkThatLeadsNowhereIsNoFolderOfTheSuite) {
  const TestFolder scratch("registry-links");
  scratch.write("a/1.json", "{}");
  scratch.write("a/2.json", "{}");
  scratch.write("a/case.json", case_text(""));
  std::filesystem::create_symlink("loop", scratch.path() / "loop");
  EXPECT_EQ(load_cases({"s", scratch.path(), scratch.path()}).size(), 1U);
}

TEST(Cases, ASceneFileThatIsNoFileIsCalledWhatItIs) {
  const TestFolder scratch("registry-no-file");
  scratch.write("m2/1.json/inside", "");
  std::filesystem::create_symlink("2.json", scratch.path() / "m2/2.json");
  const auto text_of = [&](const std::string& file) {
    scratch.write("m2/case.json", case_text("", R"([{"name": "1", "file": ")" + file + R"("}])"));
    try {
      load_case(scratch.path() / "m2/case.json");
    } catch (const orbs::InputError& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  EXPECT_NE(text_of("1.json").find("1.json is a folder, expected a file"), std::string::npos)
      << text_of("1.json");
  EXPECT_NE(text_of("2.json").find("2.json is a symbolic link that leads nowhere"), std::string::npos)
      << text_of("2.json");
}

TEST(Cases, StandInTheOrderOfTheSpecification) {
  const SuiteOfTwo folders(case_text("", R"([{"name": "1", "file": "1.json"}])", "L1"),
                           case_text("", R"([{"name": "2", "file": "2.json"}])", "M3"));
  const auto cases = load_cases(folders.suite());
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_EQ(cases[0].requirement, "M3");
}

TEST(Cases, TwoCasesMayShareASceneButNotAName) {
  const auto shared = R"([{"name": "1", "file": "../a/1.json"}])";
  EXPECT_EQ(suite_message(SuiteOfTwo(case_text("", shared), case_text("", shared))), "no error");
  const auto other = R"([{"name": "1", "file": "1.json"}])";
  EXPECT_NE(suite_message(SuiteOfTwo(case_text("", shared), case_text("", other))).find("use another name"),
            std::string::npos);
}

TEST(Cases, ASceneMayBeJudgedByTheReferenceOfAnotherCase) {
  const auto own = case_text("", R"([{"name": "1", "file": "1.json"}])");
  const auto other = case_text("", R"([{"name": "2", "file": "2.json", "reference": "1"}])");
  const auto cases = load_cases(SuiteOfTwo(own, other).suite());
  EXPECT_EQ(orbs::registry::reference_name(cases[0].scenes[0]), "1");
  EXPECT_EQ(orbs::registry::reference_name(cases[1].scenes[0]), "1");
}

TEST(Cases, AReferenceMustBeThatOfASceneWhichHasOne) {
  const auto own = case_text("", R"([{"name": "one", "file": "1.json"}])");
  const auto typo = case_text("", R"([{"name": "2", "file": "2.json", "reference": "oen"}])");
  EXPECT_NE(suite_message(SuiteOfTwo(own, typo)).find("reference of 'oen', but the suite has no scene"),
            std::string::npos)
      << suite_message(SuiteOfTwo(own, typo));
  EXPECT_NE(suite_message(SuiteOfTwo(own, typo)).find("did you mean 'one'?"), std::string::npos);
  const auto chain = case_text("", R"([{"name": "1", "file": "1.json", "reference": "2"},
 {"name": "2", "file": "2.json", "reference": "one"}])");
  EXPECT_NE(suite_message(SuiteOfTwo(own, chain)).find("scene '1' is to be judged by the reference of '2'"),
            std::string::npos);
  EXPECT_NE(message_of(case_text("", R"([{"name": "1", "file": "1.json", "reference": "1"}])"))
                .find("/scenes/0/reference: is the scene itself"),
            std::string::npos);
}

TEST(Cases, OneSceneHasOneReferenceInAllCases) {
  const auto first = case_text("", R"([{"name": "1", "file": "1.json"}, {"name": "2", "file": "2.json"}])");
  const auto second = case_text("", R"([{"name": "1", "file": "../a/1.json", "reference": "2"}])");
  EXPECT_NE(
      suite_message(SuiteOfTwo(first, second)).find("judged by the reference of '2', but by that of '1'"),
      std::string::npos)
      << suite_message(SuiteOfTwo(first, second));
}

TEST(Cases, ADifferenceMayNotHaveTheNameOfASceneOfAnotherCase) {
  const auto message =
      suite_message(SuiteOfTwo(case_text(R"(, "differences": [{"name": "3", "of": "1", "minus": "2"}])"),
                               case_text("", R"([{"name": "3", "file": "1.json"}])")));
  EXPECT_NE(message.find("difference '3' has the name of a scene"), std::string::npos) << message;
}

TEST(Cases, AFolderWithoutCasesIsAnError) {
  const TestFolder scratch("registry-empty");
  EXPECT_THROW(load_cases({"s", scratch.path(), scratch.path()}), orbs::InputError);
  EXPECT_THROW(load_cases({"s", scratch.path() / "absent", scratch.path()}), orbs::InputError);
}
