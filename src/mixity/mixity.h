// mixity in one header: mode-mixity models of soft adhesive contacts fitted to areas under shear.
//
//   #include <mixity/mixity.h>
//   mixity::Dataset data = mixity::load_dataset("run.csv", {{"radius", "9.42 mm"}});
//   mixity::FitResult fit = mixity::fit_model(data, "c");
//   fit.status, fit.parameters[0].value, fit.parameters[0].interval, fit.budget, fit.residuals
//
// It includes nothing of what the library is built with. InputError is thrown for what a file, an array or an option
// says that cannot be; what can fail for a right question has a status or a reason.
#pragma once

#include "base/input_error.h"         // InputError
#include "dataset/arrays.h"           // make_dataset: of arrays
#include "dataset/dataset.h"          // load_dataset, Dataset
#include "dataset/pooled.h"           // load_pooled: of several files
#include "fitting/comparison.h"       // compare_models, per_curve
#include "fitting/fit.h"              // fit_model, FitOptions, FitResult
#include "fitting/prediction.h"       // predict_areas_of: areas of a fit, with their errors
#include "mechanics/contact.h"        // Contact: units of dimensionless quantities; JKR, Hertz
#include "mechanics/contact_model.h"  // ContactModel: areas, folds, regime, curve, f(psi)
#include "mechanics/measurement.h"    // phase angle and toughness of a measured point
