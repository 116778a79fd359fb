#include "report/figures/paper_figures.h"

namespace mixity {
namespace {

const std::string kA = "a, Johnson: f = 1 + (1 − λ) tan²ψ", kB = "b, Waters & Guduru: f = 1 + tan²[(1 − λ/2) ψ]",
                  kC = "c: f = 1/(1 + (λ − 1) sin²ψ)";
const std::string kEquilibrium = "y² + T² = 8π a³ f(ψ), y = 4/3 a³ − P, tan ψ = T/y",
                  kCircle = "(y − 3π)² + τ² = S0², S0² = 9π² + 6π P, of every model; c: T = τ/√λ";
const std::string kJump = "T_T = √(3π (3π + 2P)/λ), A_T = π (3/4)^(2/3) (3π + P)^(2/3)";
const std::string kJohnson = "Model a is of Johnson (1996); the paper's text has 1966.";
const std::string kEightNinths =
    "The paper says that model a jumps at λ = 1 only. At P = 0 its curve folds, and the contact jumps, for every λ > "
    "8/9.";
const std::string kOwnEquations =
    "In the paper the curves of models a and b follow the equations of c; here each follows its own.";

std::string of_model(char key) { return key == 'a' ? kA : key == 'b' ? kB : kC; }

}  // namespace

PaperNotes paper_notes(const std::string& name) {
  if (name == "fig3") return {{kA, kB, kC}, {kJohnson}};
  if (name == "fig7")
    return {{kA, kB, kC, "Points: f = (y² + T²)/(8π a³), y = 4/3 a³ − P, tan ψ = T/y, a = √(A/π)"}, {kJohnson}};
  if (name == "fig9")
    return {{kB, kC, "Points: f = G_c/G_Ic as measured"},
            {"λ of model b is twice the parameter that Waters & Guduru give (0.15)."}};
  if (name.starts_with("fig4"))
    return {{kEquilibrium, of_model(name.back()), "JKR: T = 0, y² = 8π a³", "Hertz: y = 0, a³ = 3P/4",
             "Stable where P rises with a at constant T"},
            name.back() == 'a' ? std::vector{kJohnson} : std::vector<std::string>{}};
  if (name == "fig5")
    return {{kEquilibrium, kA, kB, kC, "1, a: for T → ∞, y → (1 − λ) (3π + √(9π² + 6π P/(1 − λ)))",
             "2, b: y = 0 at T_H = √(6π P)/sin(πλ/4), where P > P_c = (3π/2)/(k cos(πλ/4))², k = 1 − λ/2",
             "3, c: " + kJump, "4: T = τ0 A"},
            {kEightNinths,
             "Model b is not smooth at every load: below P_c it jumps, as c does; the paper does not give that load."}};
  if (name.starts_with("fig6"))
    return {
        {kEquilibrium, kA, kB, kC, kCircle, "u = 3T/(4a)",
         "Jump under load control, c: " + kJump + ", u_T = 3/4 T_T/a_T",
         "Jump under displacement control, c: T_u = ½ √(3/2 [9π² + 6π P − 3P² + √(3 (3π + P)² (3π² + 2π P + 3P²))]/λ)",
         "u_u = (3/4)^(2/3) T_u/(3π + P − √(S0² − λ T_u²))^(1/3)",
         "A_u = π (3/4)^(2/3) (3π + P − √(S0² − λ T_u²))^(2/3)"},
        {"The paper prints u_u and A_u with + √(S0² − λ T_u²). The fold under displacement control lies on the minus "
         "branch: du = 0 asks for 2v² + 3 (3π + P) v + S0² = 0 with v = y − 3π, and both of its roots are negative. "
         "T_u is printed rightly.",
         kOwnEquations, kEightNinths}};
  if (name.starts_with("fig8")) {
    PaperNotes notes{{kEquilibrium, of_model(name.back()), "T = τ0 A, τ0 = 0.43 MPa; circles: ψ = 3π/8"}, {}};
    if (name.back() == 'c') notes.equations.push_back("Locus of the jump: A_T(T_T), with " + kJump);
    if (name.back() == 'a') notes.print = {kJohnson, kEightNinths};
    return notes;
  }
  if (name == "fig10") return {{kEquilibrium, kB, kC}, {}};
  return {};
}

}  // namespace mixity
