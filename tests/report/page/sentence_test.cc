#include "report/page/sentence.h"

#include <gtest/gtest.h>

namespace mixity {
namespace sentence_test {

TEST(Sentence, HasTheLettersOfFigures) {
  EXPECT_EQ(sentence("lambda = 0.05 +/- 0.01"), "λ = 0.05 ± 0.01");
  EXPECT_EQ(sentence("f = 1/(1 + (lambda-1) sin^2(psi))"), "f = 1/(1 + (λ-1) sin²(ψ))");
  EXPECT_EQ(sentence("along lambda_II, λ_III and G_Ic"), "along λ<sub>II</sub>, λ<sub>III</sub> and G<sub>Ic</sub>");
  EXPECT_EQ(sentence("ln(Gc/GIc)"), "ln(G<sub>c</sub>/G<sub>Ic</sub>)");
  EXPECT_EQ(sentence("A = A0 - alpha T^2, T = τ0 A"), "A = A<sub>0</sub> - α T², T = τ<sub>0</sub> A");
  EXPECT_EQ(sentence("√(S0² − λ T_u²)"), "√(S<sub>0</sub>² − λ T<sub>u</sub>²)");
  EXPECT_EQ(sentence("delta [um]"), "δ [um]");
}

TEST(Sentence, KeepsWhatATyperTypes) {
  EXPECT_EQ(sentence("--free=lambda; load_offset, free=lambda"), "--free=lambda; load_offset, free=lambda");
  EXPECT_EQ(sentence("as in radius = \"VALUE +/- ERROR\""), "as in radius = &quot;VALUE +/- ERROR&quot;");
  EXPECT_EQ(sentence("column 'psi'; sigma_T; lambda.csv"), "column 'psi'; sigma_T; lambda.csv");
  EXPECT_EQ(sentence("runs S_1, A_2, day_, 10^25"), "runs S_1, A_2, day_, 10^25");
  EXPECT_EQ(sentence("lambdas, tau_file, run_10, 100"), "lambdas, tau_file, run_10, 100");
}

TEST(Sentence, IsMarkup) { EXPECT_EQ(sentence("1 < 2 & <b>"), "1 &lt; 2 &amp; &lt;b&gt;"); }

}  // namespace sentence_test
}  // namespace mixity
