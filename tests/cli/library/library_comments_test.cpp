#include "cli/library/library_comments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isl::cli {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> names_of(const std::vector<LibraryEntry>& entries) {
  std::vector<std::string> names;
  for (const LibraryEntry& entry : entries) names.push_back(entry.name);
  return names;
}

TEST(LibraryComments, OfAMacroAreItsTextAndItsExample) {
  const std::vector<LibraryEntry> entries = library_entries("shapes",
                                                            "// Wall(From, To)\n"
                                                            "// A wall.\n"
                                                            "// From, To: its ends.\n"
                                                            "// Example: union {\n"
                                                            "//     Wall(0, x)\n"
                                                            "//   }\n"
                                                            "#macro Wall(From, To)\n  box { From, To }\n#end\n");
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].name, "Wall");
  EXPECT_EQ(entries[0].kind, "macro");
  EXPECT_THAT(entries[0].parameters, ElementsAre("From", "To"));
  EXPECT_THAT(entries[0].text, ElementsAre("A wall.", "From, To: its ends."));
  EXPECT_THAT(entries[0].example, ElementsAre("union {", "  Wall(0, x)", "}"));
  EXPECT_EQ(entries[0].line, 7u);
}

TEST(LibraryComments, OfADeclarationAreItsKindAndItsText) {
  const std::vector<LibraryEntry> entries = library_entries("stones",
                                                            "// Slate: texture. Dark grey,\n"
                                                            "// in layers.\n"
                                                            "#declare Slate = texture { pigment { rgb 0.2 } }\n");
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].name, "Slate");
  EXPECT_EQ(entries[0].kind, "texture");
  EXPECT_THAT(entries[0].text, ElementsAre("Dark grey,", "in layers."));
  EXPECT_THAT(entries[0].parameters, IsEmpty());
  EXPECT_THAT(entries[0].example, IsEmpty());
  EXPECT_EQ(entries[0].line, 3u);
}

TEST(LibraryComments, InAnotherFormAreNotListed) {
  EXPECT_THAT(library_entries("a",
                              "#macro None() #end\n"
                              "// A comment, but no head.\n// Example: Headless()\n#macro Headless() #end\n"
                              "// NoExample()\n// Text.\n#macro NoExample() #end\n"
                              "// Renamed(A)\n// Example: Renamed(1)\n#macro Renamed(B) #end\n"
                              "// Far: number. Not directly before it.\n\n#declare Far = 1;\n"
                              "// Kindless: what it is.\n#declare Kindless = 1;\n"
                              "// Longer: number. Of another name.\n#declare Long = 1;\n"
                              "// Bare: number. Without a directive.\n"),
              IsEmpty());
}

TEST(LibraryComments, OfNamesThatServeTheFileAloneAreNotListed) {
  const std::string text =
      "// Curves_Isl_Root: number. For this file.\n#declare Curves_Isl_Root = 2;\n"
      "// Curves_Count: number. For all.\n#declare Curves_Count = 2;\n";
  EXPECT_THAT(names_of(library_entries("curves", text)), ElementsAre("Curves_Count"));
  EXPECT_THAT(names_of(library_entries("stones", text)), ElementsAre("Curves_Isl_Root", "Curves_Count"));
}

TEST(LibraryComments, OfAMacroWithoutParametersAndAtTheEndOfAFileAreRead) {
  const std::vector<LibraryEntry> entries =
      library_entries("a", "// Sun()\n// Light.\n// Example: Sun()\n#macro Sun ( ) light_source { 9, 1 } #end");
  EXPECT_THAT(entries, IsEmpty()) << "the head has the brackets as the macro has them";
  EXPECT_THAT(names_of(library_entries("a", "// Sun()\n// Example: Sun()\n#macro Sun () #end")), ElementsAre("Sun"));
}

TEST(LibraryComments, AtTheBeginningOfAFileKeepTheirIndentation) {
  const std::string text =
      "// Limbs and more. They bend.\n// Often.\n//\n//   Limb()\n//\n#declare A = 1;\n// Later.\n";
  EXPECT_THAT(head_comment(text), ElementsAre("Limbs and more. They bend.", "Often.", "", "  Limb()"));
  EXPECT_THAT(head_comment("#declare A = 1;\n// Later.\n"), IsEmpty());
  EXPECT_THAT(head_comment(""), IsEmpty());
}

TEST(LibraryComments, BeginWithASentence) {
  EXPECT_EQ(first_sentence({"Limbs and", "more. They bend."}), "Limbs and more.");
  EXPECT_EQ(first_sentence({"No end", "", "Another paragraph."}), "No end");
  EXPECT_EQ(first_sentence({}), "");
}

}  // namespace
}  // namespace isl::cli
