// The same message as the program, Python and the page word it.
#include <gtest/gtest.h>

#include "base/message.h"
#include "cli/flag_words.h"
#include "explorer/field_words.h"
#include "python/keyword_words.h"

namespace mixity {
namespace words_of_doors_test {

struct Worded {
  Message message;
  const char *flags, *keywords, *fields, *neutral;
};

TEST(WordsOfDoors, AreFlagsKeywordsAndFields) {
  const Worded all[] = {
      {"check it, or " + Remedy::set("free", "modulus"), "check it, or --free=modulus", "check it, or free=\"modulus\"",
       "check it, or “Fit modulus too”", "check it, or free = \"modulus\""},
      {Remedy::set("decimal", ",") + " or " + Remedy::set("decimal", "."), "--decimal=\",\" or --decimal=\".\"",
       "decimal=\",\" or decimal=\".\"", "“Read , as the decimal sign” or “Read . as the decimal sign”",
       "decimal = \",\" or decimal = \".\""},
      {Remedy::set("columns", "P=1 (mN),T=2 (N)"), "--columns=\"P=1 (mN),T=2 (N)\"",
       "columns={\"P\": \"1 (mN)\", \"T\": \"2 (N)\"}", "write P=1 (mN),T=2 (N) under “Take other columns”",
       "columns = \"P=1 (mN),T=2 (N)\""},
      {Remedy::set("units", "P=mN,T=N"), "--units=\"P=mN,T=N\"", "units={\"P\": \"mN\", \"T\": \"N\"}",
       "units=\"P=mN,T=N\" in the program", "units = \"P=mN,T=N\""},
      {"by " + Remedy::set_or_key("load", "5 mN"), "by --load=\"5 mN\", or the key load",
       "by load=\"5 mN\", or the key load", "by \"5 mN\" under “More of the file”", "by load = \"5 mN\""},
      {"needs radius" + Remedy::state({"radius"}, "a.toml"),
       "needs radius: state it in a.toml or by a flag (--radius=...)",
       "needs radius: state it in a.toml, or here: radius=...", "needs radius", "needs radius: state it in a.toml"},
      {"needs both" + Remedy::state({"radius", "modulus"}, ""),
       "needs both: state them in  or by flags (--radius=..., --modulus=...)",
       "needs both: state them: radius=..., modulus=...", "needs both", "needs both: state them"},
      {Remedy::given("radius") + "is 0", "--radius: is 0", "radius: is 0", "is 0", "radius: is 0"},
      {"with " + Remedy::set("weighted", "true"), "with --weighted", "with weighted=True",
       "with weighted=\"true\" under “More of the fit”", "with weighted = \"true\""},
      {"all with " + Remedy::set("format", "json"), "all with --format=json", "all with to_dict()",
       "all with format=\"json\" in the program", "all with format = \"json\""},
      {"give " + Remedy::fill_in("loads"), "give --loads=...", "give loads=...", "give loads=\"...\" in the program",
       "give loads = ..."},
      {"fit it with " + Remedy{Remedy::Kind::set, {{"objective", "curve"}, {"free", "toughness"}}},
       "fit it with --objective=curve --free=toughness", "fit it with objective=\"curve\", free=\"toughness\"",
       "fit it with “Fit with the objective curve”, “Fit toughness too”",
       "fit it with objective = \"curve\", free = \"toughness\""},
  };
  for (const Worded& one : all) {
    EXPECT_EQ(one.message.text(cli::in_flags), one.flags);
    EXPECT_EQ(one.message.text(in_keywords), one.keywords);
    EXPECT_EQ(one.message.text(explorer::in_fields), one.fields);
    EXPECT_EQ(one.message.text(), one.neutral);
  }
}

}  // namespace words_of_doors_test
}  // namespace mixity
