// The syntax of POV-Ray's .ini files, and the options that they become. Each form was tried in POV-Ray 3.7 first.
#include "cli/options/ini_file.h"
#include "cli/options/ini_options.h"
#include "tests/support/source_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isl::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> settings(std::string_view text, std::string_view section = "") {
  std::vector<std::string> result;
  for (const IniSetting& setting : read_ini(text, section).settings) {
    result.push_back(fmt::format("{}{}={}", setting.on ? "" : "-", setting.key, setting.value));
  }
  return result;
}

std::string remarks_of(const std::vector<IniRemark>& remarks) {
  std::string text;
  for (const IniRemark& remark : remarks) text += remark.message + " | " + remark.hint + "\n";
  return text;
}

TEST(IniFile, HasKeysInAnyCaseCommentsAndQuotes) {
  EXPECT_THAT(settings("Width = \"40\" ; c\nHEIGHT=30 # c2\r\n\n; all comment\n  Input_File_Name='a b.pov'"),
              ElementsAre("width=40", "height=30", "input_file_name=a b.pov"));
  EXPECT_THAT(settings("Declare=S=\"a ; b\""), ElementsAre("declare=S=\"a ; b\""));
  EXPECT_THAT(settings("Library_Path=/my files/inc ; c"), ElementsAre("library_path=/my files/inc"));
  EXPECT_THAT(settings("\xEF\xBB\xBFWidth=4\rHeight=3"), ElementsAre("width=4", "height=3"));
}

TEST(IniFile, HasSwitchesAndSeveralSettingsInALine) {
  EXPECT_THAT(settings("+W640 +H480 -A +L\"a b\" Declare=N=5\nWidth=40 Height=30 +kff20"),
              ElementsAre("width=640", "height=480", "-antialias_threshold=", "library_path=a b", "declare=N=5",
                          "width=40", "height=30", "final_frame=20"));
}

TEST(IniFile, HasSections) {
  const std::string_view text = "Width=1\n[big]\nWidth=2\n[Small] ; c\nWidth=3\n[big]\nHeight=4";
  EXPECT_THAT(settings(text), ElementsAre("width=1"));
  EXPECT_THAT(settings(text, "BIG"), ElementsAre("width=1", "width=2", "height=4"));
  EXPECT_THAT(settings(text, "small"), ElementsAre("width=1", "width=3"));
  EXPECT_EQ(remarks_of(read_ini(text, "none").remarks), "there is no section [none] | it has [big], [Small], [big]\n");
  EXPECT_EQ(remarks_of(read_ini("[a]\nnonsense", "").remarks), "") << "another section's mistakes wait for their turn";
}

TEST(IniFile, MistakesAreToldWithTheirPlace) {
  const IniSettings read = read_ini("Width=1\nWidht=2\nnonsense\n[a\n", "");
  EXPECT_EQ(remarks_of(read.remarks),
            "POV-Ray has no setting `Widht` | did you mean `width`?\n"
            "expected `Key=value`, found `nonsense` | a comment begins with `;`\n"
            "expected `]` at the end of the section's name | \n");
  EXPECT_EQ(read.remarks[0].begin, 8u);
  EXPECT_EQ(read.remarks[0].end, 13u);
}

/// Any existing file in the place of a scene; it is not read here.
constexpr const char* kScene = ISL_SOURCE_DIR "/tests/cli/options/ini_file_test.cpp";

struct Translated {
  SceneOptions scene;
  PictureOptions picture;
  [[nodiscard]] std::string remarks() const { return remarks_of(scene.ini->remarks); }
};

/// The translated settings, with a scene that exists.
Translated translated(std::string text, const std::string& said = "", Translated options = {}) {
  apply_ini(
      {"x.ini", ""}, fmt::format("Input_File_Name={}\n{}", kScene, text),
      [&](const std::string& option) { return option == said; }, options.scene, options.picture);
  return options;
}

TEST(IniOptions, AreOursWithTheSameMeaning) {
  const Translated result = translated(
      "Width=64\nHeight=48\nAntialias=On\nAntialias_Threshold=0.2\nQuality=4\nOutput_Alpha=yes\nWork_Threads=3\n"
      "Library_Path=inc\nDeclare=N=5\nClock=0.5\nOutput_File_Name=out.png\n");
  EXPECT_EQ(result.remarks(), "");
  EXPECT_EQ(result.scene.scene, kScene);
  EXPECT_EQ(result.scene.size, (PictureSize{64, 48}));
  EXPECT_EQ(result.picture.aa_threshold, 0.2);
  EXPECT_EQ(result.picture.quality, 4);
  EXPECT_TRUE(result.picture.alpha);
  EXPECT_EQ(result.picture.threads, 3);
  EXPECT_THAT(result.scene.include_paths, ElementsAre("inc"));
  EXPECT_EQ(result.scene.defines, (std::vector<Define>{{"N", 5.0}}));
  EXPECT_EQ(result.scene.clock, 0.5);
  EXPECT_TRUE(result.scene.clock_on);
  EXPECT_THAT(result.picture.outputs, ElementsAre("out.png"));
}

TEST(IniOptions, GiveWayToTheCommandLine) {
  Translated said;
  said.scene.size = {8, 6};
  said.scene.include_paths = {"mine"};
  said.scene.defines = {{"N", 1.0}};
  said.picture.outputs = {"mine.png"};
  said.picture.aa_threshold = 0.05;
  EXPECT_EQ(translated("Width=64\n", "--size", said).scene.size, (PictureSize{8, 6}));
  EXPECT_EQ(translated("Antialias=off\n", "--aa", said).picture.samples, std::nullopt);
  EXPECT_THAT(translated("Output_File_Name=a.png\n", "", said).picture.outputs, ElementsAre("mine.png"));
  EXPECT_THAT(translated("Library_Path=a\n", "", said).scene.include_paths, ElementsAre("mine", "a"));
  EXPECT_EQ(translated("Declare=N=5\n", "", said).scene.defines, (std::vector<Define>{{"N", 5.0}, {"N", 1.0}}))
      << "the later of two settings of one name counts";
}

TEST(IniOptions, SwitchAntialiasingAsPovRayDoes) {
  EXPECT_EQ(translated("Antialias=off\nAntialias_Threshold=0.2").picture.samples, 1);
  EXPECT_EQ(translated("-A").picture.samples, 1);
  EXPECT_EQ(translated("+A0.4").picture.aa_threshold, 0.4);
  EXPECT_EQ(translated("Antialias=on").picture.aa_threshold, 0.3);
  EXPECT_EQ(translated("").picture.aa_threshold, PictureOptions{}.aa_threshold);
}

TEST(IniOptions, NameThePictureAsPovRayDoes) {
  const auto outputs = [](const std::string& text) { return translated(text).picture.outputs; };
  EXPECT_THAT(outputs("Output_File_Name=foo\nOutput_File_Type=P"), ElementsAre("foo.ppm"));
  EXPECT_THAT(outputs("Output_File_Name=foo.bar\nOutput_File_Type=J90"), ElementsAre("foo.bar.jpg"));
  EXPECT_THAT(outputs("Output_File_Name=foo.tga\nOutput_File_Type=N"), ElementsAre("foo.tga.png"));
  EXPECT_THAT(outputs("Output_File_Name=foo.exr"), ElementsAre("foo.exr"));
  EXPECT_THAT(outputs("Output_File_Name=out/"), ElementsAre("out/ini_file_test.png"));
  EXPECT_THAT(outputs("Output_File_Type=E"), ElementsAre("ini_file_test.exr"));
  EXPECT_THAT(outputs("Output_File_Type=P\nOutput_File_Name=-"), ElementsAre("ppm:-")) << "standard output";
  EXPECT_THAT(outputs("Output_File_Type=N"), ElementsAre()) << "the default";
}

TEST(IniOptions, ChooseTheBitsOfPng) {
  EXPECT_EQ(translated("Bits_Per_Color=8").picture.bits, 8);
  EXPECT_EQ(translated("Output_File_Type=N12").picture.bits, 16);
  EXPECT_EQ(translated("Output_File_Type=J\nBits_Per_Color=8").picture.bits, 0);
  EXPECT_EQ(translated("Bits_Per_Color=8", "--bits").picture.bits, 0);
}

TEST(IniOptions, RenderTheFirstFrameOfAnAnimation) {
  const Translated result = translated(
      "Initial_Frame=1\nFinal_Frame=12\nInitial_Clock=2\nFinal_Clock=5\nSubset_Start_Frame=3\nOutput_File_Name=s.png");
  EXPECT_EQ(result.remarks(), "frame 3 of 1 to 12 is rendered | `--frame N` renders another\n");
  EXPECT_EQ(result.scene.frame, 3);
  EXPECT_NEAR(result.scene.clock, 2.54545, 1e-5);
  EXPECT_THAT(result.picture.outputs, ElementsAre("s03.png"));
  EXPECT_EQ(result.scene.defines[1], (Define{"final_frame", 12.0}));
  const Translated cyclic = translated("Final_Frame=4\nCyclic_Animation=on\nSubset_Start_Frame=2");
  EXPECT_EQ(cyclic.scene.clock, 0.25);
  EXPECT_EQ(cyclic.scene.defines[1], (Define{"final_frame", 5.0})) << "so does POV-Ray";
}

TEST(IniOptions, RenderTheFrameThatIsAskedFor) {
  Translated asked;
  asked.scene.frame = 7;
  const std::string text = "Final_Frame=10\nInitial_Clock=0\nFinal_Clock=9\n";
  const Translated result = translated(text, "--frame", asked);
  EXPECT_EQ(result.remarks(), "");
  EXPECT_EQ(result.scene.clock, 6);
  asked.scene.frame = 11;
  EXPECT_THAT(translated(text, "--frame", asked).remarks(), HasSubstr("expected one of the frames 1 to 10, found 11"));
}

TEST(IniOptions, CropAsPovRayDoes) {
  const auto crop = [](const std::string& text) {
    return translated("Width=40\nHeight=40\n" + text).picture.crop.value_or(std::array{-1, -1, -1, -1});
  };
  EXPECT_EQ(crop("Start_Column=10\nEnd_Column=20"), (std::array{9, 0, 20, 40}));
  EXPECT_EQ(crop("Start_Column=0.3\nEnd_Row=0.25"), (std::array{12, 0, 40, 10}));
  EXPECT_EQ(crop("Start_Column=1\nEnd_Column=1"), (std::array{0, 0, 40, 40}));
  EXPECT_THAT(translated("Width=40\nHeight=40\nStart_Row=30\nEnd_Row=20").remarks(),
              HasSubstr("is empty or reaches beyond"));
  EXPECT_THAT(translated("Width=40\nHeight=40\nEnd_Row=41").remarks(),
              HasSubstr("is empty or reaches beyond the picture of 40x40 pixels"));
}

TEST(IniOptions, WithoutCounterpartAreNamed) {
  const Translated result = translated("Jitter=on\nDisplay=off\n+R3\nOutput_File_Type=T");
  EXPECT_EQ(result.remarks(),
            "`jitter` has no counterpart here; it is ignored | \n`display` has no counterpart here; it is ignored | \n"
            "`antialias_depth` has no counterpart here; it is ignored | \n"
            "isl cannot write files of type `T`; it writes a PNG | \n");
}

TEST(IniOptions, OfVersion38AreKnown) {
  const Translated result =
      translated("Antialias_Confidence=0.95\nStochastic_Seed=7\nSampling_Method=3\n+AC0.9\nDither_Method=BN\n");
  EXPECT_EQ(result.remarks(),
            "`antialias_confidence` has no counterpart here; it is ignored | \n"
            "`stochastic_seed` has no counterpart here; it is ignored | \n"
            "`sampling_method` has no counterpart here; it is ignored | \n"
            "`antialias_confidence` has no counterpart here; it is ignored | \n"
            "`dither_method` has no counterpart here; it is ignored | \n");
  const Translated grey = translated("Output_File_Type=Ng16");
  EXPECT_EQ(grey.remarks(), "pictures are written in colour, not in shades of grey | \n");
  EXPECT_EQ(grey.picture.bits, 16);
}

TEST(IniOptions, ThatReadBadlyAreErrors) {
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {"Width=abc", "`width`: expected a whole number, found `abc`"},
           {"Height=0", "`height`: expected a whole number from 1 to 65536, found 0"},
           {"Antialias=maybe", "`antialias`: expected on or off, found `maybe`"},
           {"Declare=5", "`declare`: expected NAME=VALUE, found `5`"},
           {"Quality=12", "`quality`: expected a whole number from 0 to 11, found 12"}}) {
    const Translated result = translated(text);
    EXPECT_THAT(result.remarks(), HasSubstr(message));
    EXPECT_EQ(result.scene.ini->remarks[0].severity, Severity::error) << text;
  }
}

TEST(IniName, MayHaveASection) {
  EXPECT_EQ(ini_name("a.ini")->file, "a.ini");
  EXPECT_EQ(ini_name("d/A.INI[Low res]")->file, "d/A.INI");
  EXPECT_EQ(ini_name("d/A.INI[Low res]")->section, "Low res");
  EXPECT_FALSE(ini_name("a.pov[b]"));
  EXPECT_FALSE(ini_name("-"));
}

}  // namespace
}  // namespace isl::cli
