// The engine as the Python module mixity._core: arrays in, results as JSON and arrays out. The Python interface is in
// mixity/*.py.
#include "base/files.h"
#include "base/number_text.h"
#include "cli/program.h"
#include "dataset/table/columns.h"
#include "python/bindings.h"
#include "python/keyword_words.h"

NB_MODULE(_core, m) {
  m.doc() = "The engine of mixity.";
  nb::set_leak_warnings(false);  // what a program still holds when it ends is no leak
  static PyObject *input_error, *missing_column;
  nb::exception<mixity::InputError> of_input(m, "InputError", PyExc_ValueError);
  of_input.doc() = "What mixity does not take, with the sentence that says why and what helps. A ValueError.";
  nb::exception<mixity::MissingColumn> of_column(m, "MissingColumn", of_input.ptr());
  of_column.doc() = "The InputError of a table without a column that is needed.";
  input_error = of_input.ptr();
  missing_column = of_column.ptr();
  nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (const mixity::MissingColumn& error) {
      PyErr_SetString(missing_column, error.text(mixity::in_keywords).c_str());
    } catch (const mixity::InputError& error) {
      PyErr_SetString(input_error, error.text(mixity::in_keywords).c_str());
    } catch (const mixity::OutputError& error) {
      PyErr_SetString(PyExc_OSError, error.text(mixity::in_keywords).c_str());
    } catch (const mixity::Interrupted&) {
      if (!PyErr_Occurred()) PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
  });
  mixity::bind_mechanics(m);
  mixity::bind_data(m);
  mixity::bind_fits(m);
  mixity::bind_studies(m);
  mixity::bind_reports(m);
  m.def("program", [](const std::vector<std::string>& words) {
    const nb::gil_scoped_release released;
    return mixity::cli::run_program(words);
  });
  m.def("rounded", &mixity::rounded, nb::arg("value"), nb::arg("digits"));
  m.def("version", [] { return MIXITY_VERSION; });
}
