#include "cli/options/option_values.h"
#include "cli/options/solver_choice.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace isl::cli {
namespace {

using testing::HasSubstr;

TEST(OptionValues, SizeIsTwoPositiveWholeNumbers) {
  EXPECT_EQ(parse_size("640x480").value(), (PictureSize{640, 480}));
  for (const char* bad : {"", "640", "640x", "x480", "0x480", "640x-1", "640x480x3", "1e3x2", "70000x10", " 640x480"}) {
    EXPECT_FALSE(parse_size(bad).ok()) << bad;
  }
  EXPECT_NE(parse_size("640*480").message().find("`640*480`"), std::string::npos) << "the message says what was found";
}

TEST(OptionValues, CropIsAWindowThatHoldsAPixel) {
  EXPECT_EQ(parse_crop("0,10,20,30").value(), (std::array{0, 10, 20, 30}));
  for (const char* bad : {"", "1,2,3", "1,2,3,4,5", "5,0,5,9", "0,9,5,9", "-1,0,5,5", "0,0,5,5,", "a,b,c,d"}) {
    EXPECT_FALSE(parse_crop(bad).ok()) << bad;
  }
}

TEST(OptionValues, SolverIsANameAndForThePaperACount) {
  using render::SolverName;
  EXPECT_EQ(parse_solver("hermite").value().name, SolverName::hermite);
  EXPECT_EQ(parse_solver("exact").value().name, SolverName::exact);
  EXPECT_EQ(parse_solver("paper").value().interpolants, 2);
  EXPECT_EQ(parse_solver("paper:5").value().name, SolverName::paper);
  EXPECT_EQ(parse_solver("paper:5").value().interpolants, 5);
  EXPECT_EQ(parse_solver("iso").value().name, SolverName::iso);
  for (const char* bad :
       {"", "Hermite", "paper:", "paper:0", "paper:1000", "paper:2x", "hermite:2", "exact:", "iso:2"}) {
    EXPECT_FALSE(parse_solver(bad).ok()) << bad;
  }
}

TEST(OptionValues, SwitchesOfThePublishedSolverStandBehindItsName) {
  const auto switches_of = [](const char* text) { return parse_solver(text).value().paper; };
  EXPECT_EQ(switches_of("paper"), render::PaperSwitches{});
  EXPECT_EQ(switches_of("paper:2,plain"), render::kPlainPaper);
  for (const render::PaperSwitch& s : render::kPaperSwitches) {
    EXPECT_TRUE(switches_of(fmt::format("paper:4,plain,{}", s.on).c_str()).*s.is_on) << s.on;
    EXPECT_FALSE(switches_of(fmt::format("iso,{}", s.off).c_str()).*s.is_on) << s.off;
    EXPECT_TRUE(switches_of(fmt::format("paper,{},{}", s.off, s.on).c_str()).*s.is_on) << "the later one wins";
  }
  EXPECT_TRUE(switches_of("paper,eq10").reject);
  EXPECT_FALSE(switches_of("paper,reject,plain").reject);
}

TEST(OptionValues, RivalsHaveTheirNumberBehindAColon) {
  const SolverChoice march = parse_solver("march:0.5px").value();
  EXPECT_EQ(march.name, render::SolverName::march);
  EXPECT_EQ(march.step, (render::Tolerance{0.5, true}));
  EXPECT_EQ(parse_solver("climb:1e-3").value().step, (render::Tolerance{1e-3, false}));
  EXPECT_EQ(parse_solver("march").value().step, (render::Tolerance{1, true}));
  EXPECT_EQ(parse_solver("sphere:1.6").value().relaxation, 1.6);
  EXPECT_EQ(parse_solver("sphere").value().relaxation, 1);
  EXPECT_TRUE(parse_solver("hermite:single").value().single);
  EXPECT_FALSE(parse_solver("hermite").value().single);
  EXPECT_TRUE(parse_solver("exact:digits").value().digits);
  EXPECT_FALSE(parse_solver("exact:single").value().digits);
  for (const char* text : {"hermite:single", "exact:single", "hermite:digits", "exact:digits", "lg", "lg:octree",
                           "interval", "segment", "inclusion", "sphere", "sphere:1.25", "march:2px", "climb:0.001"}) {
    EXPECT_EQ(to_text(parse_solver(text).value()), text);
  }
  for (const char* bad : {"march:", "march:0", "march:-1px", "climb:px", "sphere:2", "sphere:0.9", "sphere:x", "lg:1",
                          "hermite:1", "interval:", "segment:1.5", "inclusion,plain"}) {
    EXPECT_FALSE(parse_solver(bad).ok()) << bad;
  }
  EXPECT_THAT(parse_solver("march:0").message(), HasSubstr("expected a STEP above zero"));
  EXPECT_THAT(parse_solver("sphere:3").message(), HasSubstr("OMEGA at least 1 and below 2, found `sphere:3`"));
}

TEST(OptionValues, AMisspeltSolverOrSwitchIsToldWhatIsNear) {
  const auto complaint = [](const char* text) { return parse_solver(text).message(); };
  EXPECT_THAT(complaint("hermit"), HasSubstr("unknown solver `hermit`; did you mean `hermite`?"));
  EXPECT_THAT(complaint("newton"), HasSubstr("unknown solver `newton`; the solvers are hermite"));
  EXPECT_THAT(complaint("paper,rejct"), HasSubstr("unknown switch `rejct` of the solver; did you mean `reject`?"));
  EXPECT_THAT(complaint("paper,no-pool"), HasSubstr("did you mean `no-pools`?"));
  EXPECT_THAT(complaint("iso,x"), HasSubstr("plain on-demand reject monotone reuse permanent|volatile pools eq10"));
  for (const char* bad : {"paper,", "paper,,reject", "paper,reject,"}) {
    EXPECT_THAT(complaint(bad), HasSubstr("unknown switch ``")) << bad;
  }
  EXPECT_THAT(complaint("hermite,plain"), HasSubstr("the solver hermite takes no switches, found `,plain`"));
}

TEST(OptionValues, ToleranceIsInPixelsOrInSceneUnits) {
  const render::Tolerance pixels = parse_tolerance("0.05px").value();
  EXPECT_EQ(pixels.value, 0.05);
  EXPECT_TRUE(pixels.in_pixels);
  const render::Tolerance units = parse_tolerance("1e-4").value();
  EXPECT_EQ(units.value, 1e-4);
  EXPECT_FALSE(units.in_pixels);
  for (const char* bad : {"", "px", "0", "0px", "-1", "nan", "inf", "1e999", "1 px", "5%"}) {
    EXPECT_FALSE(parse_tolerance(bad).ok()) << bad;
  }
}

TEST(OptionValues, ToleranceAndSolverReadBackFromTheirText) {
  for (const char* text : {"0.05px", "1e-9", "2"}) {
    const render::Tolerance first = parse_tolerance(text).value();
    const render::Tolerance again = parse_tolerance(to_text(first)).value();
    EXPECT_EQ(first.value, again.value);
    EXPECT_EQ(first.in_pixels, again.in_pixels);
  }
  EXPECT_EQ(to_text(parse_solver("paper").value()), "paper:2");
  EXPECT_EQ(to_text(parse_solver("exact").value()), "exact");
  EXPECT_EQ(to_text(parse_solver("paper:3,plain,reject").value()), "paper:3,plain,reject");
  EXPECT_EQ(to_text(parse_solver("iso,eq10,volatile,reject").value()), "iso,volatile,eq10");
  for (const char* text : {"hermite", "exact", "iso", "iso,plain", "paper:7,no-pools", "paper:2,plain,pools,eq10"}) {
    const SolverChoice choice = parse_solver(text).value();
    EXPECT_EQ(parse_solver(to_text(choice)).value(), choice) << text;
  }
}

TEST(OptionValues, DefineIsANumberWhereItReadsAsOne) {
  EXPECT_EQ(std::get<double>(parse_define("Levels=4").value().second), 4);
  EXPECT_EQ(std::get<double>(parse_define("A=-1.5e2").value().second), -150);
  EXPECT_EQ(std::get<std::string>(parse_define("Kernel=quartic").value().second), "quartic");
  EXPECT_EQ(std::get<std::string>(parse_define("Kernel=\"7\"").value().second), "7")
      << "quotes make a string of a number";
  EXPECT_EQ(std::get<std::string>(parse_define("Empty=").value().second), "");
  EXPECT_EQ(std::get<std::string>(parse_define("Formula=a=b").value().second), "a=b");
  for (const char* bad : {"", "Levels", "=4", "4=4", "a b=1", "a-b=1"}) EXPECT_FALSE(parse_define(bad).ok()) << bad;
}

TEST(OptionValues, MemoryIsBytesOrAShareOfTheMachine) {
  EXPECT_EQ(parse_memory("512M").value(), std::size_t{512} << 20);
  EXPECT_EQ(parse_memory("1.5K").value(), 1536u);
  EXPECT_EQ(parse_memory("1000").value(), 1000u);
  const std::size_t whole = parse_memory("100%").value();
  EXPECT_NEAR(static_cast<double>(parse_memory("50%").value()), static_cast<double>(whole) / 2, 1);
  for (const char* bad : {"", "M", "%", "0", "-1G", "1T", "1e30"}) EXPECT_FALSE(parse_memory(bad).ok()) << bad;
  EXPECT_EQ(parse_bytes("64K").value(), 65536u);
  for (const char* bad : {"", "M", "75%", "0", "-1G", "1T", "1e30"}) EXPECT_FALSE(parse_bytes(bad).ok()) << bad;
}

TEST(OptionValues, NumbersOutOfRangeAreToldTheirRange) {
  EXPECT_EQ(parse_integer("7", 0, 11).value(), 7);
  EXPECT_NE(parse_integer("12", 0, 11).message().find("from 0 to 11, found 12"), std::string::npos);
  EXPECT_NE(parse_integer("many", 0, 11).message().find("`many`"), std::string::npos);
  EXPECT_FALSE(parse_integer("99999999999999999999", 0, 11).ok());
  EXPECT_FALSE(parse_number("-0.1", 0, 1).ok());
  EXPECT_EQ(parse_number("0.25", 0, 1).value(), 0.25);
}

}  // namespace
}  // namespace isl::cli
