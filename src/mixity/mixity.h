/// @mainpage Models of mode mixity, fitted to areas of soft adhesive contacts under shear
///
/// One header has the interface:
/// @code
/// #include <mixity/mixity.h>
/// mixity::Dataset data = mixity::load_dataset("run.csv", {{"radius", "9.42 mm"}});
/// mixity::FitResult fit = mixity::fit_model(data, "c");
/// // fit.status, fit.parameters[0].value, fit.parameters[0].interval, fit.budget, fit.residuals
/// @endcode
/// See mixity::load_dataset, mixity::fit_model, mixity::FitOptions, mixity::FitResult, mixity::ContactModel.
///
/// It includes no header of the libraries that mixity is built with. InputError is thrown for invalid content of a file,
/// an array or an option; what can fail for valid input has a status or a reason.
#pragma once

#include "base/input_error.h"         // InputError
#include "dataset/arrays.h"           // make_dataset: from arrays
#include "dataset/dataset.h"          // load_dataset, Dataset
#include "dataset/pooled.h"           // load_pooled: from several files
#include "fitting/comparison.h"       // compare_models, per_curve
#include "fitting/fit.h"              // fit_model, FitOptions, FitResult
#include "fitting/prediction.h"       // predict_areas_of: areas predicted by a fit, with errors
#include "mechanics/contact.h"        // Contact: units of dimensionless quantities; JKR, Hertz
#include "mechanics/contact_model.h"  // ContactModel: areas, folds, regime, curve, f(psi)
#include "mechanics/measurement.h"    // phase angle and toughness of a measured point
