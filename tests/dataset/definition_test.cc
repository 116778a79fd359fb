// Definitions of data state what was understood, to the last bit.
#include "dataset/definition.h"

#include <gtest/gtest.h>

#include "dataset/load_text.h"

namespace mixity {
namespace definition_test {

/// What a definition of these metadata states when it is read back.
Metadata read_back(const Metadata& metadata, std::map<std::string, std::string> mapping = {}) {
  const TemporaryFolder folder;
  const std::string path = folder.path("lab.toml");
  folder.write("lab.toml", definition_text({{"a.csv", metadata, std::move(mapping), {}}}, path));
  return read_metadata(path);
}

TEST(Definition, StatesEachFieldSoThatItIsReadBackToTheLastBit) {
  // thirds have no short text in any unit
  const std::map<std::string_view, std::string_view> texts{{"provenance", "measured"},
                                                           {"decimal", ","},
                                                           {"sheet", "Run \"2\""},
                                                           {"load_from", "run_{P}mN"},
                                                           {"table", "2"},
                                                           {"mode_III", "averaged"},
                                                           {"control", "approach"},
                                                           {"normal_stiffness", "1.2 kN/m"},
                                                           {"poisson_ratio", "0.3333333333333333"}};
  for (const MetadataField& field : metadata_fields()) {
    if (field.is_path || field.name == "columns" || field.name == "load" || field.name == "title" ||
        field.name == "source" || field.name == "note")
      continue;
    for (const char* error : {"", " +/- 3.3333333333333335%"}) {
      Metadata metadata;
      const auto known = texts.find(field.name);
      std::string text(known == texts.end() ? field.example : known->second);
      if (known == texts.end() && text.find("+/-") == std::string::npos) text += field.of_experiment ? error : "";
      ASSERT_EQ(set_field(metadata, field.name, text), "") << field.name;
      const Metadata again = read_back(metadata);
      EXPECT_EQ(stated_text(again, field.name), stated_text(metadata, field.name));
      if (field.number) {
        EXPECT_EQ(again.*field.number, metadata.*field.number) << field.name << " " << text;
        EXPECT_EQ(again.standard_error(field.name), metadata.standard_error(field.name)) << field.name << " " << text;
      }
    }
  }
}

TEST(Definition, HasNeitherLoadNorTitleNorSourceNorNoteOfAFile) {
  Metadata metadata;
  for (const char* name : {"title", "source", "note"}) set_field(metadata, name, "of one file");
  set_field(metadata, "load", "4.68 mN");
  const Metadata again = read_back(metadata, {{"P", "Kanal 3 (mN)"}});
  EXPECT_EQ(again.title + again.source + again.note, "");
  EXPECT_FALSE(again.load);
  EXPECT_EQ(again.columns, (std::map<std::string, std::string>{{"P", "Kanal 3 (mN)"}}));
}

TEST(Definition, NamesFilesFromItsOwnFolder) {
  const TemporaryFolder folder;
  const std::string names = folder.write("names.toml", "");
  Metadata metadata;
  metadata.headings = names;
  const std::string path = folder.path("sub/lab.toml"), text = definition_text({{"a.csv", metadata}}, path);
  EXPECT_NE(text.find("headings = '../names.toml'"), std::string::npos) << text;
}

TEST(Definition, MapsColumnsByNumberWhereAHeadingWouldNotBeUnderstood) {
  const std::string constants = "radius = \"9 mm\"\nmodulus = \"2 MPa\"\ntoughness = \"27 mJ/m^2\"\n",
                    rows = "1,0,0.3\n1,1,0.29\n";
  const auto mapping = [&](const std::string& headings, const std::string& columns) {
    return load_text(headings + "\n" + rows, constants + "columns = \"" + columns + "\"\n").mapping;
  };
  using Mapping = std::map<std::string, std::string>;
  EXPECT_EQ(mapping("F [mN],F [mN],A [mm^2]", "P=1,T=2"),
            (Mapping{{"P", "1 (mN)"}, {"T", "2 (mN)"}, {"A", "A [mm^2]"}}));
  EXPECT_EQ(mapping("x=1,y,A [mm^2]", "P=1 (mN),T=y (mN)"),
            (Mapping{{"P", "1 (mN)"}, {"T", "y (mN)"}, {"A", "A [mm^2]"}}));
}

}  // namespace definition_test
}  // namespace mixity
