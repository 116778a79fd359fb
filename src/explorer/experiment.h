// A data set and its fit for the page, in the units of the file.
#pragma once

#include <string>

#include "analysis/answer.h"
#include "analysis/result.h"
#include "report/json.h"

namespace mixity::explorer {

/// How a file was read: {"reading", "taken": ["P from 'Normalkraft'"], "ignored", "notes", "excluded_count",
/// "excluded": [{"where", "reason"}], "constants": {"radius": {"exact": "0.00942 m", "shown": "9.42 mm"}}, "notice"
/// (for reconstructed data), "units": {"force", "area"}, "runs": [{"name", "P", "lines", "T", "A", "axes": [a/b], where
/// the axes of ellipses were measured}]}; without loads "energies": {"lines", "psi", "f"} in place of runs. Lines are
/// counted through all "files": [{"name", "first_line"}], which is empty for one file. Of pull-off loads also
/// "pull_off":
/// {"points": [[T or u, P, line]], "held": "T" or "u", "unit"}.
Json as_read(const Dataset& data);

/// {"result", "model", "interval", "doubt", "budget": [[name, part]], "jumps": [[text]], "cannot_say"}, as at the
/// beginning of a report.
Json as_told(const Answer& answer, const Dataset& data);

/// What can be tried where a fit has a message with remedies, the best model first: [{"model", "text", "buttons"}].
Json as_advised(const Analysis& result);

/// The parameters of each fit as a report shows them: {"c": ["λ = 0.0200 ± 0.0012"]}.
Json as_listed(const Analysis& result);

/// {"contact": {"radius": m, "modulus": Pa, "toughness": J/m^2, "mN": the file's unit of force in mN, "mm2": that of
/// area}, "models": [{"model", "runs": [{"P", "curve": [[T, A]],
/// "unstable", "band": [[T, low, high]], "folds": [[T, A]], "axes": [[T, a/b]] of ellipses}], "toughness": [[psi, f]],
/// "residuals": [[run, T, or psi, model minus data, line]], "residual_unit", "pull_off": [[T or u, P]]}]}, beginning
/// with the model that describes the data best. Bands are of one standard error.
Json as_drawn(const Analysis& result);

}  // namespace mixity::explorer
